"""From a folder with ``experiment.toml`` and CSV files to a ``DataSet``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from pam_cosim.errors import InputError, ModelError
from pam_cosim.measurement.cuts import Overrides
from pam_cosim.measurement.data_set import DataSet, Run
from pam_cosim.measurement.declared_runs import (
    check_branches,
    check_runs,
    parameters_of_run,
    runs_of_table,
)
from pam_cosim.measurement.experiment import FILE_NAME, ExperimentFile, read_experiment
from pam_cosim.measurement.experiment_tables import Value
from pam_cosim.measurement.input_maps import input_maps, with_names_of_maps
from pam_cosim.measurement.noise import complete_noise
from pam_cosim.measurement.parameters import free_parameter, known_values
from pam_cosim.measurement.paths import file_inside
from pam_cosim.measurement.resampling import with_noise_of_means
from pam_cosim.measurement.signal import StatedSignal
from pam_cosim.model.input_map import InputMap
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_file, is_fmu
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
    base = model or _model_of(document, benches)
    interface = describe(base) if model else _interface(document, base, describe)
    maps = input_maps(document, interface)
    name = base
    if maps:
        if with_maps is None or is_fmu(base):
            raise _no_map(document, maps[0])
        name = with_maps(base, maps)
        interface = describe(name)
    document = with_names_of_maps(document, interface)
    data = _converted(document, interface, overrides or Overrides())
    return replace(data, model=name, bench=_bench(document) or name, unmapped=base if maps else "")


def _converted(document: ExperimentFile, interface: Interface, overrides: Overrides) -> DataSet:
    """The data set in the units of its bench, with the noise of its signals; its model is not named yet."""
    content = document.content
    title = content.title or document.file.parent.resolve().name
    stated = known_values(document, interface, content.parameters, "parameters")
    free = {
        one: free_parameter(document, interface, one, table, stated, "fit")
        for one, table in content.fit.items()
    }
    shared = {one: value for one, value in stated.items() if one not in free}
    _check_signals(document, interface)
    check_runs(document)
    tables = range(len(content.runs))
    of_runs = [
        one for index in tables for one in parameters_of_run(document, interface, index, stated)
    ]
    read = [runs_of_table(document, interface, index, shared, overrides) for index in tables]
    runs = tuple(run for several in read for run in several)
    overrides.check(title, [run.name for run in runs])
    check_branches(document, interface, read)
    signals = with_noise_of_means(_signals(document, interface, runs), runs)
    return DataSet(
        folder=document.file.parent,
        title=title,
        model=interface.model,
        bench="",
        signals=complete_noise(signals, runs),
        parameters=shared,
        fit=free | {one.name: one for one in of_runs},
        runs=runs,
        excluded=tuple(content.effects.exclude),
        expected=tuple(content.effects.expect),
    )


def _no_map(document: ExperimentFile, one: InputMap) -> InputError:
    message = f"{one.name} is an input, and an FMU takes no parameters in its place: name a bench or a Modelica model"
    return document.error(
        message, *(("fit", one.name) if one.raw is None else ("columns", one.name, "fit"))
    )


def _experiment_file(folder: Path) -> Path:
    try:
        if folder.is_dir():
            return folder / FILE_NAME
        if folder.is_file() and folder.suffix == ".toml":
            return folder
    except (OSError, ValueError) as error:
        raise InputError(f"the folder cannot be read: {error}", shown(folder)) from None
    raise InputError(
        f"a data set is a folder with {FILE_NAME} and CSV files; this is not one", folder
    )


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


def _interface(
    document: ExperimentFile, name: str, describe: Callable[[str], Interface]
) -> Interface:
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


def _signals(
    document: ExperimentFile, interface: Interface, runs: tuple[Run, ...]
) -> dict[str, StatedSignal]:
    """Declared signals in the file's order, then measured columns that are not declared.

    Where some signals are declared, the others are shown but not fitted: a column may be in a file for other reasons.
    """
    declared = document.content.signals
    for name in declared:
        if not any(run.sample_count(name) for run in runs):
            raise document.error(
                f"no run has a sample of the signal {shown(name)}", "signals", name
            )
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
            f"sigma_of_reading of {name} is a share of the reading, below 1",
            "signals",
            name,
            "sigma_of_reading",
        )
    return StatedSignal(
        name, unit, sigma, repeatability=repeatability or 0.0, sigma_of_reading=growth
    )


def _deviation(
    document: ExperimentFile, name: str, key: str, value: Value | None, unit: str
) -> float | None:
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
        raise document.error(
            f"{key} of {name} is smaller than that of any instrument: {shown(value)}", *path
        )
    return deviation
