"""From a folder with ``experiment.toml`` and CSV files to a ``DataSet``."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from pam_cosim.errors import InputError, ModelError
from pam_cosim.measurement.cuts import Cut, Overrides, cut_run
from pam_cosim.measurement.data_set import Along, DataSet, FreeParameter, Run, StatedSignal
from pam_cosim.measurement.experiment import FILE_NAME, ExperimentFile, KeyPath, RunTable, Value, read_experiment
from pam_cosim.measurement.input_maps import input_maps, with_names_of_maps
from pam_cosim.measurement.noise import complete_noise
from pam_cosim.measurement.parameters import free_parameter, known_values
from pam_cosim.measurement.paths import file_inside
from pam_cosim.measurement.pieces import pieces_of
from pam_cosim.measurement.points import Points
from pam_cosim.measurement.read_run import read_points, read_run
from pam_cosim.measurement.read_start import with_start
from pam_cosim.measurement.resampling import with_noise_of_means
from pam_cosim.model.input_map import InputMap
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import BRANCH, is_file, is_fmu
from pam_cosim.units import LARGEST, UnitError, parse_quantity
from pam_cosim.wording import did_you_mean, shown


def read_data_set(
    folder: Path,
    describe: Callable[[str], Interface],
    *,
    model: str | None = None,
    benches: Callable[[], Sequence[str]] = tuple,
    with_maps: Callable[[str, Sequence[InputMap]], str] | None = None,
    overrides: Overrides | None = None,
) -> DataSet:
    """Reads a data set, converts it to the units of its bench, and completes the noise of its signals.

    Args:
        folder: the folder, or its ``experiment.toml``.
        describe: gives the interface of a bench by name; raises ``InputError`` when there is none.
        model: read the data for this model instead of the one the file names.
        benches: names to offer where the file names none.
        with_maps: gives the model that has maps of its inputs; None: a map that is fitted is an error.
        overrides: what counts instead of what is stated of single runs.

    Raises:
        InputError: whatever is wrong in the folder, with file, line and column or key.
    """
    document = read_experiment(_experiment_file(Path(folder)))
    name = model or _model_of(document, benches)
    interface = describe(name) if model else _interface(document, name, describe)
    maps = input_maps(document, interface)
    unmapped = name if maps else ""
    if maps:
        if with_maps is None or is_fmu(name):
            raise _no_map(document, maps[0])
        name = with_maps(name, maps)
        interface = describe(name)
    document = with_names_of_maps(document, interface)
    content = document.content
    title = content.title or document.file.parent.resolve().name
    parameters = known_values(document, interface, content.parameters, "parameters")
    shared = [free_parameter(document, interface, one, table, parameters, "fit") for one, table in content.fit.items()]
    free = dict(zip(content.fit, shared, strict=True))
    known = {one: value for one, value in parameters.items() if one not in free}
    _check_signals(document, interface)
    _check_runs(document)
    own = [_own_free(document, interface, index, run, parameters) for index, run in enumerate(content.runs)]
    instead = overrides or Overrides()
    read = [_runs(document, interface, index, run, known, instead) for index, run in enumerate(content.runs)]
    runs = tuple(run for several in read for run in several)
    instead.check(title, [run.name for run in runs])
    _check_branches(document, interface, read)
    return DataSet(
        folder=document.file.parent,
        title=title,
        model=name,
        bench=_bench(document) or name,
        unmapped=unmapped,
        signals=complete_noise(with_noise_of_means(_signals(document, interface, runs), runs), runs),
        parameters=known,
        fit=free | {one.name: one for several in own for one in several},
        runs=runs,
        excluded=tuple(content.effects.exclude),
        expected=tuple(content.effects.expect),
    )


def _no_map(document: ExperimentFile, one: InputMap) -> InputError:
    message = f"{one.name} is an input, and an FMU takes no parameters in its place: name a bench or a Modelica model"
    return document.error(message, *(("fit", one.name) if one.raw is None else ("columns", one.name, "fit")))


def _experiment_file(folder: Path) -> Path:
    try:
        if folder.is_dir():
            return folder / FILE_NAME
        if folder.is_file() and folder.suffix == ".toml":
            return folder
    except (OSError, ValueError) as error:
        raise InputError(f"the folder cannot be read: {error}", shown(folder)) from None
    raise InputError(f"a data set is a folder with {FILE_NAME} and CSV files; this is not one", folder)


def _model_of(document: ExperimentFile, benches: Callable[[], Sequence[str]]) -> str:
    """The bench's name; a ``.mo`` or ``.fmu`` file beside the experiment is meant relative to it."""
    name = document.content.model
    if not name:
        known = ", ".join(benches())
        one_of = f", one of {known}, or a Modelica class, a .mo or an .fmu file" if known else ""
        raise document.error(f'model is missing: name the bench as model = "..."{one_of}', "model")
    return _bench(document)


def _bench(document: ExperimentFile) -> str:
    """The model that the file names; a ``.mo`` or ``.fmu`` file beside the experiment is meant relative to it."""
    name = document.content.model or ""
    return str(file_inside(document, name, "model")) if is_file(name) else name


def _interface(document: ExperimentFile, name: str, describe: Callable[[str], Interface]) -> Interface:
    try:
        return describe(name)
    except InputError as error:
        kind = ModelError if isinstance(error, ModelError) else InputError
        place = document.error(f"the model {shown(name)} cannot be used: {error}", "model")
        raise kind(place.message, place.file, place.line) from None


def _check_signals(document: ExperimentFile, interface: Interface) -> None:
    for name in document.content.signals:
        if name not in interface.outputs:
            message = f"{interface.model} has no output {shown(name)}; {did_you_mean(name, interface.outputs)}"
            raise document.error(message, "signals", name)


def _signals(document: ExperimentFile, interface: Interface, runs: tuple[Run, ...]) -> dict[str, StatedSignal]:
    """Declared signals in the file's order, then measured columns that are not declared.

    Where some signals are declared, the others are shown but not fitted: a column may be in a file for other reasons.
    """
    declared = document.content.signals
    for name in declared:
        if not any(run.sample_count(name) for run in runs):
            raise document.error(f"no run has a sample of the signal {shown(name)}", "signals", name)
    measured = [name for run in runs for name in run.measurements]
    names = dict.fromkeys([*declared, *measured])
    return {name: _signal(document, name, interface.outputs[name].unit) for name in names}


def _signal(document: ExperimentFile, name: str, unit: str) -> StatedSignal:
    declared = document.content.signals
    table = declared.get(name)
    if table is None:
        return StatedSignal(name, unit, fitted=not declared)
    sigma = _deviation(document, name, "sigma", table.sigma, unit)
    repeatability = _deviation(document, name, "repeatability", table.repeatability, unit)
    growth = _deviation(document, name, "sigma_of_reading", table.sigma_of_reading, "1") or 0.0
    if growth and sigma is None:
        message = f"sigma_of_reading of {name} needs sigma, the noise where the reading is zero"
        raise document.error(message, "signals", name, "sigma_of_reading")
    if growth >= 1.0:
        raise document.error(
            f"sigma_of_reading of {name} is a share of the reading, below 1", "signals", name, "sigma_of_reading"
        )
    return StatedSignal(name, unit, sigma, repeatability=repeatability or 0.0, sigma_of_reading=growth)


def _deviation(document: ExperimentFile, name: str, key: str, value: Value | None, unit: str) -> float | None:
    """A standard deviation of a signal [unit]; None: not stated."""
    if value is None:
        return None
    path = ("signals", name, key)
    try:
        deviation = parse_quantity(value, unit, difference=True)
    except UnitError as error:
        raise document.error(f"{key} of {name}: {error}", *path) from None
    if deviation <= 0.0:
        raise document.error(f"{key} of {name} must be greater than zero", *path)
    if deviation < 1 / LARGEST:
        raise document.error(f"{key} of {name} is smaller than that of any instrument: {shown(value)}", *path)
    return deviation


def _check_runs(document: ExperimentFile) -> None:
    """Every file is there and listed once, names differ, and something is left to fit."""
    runs = document.content.runs
    if not any(run.role == "fit" for run in runs):
        raise document.error('no run has role = "fit"; one at least is needed', "runs")
    files: set[Path] = set()
    names: set[str] = set()
    for index, run in enumerate(runs):
        path = ("runs", index, "file")
        file, name = file_inside(document, run.file, *path).resolve(), _name(run.file)
        if file in files:
            raise document.error(f"the file {shown(run.file)} is listed twice", *path)
        if name in names:
            raise document.error(f"two runs would be called {shown(name)}; rename one of the files", *path)
        files.add(file)
        names.add(name)


def _own_free(
    document: ExperimentFile, interface: Interface, index: int, table: RunTable, known: Mapping[str, float]
) -> list[FreeParameter]:
    """What is fitted to one run alone."""
    path, name = ("runs", index, "fit"), _name(table.file)
    for one in table.fit:
        if table.role == "holdout":
            message = f"{one} is free in a run that is never fitted; state its value under [runs.parameters]"
            raise document.error(message, *path, one)
        if one in table.parameters:
            message = f"{one} is free under [runs.fit] and has a value under [runs.parameters]; keep one of them"
            raise document.error(message, *path, one)
        if "@" in name:
            raise document.error(f"the run {shown(name)} has parameters of its own; its name must have no '@'", *path)
    return [free_parameter(document, interface, one, free, known, *path, run=name) for one, free in table.fit.items()]


def _is_static(document: ExperimentFile, table: RunTable) -> bool:
    return (table.kind or document.content.kind) == "static"


def _runs(
    document: ExperimentFile,
    interface: Interface,
    index: int,
    table: RunTable,
    known: Mapping[str, float],
    instead: Overrides,
) -> list[Run]:
    """The run of a recording, or those of the curves of a file of points at rest."""
    own = _own_values(document, interface, index, table)
    values = {name: value for name, value in {**known, **own}.items() if name not in table.fit}
    points: list[Points] = []
    if _is_static(document, table):
        held = {one: value for one, value in values.items() if one in interface.inputs}
        points, files = read_points(document, index, interface, held)
        recording = points[0].recording
    else:
        _check_dynamic(document, table, index)
        recording, files = read_run(document, index, interface)
    for name in recording.inputs:
        if name in values:
            place: KeyPath = ("runs", index, "parameters") if name in own else ("parameters",)
            message = f"{name} is constant here and a column of {shown(table.file)}; keep one of them"
            raise document.error(message, *place, name)
    run = Run(
        name=_name(table.file),
        file=files[0],
        more_files=files[1:],
        role=table.role,
        interpolation=table.interpolation,
        parameters=values,
        time=recording.time,
        inputs=recording.inputs,
        measurements=recording.measurements,
        notes=recording.notes,
        averaged=recording.averaged,
        default_inputs=tuple(n for n in interface.inputs if n not in recording.inputs and n not in values),
    )
    if points:
        every = [_curve(run, one, i == 0) for i, one in enumerate(points)]
        parts = f"holds {len(every)} curves"
    else:
        every = pieces_of(_cut_as_stated(document, index, run), table.gaps or document.content.gaps)
        parts = f"falls into {len(every)} pieces"
    if table.fit and len(every) > 1:
        message = f"{shown(table.file)} {parts}, which have no parameter of their own; free it under [fit]"
        raise document.error(message, "runs", index, "fit")
    return [_begun(document, interface, index, run, one, instead) for one in every]


def _own_values(document: ExperimentFile, interface: Interface, index: int, table: RunTable) -> dict[str, float]:
    """What is stated of one run alone [SI]."""
    path = ("runs", index, "parameters")
    for name in table.parameters:
        if name in document.content.fit:
            message = f"{name} is free under [fit] and cannot have a value of its own in a run"
            raise document.error(message, *path, name)
    return known_values(document, interface, table.parameters, *path)


def _cut_as_stated(document: ExperimentFile, index: int, run: Run) -> Run:
    """The rows of a recording that ``from`` and ``to`` leave."""
    table, ends = document.content.runs[index], dict[str, float]()
    for key, value in (("from", table.begin), ("to", table.end)):
        if value is not None:
            try:
                ends[key] = parse_quantity(value, "s")
            except UnitError as error:
                raise document.error(f"{key}: {error}", "runs", index, key) from None
    try:
        return cut_run(run, Cut(ends.get("from"), ends.get("to")))
    except InputError as error:
        raise document.error(error.message, "runs", index, next(iter(ends), "file")) from None


def _begun(document: ExperimentFile, interface: Interface, index: int, whole: Run, run: Run, instead: Overrides) -> Run:
    """A run, or a piece of one, with its start; cut to other ends than are stated, where that is asked for.

    What is stated of its start does not count where it then begins elsewhere, or is no longer the period that it was.
    """
    mode, cut = instead.start(run), instead.cut(run)
    if mode is not None and run.is_static:
        raise InputError(f"{run.name} holds points at rest, which have no start", run.file)
    if cut is None:
        return with_start(document, interface, index, run, mode)
    made = cut_run(whole if run.name == whole.name else run, cut)
    table = document.content.runs[index]
    periodic = document.content.periodic if table.periodic is None else table.periodic
    elsewhere = made.time[0] != run.time[0] or (bool(periodic) and made.time[-1] != run.time[-1])
    return with_start(document, interface, index, made, mode, anew=bool(elsewhere))


def _curve(run: Run, points: Points, first: bool) -> Run:
    """One curve of a file; the first says how the file was read."""
    recording = points.recording
    unknown = BRANCH in run.default_inputs
    notes = (*run.notes, *(["no direction of a branch is stated: dry friction is left out"] if unknown else []))
    return replace(
        run,
        name=f"{run.name} {points.label}".rstrip(),
        role="holdout" if points.holdout else run.role,
        along=Along(points.along, points.unit),
        time=recording.time,
        inputs=recording.inputs,
        measurements=recording.measurements,
        notes=notes if first else (),
        default_inputs=tuple(name for name in run.default_inputs if name != BRANCH),
    )


def _check_dynamic(document: ExperimentFile, table: RunTable, index: int) -> None:
    for key in ("branch", "hold_out"):
        if getattr(table, key):
            message = f'{key} is for points at rest: state kind = "static", or leave it out'
            raise document.error(message, "runs", index, key)


def _check_branches(document: ExperimentFile, interface: Interface, read: Sequence[Sequence[Run]]) -> None:
    """Where one file tells the direction of its branches, the others do so too."""
    if BRANCH not in interface.inputs:
        return
    static = [(i, runs[0]) for i, runs in enumerate(read) if runs[0].along is not None]
    told = [run for _, run in static if BRANCH in run.inputs]
    for index, run in static:
        if told and BRANCH not in run.inputs and BRANCH not in run.parameters:
            message = f"{shown(run.file.name)} has no column 'branch', and {shown(told[0].file.name)} has a direction"
            hint = 'state branch = "up" or "down", "order" where the rows were taken in their order, or "none"'
            raise document.error(f"{message}; {hint}", "runs", index)


def _name(file: str) -> str:
    return Path(file).with_suffix("").as_posix()
