"""The steps of a study as one function each: read, compare, fit, diagnose, add, simulate, sweep."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from math import prod
from pathlib import Path

import numpy as np

from pam_cosim.catalogue import EffectClass, compose, domain_of, effect_classes
from pam_cosim.catalogue import benches as _benches
from pam_cosim.comparison import Comparison
from pam_cosim.comparison import compare as _compare
from pam_cosim.compiler import read_library
from pam_cosim.compiler.names import last
from pam_cosim.diagnosis import Diagnosis, Message
from pam_cosim.diagnosis import diagnose as _diagnose
from pam_cosim.domain import Domain
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.files import check_writable, make_folder, write_bytes, write_text
from pam_cosim.fitting import Fit, FitOptions, base_parameters
from pam_cosim.fitting import fit as _fit
from pam_cosim.fmu import build_model, read_interface
from pam_cosim.interface import Interface
from pam_cosim.measurement import DataSet, complete_noise, read_data_set
from pam_cosim.products import Product
from pam_cosim.settings import Setting, resolve
from pam_cosim.simulation import Inputs, IsolatedSimulator, Simulator, Trajectory

Paths = Sequence[Path | str]
MOST_STEPS = 10_000_000  # of one run, whose outputs are kept in memory: 80 MB each
MOST_RUNS = 1_000_000  # of one sweep


def describe(model: str, files: Paths = ()) -> Interface:
    """Inputs, outputs and parameters of a model: a bench, a Modelica class, a ``.mo`` or an ``.fmu`` file.

    Raises:
        InputError: there is no such model, or it cannot be compiled.
    """
    return read_interface(build(model, files=files))


def build(
    model: str,
    output: Path | str | None = None,
    *,
    files: Paths = (),
    platforms: Sequence[str] = ("native",),
    fmi: str = "2.0",
    sensitivities: Sequence[str] = (),
) -> Path:
    """Builds an FMU, or finds it in the cache; with ``output`` it is put there.

    ``platforms`` names those that the FMU shall run on: "native", "all", or names such as "x86_64-windows".
    ``fmi`` is the version of the interface, "2.0" or "3.0". For each parameter in ``sensitivities`` the derivatives
    of the outputs with respect to it are outputs too, ``sensitivity.<output>.<parameter>``.
    """
    if output is not None:
        check_writable(Path(output), new_folder=True)
    made = build_model(model, _paths(files), platforms=platforms, fmi=fmi, sensitivities=sensitivities)
    if output is None:
        return made
    target = Path(output)
    make_folder(target.parent)
    write_bytes(target, made.read_bytes())
    return target


def opened(
    model: str, files: Paths = (), free: Iterable[str] = (), timeout: float | None = None
) -> Simulator | IsolatedSimulator:
    """A model ready to run; an FMU of somebody else's runs in a process of its own, which it may crash.

    A Modelica model tells its sensitivities to the ``free`` parameters. An FMU that makes no progress for ``timeout``
    seconds is ended (None: the default of ``IsolatedSimulator``).
    """
    if model.endswith(".fmu"):
        return IsolatedSimulator(build(model, files=files), timeout)
    return Simulator(build_model(model, _paths(files), sensitivities=tuple(free), where_smooth=True))


def benches(files: Paths = ()) -> list[str]:
    """Names of the benches of the library, and of those among ``files``."""
    return [last(bench) for bench in _benches(read_library(files=_paths(files)))]


def read(folder: Path | str, *, model: str | None = None, files: Paths = ()) -> DataSet:
    """Reads a data set and checks it against its bench (or against ``model``).

    Raises:
        InputError: with file, line and column of what cannot be used.
    """
    known: dict[str, Interface] = {}

    def described(name: str) -> Interface:
        return known.setdefault(name, describe(name, files))

    data = read_data_set(Path(folder), described, model=model, benches=lambda: benches(files))
    return replace(data, domain=_domain(data.model, known[data.model], files))


def _domain(model: str, interface: Interface, files: Paths) -> Domain:
    """The words of the model's field; an FMU says what class it was made from."""
    sources = _paths(files) + ([Path(model)] if model.endswith(".mo") else [])
    return domain_of(read_library(files=sources), interface.model if model.endswith(".fmu") else model)


def compare(
    data: DataSet,
    model: str | None = None,
    parameters: Mapping[str, Setting] | None = None,
    *,
    files: Paths = (),
    timeout: float | None = None,
) -> Comparison:
    """Simulates every run of ``data`` with ``model`` (default: its bench) and scores the differences.

    ``parameters`` are further values and ``timeout`` a limit, as in ``simulate``.
    """
    with opened(model or data.model, files, timeout=timeout) as simulator:
        return _compare(simulator, complete_noise(data), resolve(parameters or {}, simulator.interface))


def fit(
    data: DataSet,
    model: str | None = None,
    *,
    method: str = "least-squares",
    parameters: Mapping[str, Setting] | None = None,
    files: Paths = (),
    progress: Callable[[int, float], None] | None = None,
    timeout: float | None = None,
) -> Fit:
    """Fits what the data set leaves free.

    Args:
        data: the measurement.
        model: default: the bench of the data set.
        method: "least-squares" from the start values; "multi-start": also from points spread over the bounds;
            "particle-swarm": from the best particle of a swarm over the bounds (Dzahir and Yamamoto 2019), which
            ``Fit.search`` keeps as the swarm left it.
        parameters: further values to use, as in ``simulate``.
        files: further Modelica files.
        progress: called with the number of simulations and the reduced chi-square.
        timeout: as in ``simulate``.

    Raises:
        InputError: unknown model, parameter or method; nothing to fit.
        SimulationFailure: no start value can be simulated.
    """
    with opened(model or data.model, files, data.fit, timeout) as simulator:
        free = base_parameters(data, simulator.interface)
        if not free:
            raise InputError("nothing to fit: name the free parameters under [fit]", data.folder / "experiment.toml")
        data, fixed = complete_noise(data), resolve(parameters or {}, simulator.interface)
        return _fit(simulator, data, free, fixed=fixed, options=FitOptions(method), progress=progress)


def diagnose(
    data: DataSet,
    model: str | None = None,
    *,
    files: Paths = (),
    say: Callable[[Message], None] = lambda message: None,
    workers: int | None = None,
    explain: bool = True,
) -> Diagnosis:
    """Finds the effect that ``model`` (default: the bench of the data set) lacks; see ``diagnosis.diagnose``.

    ``say`` is told each step and each result as a line of text (``print`` will do) that knows which of them it is.
    """
    return _diagnose(data, model, files=_paths(files), say=say, workers=workers, explain=explain)


def draw(product: Product, path: Path | str) -> None:
    """Draws a product of a study as PNG: its signals over time, its ledger, or the error coming down.

    Raises:
        InputError: there is nothing to draw, or the file cannot be written.
    """
    from pam_cosim.reporting import draw as _draw  # half a second for matplotlib, which no worker needs

    _draw(product, path)


def effects(files: Paths = ()) -> list[EffectClass]:
    """The catalogue: every effect of the library and of ``files``."""
    return list(effect_classes(read_library(files=_paths(files))))


def add(names: Sequence[str], to: str, output: Path | str | None = None, *, files: Paths = ()) -> str:
    """The Modelica text of ``to`` with the named effects; written to ``output`` if given.

    Raises:
        InputError: an unknown effect, or one that finds no place in the model.
    """
    extra = _paths(files) + ([Path(to)] if to.endswith(".mo") else [])
    tree = read_library(files=extra)
    name = Path(output).stem if output else None
    composition = compose(tree, to, names, name, files=extra)
    if composition is None:
        raise InputError(f"{to} has no place for {', '.join(names)}")
    if output:
        write_text(Path(output), composition.text)
    return composition.text


def simulate(
    model: str,
    parameters: Mapping[str, Setting] | None = None,
    inputs: Inputs | None = None,
    *,
    stop_time: float | None = None,
    interval: float | None = None,
    files: Paths = (),
    timeout: float | None = None,
) -> Trajectory:
    """One run of a model.

    Args:
        model: a bench, a Modelica class, a ``.mo`` or an ``.fmu`` file.
        parameters: by name, what differs from the model's defaults: parameters, inputs that are held constant, start
            values; a number [SI] or a text with a unit such as "207 kPa".
        inputs: over time.
        stop_time: [s]; default: the last time of ``inputs``, or the model's own.
        interval: [s] between outputs; default: the model's own.
        files: further Modelica files.
        timeout: [s]; an FMU that makes no progress for so long is ended, and its run fails; default: a minute.

    Raises:
        InputError: an unknown model or name, a value that cannot be used, an input given both ways.
        SimulationFailure: the run did not reach its end.
    """
    with opened(model, files, timeout=timeout) as simulator:
        times = output_times(simulator.interface, inputs, stop_time, interval)
        return simulator.run(times, parameters=resolve(parameters or {}, simulator.interface), inputs=inputs)


def output_times(
    interface: Interface, inputs: Inputs | None, stop_time: float | None = None, interval: float | None = None
) -> np.ndarray:
    """(n,) [s]: from the first input sample (or zero) to the last (or the model's default stop time)."""
    start = float(inputs.time[0]) if inputs is not None else 0.0
    end = stop_time if stop_time is not None else float(inputs.time[-1]) if inputs is not None else interface.stop_time
    step = interval or interface.interval or (end - start) / 1000
    if not end > start or not step > 0:
        raise InputError(f"the run must end after its start: from {start:g} s to {end:g} s in steps of {step:g} s")
    steps = (end - start) / step
    if not steps <= MOST_STEPS:
        span = f"from {start:g} s to {end:g} s in steps of {step:g} s"
        raise InputError(f"{span} are {steps:.3g} rows; {MOST_STEPS} at most can be kept")
    return start + (end - start) * np.linspace(0, 1, max(2, round(steps) + 1))


@dataclass(frozen=True)
class SweepPoint:
    """One simulation of a sweep: what was varied [SI], and its trajectory or what went wrong."""

    parameters: dict[str, float]
    trajectory: Trajectory | None
    failure: str | None = None


def sweep(
    model: str,
    vary: Mapping[str, Iterable[Setting]],
    *,
    parameters: Mapping[str, Setting] | None = None,
    inputs: Inputs | None = None,
    stop_time: float | None = None,
    files: Paths = (),
    progress: Callable[[int, int], None] | None = None,
    timeout: float | None = None,
) -> list[SweepPoint]:
    """Simulates every combination of what is varied; a run that fails is reported and the others go on.

    Args:
        model: as in ``simulate``.
        vary: values by name of a parameter, an input that is held constant or a start value, as in ``simulate``.
        parameters: of every run, as in ``simulate``.
        inputs: of every run.
        stop_time: of every run [s].
        files: further Modelica files.
        timeout: of every run, as in ``simulate``.
        progress: called with the number of runs done and of all runs.

    Raises:
        InputError: as ``simulate``; a name that is both varied and set.
    """
    points = []
    with opened(model, files, timeout=timeout) as simulator:
        fixed = resolve(parameters or {}, simulator.interface)
        grid = [resolve(values, simulator.interface) for values in _combinations(vary, fixed)]
        times = output_times(simulator.interface, inputs, stop_time)
        for i, varied in enumerate(grid):
            try:
                points.append(SweepPoint(varied, simulator.run(times, parameters=fixed | varied, inputs=inputs)))
            except SimulationFailure as failure:
                points.append(SweepPoint(varied, None, str(failure)))
            if progress is not None:
                progress(i + 1, len(grid))
    return points


def _combinations(vary: Mapping[str, Iterable[Setting]], fixed: Mapping[str, float]) -> list[dict[str, Setting]]:
    values = {name: _several(name, given) for name, given in vary.items()}
    for name in values:
        if name in fixed:
            raise InputError(f"'{name}' is both set and varied; keep one of them")
    count = prod(len(given) for given in values.values())
    if count > MOST_RUNS:
        raise InputError(f"these are {count} combinations; a sweep has {MOST_RUNS} at most")
    return [dict(zip(values, chosen, strict=True)) for chosen in product(*values.values())]


def _several(name: str, given: Iterable[Setting]) -> list[Setting]:
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise InputError(f"'{name}' is varied: give a list of values, not one")
    return list(given)


def _paths(files: Paths) -> list[Path]:
    return [Path(f) for f in files]
