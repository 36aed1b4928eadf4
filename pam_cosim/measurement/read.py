"""From a folder with ``experiment.toml`` and CSV files to a ``DataSet``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from pam_cosim.errors import InputError, ModelError
from pam_cosim.measurement.cuts import Overrides
from pam_cosim.measurement.data_set import FILE_NAME, DataSet, Run
from pam_cosim.measurement.declared_runs import (
    check_branches,
    check_runs,
    parameters_of_run,
    runs_of_table,
)
from pam_cosim.measurement.experiment import read_experiment
from pam_cosim.measurement.experiment_tables import Experiment, SignalTable
from pam_cosim.measurement.input_maps import input_maps, with_names_of_maps
from pam_cosim.measurement.noise import complete_noise
from pam_cosim.measurement.parameters import free_parameter, known_values
from pam_cosim.measurement.place import Stated
from pam_cosim.measurement.resampling import with_noise_of_means
from pam_cosim.measurement.signal import StatedSignal
from pam_cosim.model.input_map import InputMap
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_file, is_fmu
from pam_cosim.units import LARGEST
from pam_cosim.wording import shown


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
    experiment = read_experiment(_experiment_file(Path(folder)))
    base = model or _model_of(experiment, benches)
    interface = describe(base) if model else _interface(experiment, base, describe)
    if experiment.pressures is not None:
        interface = interface.with_pressures(experiment.pressures)
    maps = input_maps(experiment, interface)
    name = base
    if maps:
        if with_maps is None or is_fmu(base):
            raise _no_map(experiment, maps[0])
        name = with_maps(base, maps)
        interface = describe(name)
    data = _converted(with_names_of_maps(experiment, interface), interface, overrides)
    bench = _bench(experiment) or name
    return replace(data, model=name, bench=bench, unmapped=base if maps else "")


def _converted(
    experiment: Experiment, interface: Interface, overrides: Overrides | None
) -> DataSet:
    """The data set in the units of its bench, with the noise of its signals; its model is not named yet."""
    overrides = overrides or Overrides()
    folder = experiment.at().file.parent
    title = experiment.title or folder.resolve().name
    stated = experiment.parameters
    values = known_values(interface, stated)
    free = {
        name: free_parameter(interface, name, table, stated)
        for name, table in experiment.fit.items()
    }
    shared = {name: value for name, value in values.items() if name not in free}
    for name, signal in experiment.signals.items():
        if name not in interface.outputs:
            raise signal.error(interface.unknown(name, "output", interface.outputs))
    tables = experiment.full_runs()
    check_runs(tables, experiment)
    of_runs = [
        parameter for table in tables for parameter in parameters_of_run(interface, table, stated)
    ]
    read = [runs_of_table(interface, table, stated, shared, overrides) for table in tables]
    runs = tuple(run for runs_of_file in read for run in runs_of_file)
    overrides.check(title, [run.name for run in runs])
    check_branches(interface, tables, read)
    signals = with_noise_of_means(_signals(experiment, interface, runs), runs)
    return DataSet(
        folder=folder,
        title=title,
        model=interface.model,
        bench="",
        signals=complete_noise(signals, runs),
        parameters=shared,
        fit=free | {parameter.name: parameter for parameter in of_runs},
        runs=runs,
        excluded=tuple(experiment.effects.exclude),
        expected=tuple(experiment.effects.expect),
    )


def _no_map(experiment: Experiment, input_map: InputMap) -> InputError:
    message = f"{input_map.name} is an input, and an FMU has no parameters for it: name a bench or a Modelica model"
    if input_map.raw is not None:
        return experiment.columns[input_map.name].error(message, "fit")
    return (experiment.at("fit") / input_map.name).error(message)


def _experiment_file(folder: Path) -> Path:
    try:
        if folder.is_file() and folder.suffix == ".toml":
            return folder
        if folder.is_dir():
            if (folder / FILE_NAME).exists():
                return folder / FILE_NAME
            message = f"there is no {FILE_NAME} among the files of this folder; 'pam-cosim new NEW-FOLDER RECORDINGS'"
            page = "'pam-cosim workbench NEW-FOLDER' does so on a page"
            raise InputError(f"{message} drafts a data set, {page}", folder)
    except (OSError, ValueError) as error:
        raise InputError(f"the folder cannot be read: {error}", shown(folder)) from None
    raise InputError(
        f"a data set is a folder with {FILE_NAME} and CSV files; this is not one", folder
    )


def _model_of(experiment: Experiment, benches: Callable[[], Sequence[str]]) -> str:
    """The bench's name."""
    if not experiment.model:
        names = ", ".join(benches())
        one_of = f", one of {names}, or a Modelica class, a .mo or an .fmu file" if names else ""
        raise experiment.error(
            f'model is missing: name the bench as model = "..."{one_of}', "model"
        )
    return _bench(experiment)


def _bench(experiment: Experiment) -> str:
    """The model that the file names; a ``.mo`` or ``.fmu`` file in the folder of the experiment is relative to it."""
    name = experiment.model or ""
    return str(experiment.at("model").file_inside(name)) if is_file(name) else name


def _interface(
    experiment: Experiment, name: str, describe: Callable[[str], Interface]
) -> Interface:
    try:
        return describe(name)
    except InputError as error:
        kind = ModelError if isinstance(error, ModelError) else InputError
        place = experiment.error(f"the model {shown(name)} cannot be used: {error}", "model")
        raise kind(place.message, place.file, place.line) from None


def _signals(
    experiment: Experiment, interface: Interface, runs: tuple[Run, ...]
) -> dict[str, StatedSignal]:
    """Declared signals in the file's order, then measured columns that are not declared.

    Where some signals are declared, the others are shown but not fitted: a column may be in a file for other reasons.
    """
    declared = experiment.signals
    for name, table in declared.items():
        if not any(run.sample_count(name) for run in runs):
            raise table.error(f"no run has a sample of the signal {shown(name)}")
    measured = [name for run in runs for name in run.measurements]
    units = {n: interface.outputs[n].unit for n in dict.fromkeys([*declared, *measured])}
    return {
        name: _signal(name, unit, declared[name])
        if name in declared
        else StatedSignal(name, unit, fitted=not declared)
        for name, unit in units.items()
    }


def _signal(name: str, unit: str, table: SignalTable) -> StatedSignal:
    sigma = _deviation(name, table.sigma, unit)
    repeatability = _deviation(name, table.repeatability, unit) or 0.0
    growth = _deviation(name, table.sigma_of_reading, "1") or 0.0
    if growth and sigma is None:
        message = f"sigma_of_reading of {name} needs sigma, the noise where the reading is zero"
        raise table.error(message, "sigma_of_reading")
    if growth >= 1.0:
        message = f"sigma_of_reading of {name} is a share of the reading, below 1"
        raise table.error(message, "sigma_of_reading")
    return StatedSignal(name, unit, sigma, repeatability=repeatability, sigma_of_reading=growth)


def _deviation(name: str, stated: Stated | None, unit: str) -> float | None:
    """A standard deviation of a signal [unit]; None: not stated."""
    if stated is None:
        return None
    subject = f"{stated.place.keys[-1]} of {name}"
    deviation = stated.above_zero(unit, subject, difference=True)
    if deviation < 1 / LARGEST:
        raise stated.place.error(
            f"{subject} is smaller than that of any instrument: {shown(stated.value)}"
        )
    return deviation
