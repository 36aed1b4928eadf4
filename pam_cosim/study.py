"""The steps of a study as one function each: read, compare, fit, diagnose, add, simulate, sweep."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from pam_cosim.catalogue import Composition, EffectClass, RigPart, domain_of, effect_classes, put_together
from pam_cosim.catalogue import benches as _benches
from pam_cosim.catalogue import rig_parts as _rig_parts
from pam_cosim.comparison import Comparison
from pam_cosim.comparison import compare as _compare
from pam_cosim.compiler import read_library
from pam_cosim.compiler.names import last
from pam_cosim.counts import checked_seed, checked_starts, checked_workers
from pam_cosim.diagnosis import Check, Diagnosis, Listener, Message
from pam_cosim.diagnosis import check as _check
from pam_cosim.diagnosis import diagnose as _diagnose
from pam_cosim.domain import Domain
from pam_cosim.drafting import NewDataSet, Wishes, draft
from pam_cosim.errors import InputError
from pam_cosim.files import check_writable, write_text
from pam_cosim.fitted_model import (
    FittedModel,
    compose_fitted,
    fitted_model,
    judged_data,
    read_fitted_model,
    with_own_values,
)
from pam_cosim.fitting import (
    Fit,
    FitOptions,
    Profiles,
    Progress,
    base_parameters,
    estimated_starts,
    runs_without_start,
    starts_are_open,
    with_free,
    with_starts,
)
from pam_cosim.fitting import fit as _fit
from pam_cosim.fitting import profile as _profile
from pam_cosim.fmu import read_interface
from pam_cosim.interface import Interface, Variable
from pam_cosim.mapped_model import mapped_model
from pam_cosim.measurement import DataSet, Moment, complete_noise, overrides_of, read_data_set
from pam_cosim.models import Paths, as_paths, opened
from pam_cosim.models import build as build
from pam_cosim.models import describe as describe
from pam_cosim.names import START_VALUES, is_fmu, is_ratio, parameter_of, sources_of
from pam_cosim.products import Product
from pam_cosim.settings import Setting, resolve, value_of
from pam_cosim.simulation import Inputs, Trajectory
from pam_cosim.simulation.fmpy_engine import run_with_fmpy
from pam_cosim.sources import Source, inputs_of
from pam_cosim.sweeps import Plan, Sweep, design_of, make_sweep, read_scalars
from pam_cosim.sweeps.patterns import INPUTS, Pattern, read_patterns, varies_inputs
from pam_cosim.units import UnitError, seconds
from pam_cosim.wording import did_you_mean

MOST_STEPS = 10_000_000  # of one run, whose outputs are kept in memory: 80 MB each
ENGINES = ("own", "fmpy")


def benches(files: Paths = ()) -> list[str]:
    """Names of the benches of the library, and of those among ``files``."""
    return [last(bench) for bench in _benches(read_library(files=as_paths(files)))]


def read(
    folder: Path | str,
    *,
    model: str | None = None,
    files: Paths = (),
    roles: Mapping[str, str] | None = None,
    cuts: Mapping[str, Sequence[Moment]] | None = None,
    starts: Mapping[str, str] | None = None,
) -> DataSet:
    """Reads a data set and checks it against its bench (or against ``model``).

    ```python
    data = pam.read("my-rig", cuts={"run-03": ("2.5 s", None)}, starts={"run-03": "estimated"})
    ```

    Args:
        folder: of the data set; or a saved diagnosis, fit or comparison (``.npz``): the data set as that judged it,
            without the samples that it set aside.
        model: default: the bench of the data set.
        files: further Modelica files.
        roles: "fit" or "holdout" by run, where it shall be another one than the data set says.
        cuts: the first and the last time of a run, by run, instead of ``from`` and ``to`` of the data set: [s] of the
            file's own clock or texts with a unit; None: as it was recorded. Where it begins elsewhere then, its start
            is chosen anew.
        starts: "rest", "steady", "measured" or "estimated" by run, where it shall begin otherwise than the data set
            says.

    Raises:
        InputError: with file, line and column of what cannot be used; no such run, role or start; nothing is left.
    """
    described = _described(files)
    overrides = overrides_of(cuts, starts)
    if Path(folder).suffix.lower() == ".npz":
        if cuts or starts:
            raise InputError("what was judged keeps its ends and starts; cut the data set that it is of", folder)
        data = judged_data(Path(folder))
        data = replace(data, model=model or data.model)
    else:
        data = read_data_set(
            Path(folder),
            described,
            model=model,
            benches=lambda: benches(files),
            with_maps=lambda base, maps: mapped_model(base, described(base), maps, as_paths(files)),
            overrides=overrides,
        )
    data = replace(data.with_roles(roles or {}), domain=_domain(data.model, described(data.model), files))
    return _for_model(data, model, files)


def _for_model(data: DataSet, model: str | None, files: Paths) -> DataSet:
    """The data set for a model: values that a Modelica model of another name states stand before starts of a fit."""
    if (
        model in (None, data.bench, data.unmapped)
        or not data.bench
        or is_fmu(model)
        or all(f.start is None for f in data.fit.values())
    ):
        return data
    return with_own_values(data, model, as_paths(files))


def _described(files: Paths) -> Callable[[str], Interface]:
    """Gives the interface of a model by its name, and builds each but once."""
    return cache(lambda name: describe(name, files))


def _domain(model: str, interface: Interface, files: Paths) -> Domain:
    """The words of the model's field; an FMU says what class it was made from."""
    sources = sources_of(as_paths(files), model)
    return domain_of(read_library(files=sources), interface.model if is_fmu(model) else model)


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
    name, data = data.model_for(model), _for_model(data, model, files)
    interface = describe(name, files)
    values = _of_runs(parameters or {}, data, interface)
    data = begun_data(data, name, values, files, timeout)
    with opened(name, files, [START_VALUES] * data.estimates_starts, timeout) as simulator:
        starts = estimated_starts(simulator, data, runs_without_start(data, values, interface), values)
        return _compare(simulator, data, values | {name: e.value for name, e in starts.items()})


def begun_data(
    data: DataSet,
    model: str,
    values: Mapping[str, float] | None = None,
    files: Paths = (),
    timeout: float | None = None,
) -> DataSet:
    """The data set, with its noise, where every run says how it begins.

    Args:
        data: the measurement.
        model: what it is held against.
        values: by name [SI].
        files: further Modelica files.
        timeout: as in ``simulate``.
    """
    data = complete_noise(data)
    if not starts_are_open(data):
        return data
    with opened(model, files, timeout=timeout) as simulator:
        return with_starts(simulator, data, values)


def _of_runs(parameters: Mapping[str, Setting], data: DataSet, interface: Interface) -> dict[str, float]:
    """Values by name [SI], of all runs or of one: "load.m", "load.m@run-01"."""
    values: dict[str, float] = {}
    for name, value in parameters.items():
        parameter, at, run = name.rpartition("@")
        if at and parameter in interface.settable:
            if run not in [r.name for r in data.runs]:
                known = [r.name for r in data.runs]
                raise InputError(
                    f"{data.title} has no run '{run}', of which '{name}' would be; {did_you_mean(run, known)}"
                )
            values[name] = resolve({parameter: value}, interface)[parameter]
        elif is_ratio(name) and parameter_of(name) in interface.settable:
            values[name] = value_of(value, Variable(name, "1"))
        else:
            values |= resolve({name: value}, interface)
    return values


def fit(
    data: DataSet,
    model: str | None = None,
    *,
    method: str = "least-squares",
    starts: int = 0,
    free: Sequence[str] | None = None,
    start: Mapping[str, Setting] | None = None,
    parameters: Mapping[str, Setting] | None = None,
    files: Paths = (),
    progress: Progress | None = None,
    timeout: float | None = None,
    resume: Path | str | None = None,
) -> Fit:
    """Fits what the data set leaves free.

    Args:
        data: the measurement.
        model: default: the bench of the data set.
        method: "least-squares" from the start values; "multi-start": also from points spread over the bounds;
            "differential-evolution": from the best point of that search; "particle-swarm": from the best particle of a
            swarm over the bounds (Dzahir and Yamamoto 2019). ``Fit.search`` keeps what such a search found by itself.
        starts: points spread over the bounds that "multi-start" follows, each to its end; default: a few of 16.
        free: names of what is fitted, instead of all that the data set leaves free: some of these, or parameters for
            which the model itself states bounds, such as those of an effect. The others are held where they start.
        start: where parameters start, or are held, by name; a number [SI] or a text with a unit.
        parameters: further values to use, as in ``simulate``.
        files: further Modelica files.
        progress: called after each simulation with the ``Standing``, which prints itself: ``print`` will do.
        timeout: as in ``simulate``.
        resume: a file that keeps every simulation's outcome. The same call goes on where the last one was interrupted
            and ends as it would have; the file is made where it is not there.

    Raises:
        InputError: unknown model, parameter or method; nothing to fit; ``resume`` keeps another fit.
        SimulationFailure: no start value can be simulated.
    """
    if starts and method != "multi-start":
        raise InputError(f"starts are for the method multi-start, not for {method}")
    checked_starts(starts)
    data = _freed(data, model, free, start, files)
    fixed = resolve(parameters or {}, describe(data.model_for(model), files))
    data = begun_data(data, data.model_for(model), fixed, files, timeout)
    with opened(data.model_for(model), files, data.differentiated, timeout) as simulator:
        chosen = base_parameters(data, simulator.interface)
        if not chosen:
            raise InputError("nothing to fit: name the free parameters under [fit]", data.folder / "experiment.toml")
        options, kept = FitOptions(method, starts=starts), Path(resume) if resume is not None else None
        return _fit(simulator, data, chosen, fixed=fixed, options=options, progress=progress, resume=kept)


def _freed(
    data: DataSet,
    model: str | None,
    free: Sequence[str] | None,
    start: Mapping[str, Setting] | None,
    files: Paths,
) -> DataSet:
    """The data set with other free parameters, or starts, where they are asked for."""
    data = _for_model(data, model, files)
    if free is None and not start:
        return data
    interface = describe(data.model_for(model), files)
    return with_free(data, interface, free, _of_runs(start or {}, data, interface))


def profile(
    data: DataSet,
    fit: Fit,
    model: str | None = None,
    *,
    parameters: Mapping[str, Setting] | None = None,
    files: Paths = (),
    progress: Progress | None = None,
    timeout: float | None = None,
) -> Profiles:
    """How well the data determine each parameter of a fit: its profile likelihood, with a sentence for each.

    Args:
        data: what was fitted to.
        fit: what ``fit`` returned.
        model: as for ``fit``.
        parameters: as for ``fit``.
        files: as for ``fit``.
        progress: as for ``fit``.
        timeout: as for ``fit``.

    Raises:
        InputError: as ``fit``.
    """
    fixed = resolve(parameters or {}, describe(data.model_for(model), files))
    data = begun_data(data, data.model_for(model), fixed, files, timeout)
    with opened(data.model_for(model), files, data.differentiated, timeout) as simulator:
        return _profile(simulator, data, fit, fixed=fixed, progress=progress)


def diagnose(
    data: DataSet,
    model: str | None = None,
    *,
    files: Paths = (),
    say: Callable[[Message], None] = lambda message: None,
    progress: Listener | None = None,
    workers: int | None = None,
    explain: bool = True,
    time_limit: Setting | None = None,
    exclude: Sequence[str] = (),
    expect: Sequence[str] = (),
    free: Sequence[str] | None = None,
    start: Mapping[str, Setting] | None = None,
) -> Diagnosis:
    """Finds the effect that ``model`` (default: the bench of the data set) lacks; see ``diagnosis.diagnose``.

    ``say`` is told each step and each result as a line of text (``print`` will do) that knows which of them it is;
    ``progress`` is told the same as data, and the verdict and the ledger as they come: a ``diagnosis.Event`` each.
    ``time_limit`` ([s], or with a unit) ends the search with the best verdict so far, which says what was not tried.
    ``exclude`` and ``expect`` name families or effects that are known not to be missing, or that are likely, with those
    of the data set. ``free`` and ``start`` are as for ``fit``.
    """
    limit, files = _seconds(time_limit, "time limit"), as_paths(files)
    if limit is not None and not limit > 0:
        raise InputError(f"the time limit must be longer than nothing: {time_limit}")
    return _diagnose(
        _freed(data, model, free, start, files),
        model,
        files=files,
        say=say,
        progress=progress,
        workers=checked_workers(workers),
        explain=explain,
        time_limit=limit,
        exclude=tuple(exclude),
        expect=tuple(expect),
    )


def check(
    data: DataSet,
    model: str | None = None,
    *,
    files: Paths = (),
    say: Callable[[Message], None] = lambda message: None,
    workers: int | None = None,
) -> Check:
    """What ``data`` can and cannot tell about ``model`` (default: its bench) before any fit; see ``diagnosis.check``.

    How exactly the free parameters will be known, which families of effects would show and from which strength on,
    which of them would not be told apart, and which further signal or run would help most.
    """
    return _check(data, model, files=as_paths(files), say=say, workers=checked_workers(workers))


def draw(product: Product, path: Path | str) -> None:
    """Draws a product of a study as PNG: its signals over time, its ledger, or the error coming down.

    Raises:
        InputError: there is nothing to draw, or the file cannot be written.
    """
    from pam_cosim.reporting import draw as _draw  # half a second for matplotlib, which no worker needs

    _draw(product, path)


def live() -> Callable[[Any], None]:
    """Something to be told what goes on: ``pam.fit(data, progress=pam.live())``, and so for ``diagnose``.

    In a notebook it draws how things stand: the errors of a fit, the ranking and the verdict of a diagnosis. Elsewhere
    it prints every line.
    """
    from pam_cosim.reporting import Live

    return Live()


def effects(files: Paths = ()) -> list[EffectClass]:
    """The catalogue: every effect of the library and of ``files``."""
    return list(effect_classes(read_library(files=as_paths(files))))


def add(
    what: Sequence[str] | Diagnosis | Fit | Path,
    to: str | None = None,
    output: Path | str | None = None,
    *,
    values: Mapping[str, Setting] | None = None,
    files: Paths = (),
) -> str:
    """The Modelica text of a model with effects, or with what a diagnosis or a fit found; ``output`` is its file.

    ```python
    pam.add(["LinearBladder"], to="Isotonic", output="Better.mo")
    pam.add(pam.diagnose(data), output="Better.mo")  # with the fitted values: compare shows what the verdict said
    ```

    Args:
        what: names of effects, which get their default values; or a product with fitted values, or the file of one:
            a saved diagnosis or fit, or the JSON or the parameters that a command wrote.
        to: the base model: a bench, a Modelica class or a ``.mo`` file. Default: the one that the product is of.
        output: a file that ends in ``.mo``; its name is that of the class.
        values: of parameters, before those of the product: numbers [SI] or texts with a unit.
        files: further Modelica files.

    Raises:
        InputError: an unknown effect, one that finds no place in the model, a value of a parameter that it lacks.
    """
    fitted = _fitted_model(what)
    base = to or fitted.model
    if not base or is_fmu(base):
        raise InputError("effects and values are added to a Modelica model: name it by to")
    ratio = next((parameter_of(one) for one in fitted.effects if is_ratio(one)), None)
    if ratio is not None and not fitted.values:
        raise InputError(f"what is stated of {ratio} is no part of a model: correct it in the data set")
    extra = sources_of(as_paths(files), base)
    name = Path(output).stem if output else None
    parameters = describe(base, files).parameters if fitted.values else ()
    tree = read_library(files=extra)
    fitted = replace(fitted, model=base)
    if values:
        bare = compose_fitted(tree, replace(fitted, values={}), name, parameters, files=extra)
        fitted = replace(fitted, values={**fitted.values, **_resolved(values, bare, files)})
        parameters = (*parameters, *fitted.values)
    composition = compose_fitted(tree, fitted, name, parameters, files=extra)
    if output:
        write_text(Path(output), composition.text)
    return composition.text


def _resolved(values: Mapping[str, Setting], composition: Composition, files: Paths) -> dict[str, float]:
    """Values of parameters of a composed model [SI]."""
    with TemporaryDirectory() as folder:
        file = Path(folder) / f"{composition.name}.mo"
        write_text(file, composition.text)
        interface = describe(str(file), files)
    stray = next((name for name in values if name not in interface.parameters), None)
    if stray is not None:
        raise InputError(f"there is no parameter '{stray}'; {did_you_mean(stray, list(interface.parameters))}")
    return resolve(values, interface)


def _fitted_model(what: Sequence[str] | Diagnosis | Fit | Path) -> FittedModel:
    if isinstance(what, Diagnosis | Fit):
        return fitted_model(what)
    if isinstance(what, Path):
        return read_fitted_model(what)
    return FittedModel("", tuple(what), {})


def rig_parts(files: Paths = ()) -> list[RigPart]:
    """What a bench can be put together from: every part of the library and of ``files``."""
    return list(_rig_parts(read_library(files=as_paths(files))))


def bench(
    pneumatics: str,
    mechanics: str,
    muscle: str | None = None,
    measure: str | Sequence[str] | None = None,
    output: Path | str | None = None,
    *,
    static: bool = False,
    files: Paths = (),
) -> str:
    """The Modelica text of a rig put together from parts; written to ``output`` if given.

    ```python
    pam.bench("regulator", "spring", measure="p, x", output="MyRig.mo")
    run = pam.simulate("MyRig.mo", {"p_set": "300 kPa", "spring.k": "3 N/mm"})
    ```

    Args:
        pneumatics: what feeds the muscle, by its name in ``rig_parts`` or the full name of its class.
        mechanics: what holds its load end, likewise; it says how many muscles there are.
        muscle: likewise; default: the usual one.
        measure: the signals that are read: names, or one text with commas. With several muscles "x" is that of each
            and "x_1" that of the first. Default: what is usual with these parts.
        output: a file that ends in ``.mo``.
        static: for points at rest; an input ``branch`` then tells in which direction they were reached.
        files: further Modelica files with parts of one's own.

    Raises:
        InputError: an unknown part or signal, a signal that is imposed, or parts that do not fit together.
        ModelError: a part is not what its interface asks for.
    """
    name = Path(output).stem if output else None
    rig = put_together(read_library(files=as_paths(files)), pneumatics, mechanics, muscle, measure, name, static)
    if output:
        write_text(Path(output), rig.text)
    return rig.text


def new(
    folder: Path | str,
    recordings: Paths,
    *,
    title: str | None = None,
    model: str | None = None,
    muscle: str | None = None,
    columns: Mapping[str, str] | None = None,
    parameters: Mapping[str, Setting] | None = None,
    recording: Mapping[str, object] | None = None,
    roles: Mapping[str, str] | None = None,
    files: Paths = (),
) -> NewDataSet:
    """Writes a data set from recordings as labs have them, and says what was recognised and what was guessed.

    ```python
    print(pam.new("my-rig", ["data/run-01.csv", "data/run-02.csv"], parameters={"load.m": "2.27 kg"}))
    ```

    The recordings are copied. Columns are recognised by names, units and what the numbers look like; the bench is the
    one that takes and shows most of them, put together from parts where there is none. Every guess is marked in
    ``experiment.toml``.

    Args:
        folder: of the new data set, missing or empty.
        recordings: files, one run each.
        title: default: the folder's name.
        model: the bench; a ``.mo`` or ``.fmu`` file is copied too.
        muscle: one of ``rig_parts``, by name; the bench is then put together.
        columns: names of columns, or formulas, by inputs, outputs or "time".
        parameters: what is known of all runs, with units.
        recording: keys of ``[recording]`` of ``experiment.toml``, as far as files do not show them.
        roles: "fit" or "holdout", by the names of recordings without their endings.
        files: further Modelica files.

    Raises:
        InputError: whatever cannot be used, with file, line and column; nothing is written then.
    """
    stated = {name: str(value) for name, value in (parameters or {}).items()}
    wishes = Wishes(title, model, columns, stated, recording, muscle, roles)
    paths = [Path(one) for one in recordings]
    made = draft(Path(folder), paths, wishes, read_library(files=as_paths(files)), _described(files), as_paths(files))
    written = read(folder, files=files)
    begun = begun_data(written, written.model, files=files)
    return replace(made, data=written, starts=begun.starts)


def simulate(
    model: str,
    parameters: Mapping[str, Setting] | None = None,
    inputs: Source | None = None,
    *,
    outputs: Sequence[str] = (),
    stop_time: Setting | None = None,
    interval: Setting | None = None,
    engine: str = "own",
    files: Paths = (),
    timeout: float | None = None,
) -> Trajectory:
    """One run of a model.

    ```python
    run = pam.simulate("Isotonic", {"u_in": 0.35, "load.m": "5 kg"}, outputs=["valve.inlet.m_flow"])
    wave = pam.simulate("Isotonic", inputs={"u_in": lambda t: 0.3 + 0.05 * np.sin(t)}, stop_time="20 s")
    ```

    Args:
        model: a bench, a Modelica class, a ``.mo`` or an ``.fmu`` file.
        parameters: by name, what differs from the model's defaults: parameters, inputs that are held constant, start
            values; a number [SI] or a text with a unit such as "207 kPa".
        inputs: over time: ``Inputs``, a CSV file, a mapping of names to arrays or functions of time, a pandas frame
            (``sources.inputs_of``).
        outputs: further variables to keep, beside the model's outputs.
        stop_time: [s]; default: the last time of ``inputs``, or the model's own.
        interval: [s] between outputs; default: the model's own.
        engine: "own", or "fmpy": FMPy drives the same FMU, in this process.
        files: further Modelica files.
        timeout: [s] of processor time, after which a run of a Modelica model fails; default:
            ``CRITERIA.run.longest``. An FMU that makes no progress for so long is ended; default: a minute.

    Raises:
        InputError: an unknown model or name, a value that cannot be used, an input given both ways.
        SimulationFailure: the run did not reach its end.
    """
    if engine not in ENGINES:
        raise InputError(f"there is no engine '{engine}'; there are {', '.join(ENGINES)}")
    with opened(model, files, timeout=timeout) as simulator:
        interface = simulator.interface
        course, times = _course(interface, inputs, stop_time, interval)
        values, kept = resolve(parameters or {}, interface), _kept(interface, outputs)
        if engine == "fmpy":
            return run_with_fmpy(simulator.path, times, parameters=values, inputs=course, outputs=kept)
        return simulator.run(times, parameters=values, inputs=course, outputs=kept)


def _course(
    interface: Interface, source: Source | None, stop_time: Setting | None, interval: Setting | None
) -> tuple[Inputs | None, np.ndarray]:
    """Inputs over time, and the times of the outputs."""
    stop, step = (_seconds(given, what) for given, what in ((stop_time, "stop time"), (interval, "interval")))
    inputs = inputs_of(source, interface, lambda: output_times(interface, None, stop, step))
    return inputs, output_times(interface, inputs, stop, step)


def _patterns(
    interface: Interface, vary: Any, stop_time: Setting | None, interval: Setting | None
) -> tuple[Pattern, ...]:
    """The inputs over time that a sweep varies; none where it does not."""
    if not varies_inputs(vary, interface):
        return ()
    return read_patterns(vary[INPUTS], lambda source: _course(interface, source, stop_time, interval)[0])


def _seconds(given: Setting | None, what: str) -> float | None:
    try:
        return None if given is None else seconds(given)
    except UnitError as problem:
        raise InputError(f"the {what}: {problem}") from None


def _kept(interface: Interface, outputs: Sequence[str]) -> list[str]:
    """The model's own outputs and the variables that are asked for beside them.

    Raises:
        InputError: there is no such variable; says which is nearest.
    """
    if isinstance(outputs, str):
        raise InputError(f"outputs are a list of names: write ['{outputs}']")
    known = interface.variables
    for name in outputs:
        if name not in known:
            raise InputError(f"{interface.model} has no variable '{name}'; {did_you_mean(name, known)}")
    return list(dict.fromkeys([*interface.outputs, *interface.sensitivities, *outputs]))


def output_times(
    interface: Interface, inputs: Inputs | None, stop_time: float | None = None, interval: float | None = None
) -> np.ndarray:
    """(n,) [s]: from the first input sample (or zero) to the last (or the model's default stop time)."""
    start = float(inputs.time[0]) if inputs is not None else 0.0
    end = stop_time if stop_time is not None else float(inputs.time[-1]) if inputs is not None else interface.stop_time
    step = interval if interval is not None else interface.interval or (end - start) / 1000
    if not end > start or not step > 0:
        raise InputError(f"the run must end after its start: from {start:g} s to {end:g} s in steps of {step:g} s")
    steps = (end - start) / step
    if not steps <= MOST_STEPS:
        span = f"from {start:g} s to {end:g} s in steps of {step:g} s"
        raise InputError(f"{span} are {steps:.3g} rows; {MOST_STEPS} at most can be kept")
    return start + (end - start) * np.linspace(0, 1, max(2, round(steps) + 1))


def sweep(
    model: str,
    vary: Mapping[str, Iterable[Setting]] | Sequence[Mapping[str, Setting]] | Any,
    *,
    parameters: Mapping[str, Setting] | None = None,
    inputs: Source | None = None,
    outputs: Sequence[str] = (),
    scalars: Mapping[str, str] | Sequence[str] = (),
    trajectories: bool | None = None,
    design: str = "grid",
    runs: int | None = None,
    seed: int = 0,
    stop_time: Setting | None = None,
    interval: Setting | None = None,
    output: Path | str | None = None,
    executor: Any = None,
    workers: int | None = None,
    files: Paths = (),
    progress: Callable[[int, int], None] | None = None,
    timeout: float | None = None,
) -> Sweep:
    """Many runs of a model; one that fails is reported and the others go on.

    ```python
    swept = pam.sweep(
        "TankFilling",
        {"u_in": np.linspace(0.2, 0.35, 16), "p_supply": ["138 kPa", "207 kPa"]},
        scalars={"filling time": "time_to(p, 90 %)", "peak temperature": "max(T)"},
        output="filling.nc",
    )
    swept.dataset()["filling time"].sel(p_supply=138e3)
    ```

    Args:
        model: as in ``simulate``.
        vary: by name of a parameter, an input that is held constant or a start value: its values for a "grid", where
            every combination is a run, and for a "list", run by run (or a mapping for each run, or a pandas frame);
            its lowest and highest value for "random" and "latin-hypercube". By the name "inputs": inputs over time, a
            list of whatever ``inputs`` takes (files, mappings of arrays or functions, frames), or by their names.
        parameters: of every run, as in ``simulate``.
        inputs: of every run, as in ``simulate``.
        stop_time: of every run, as in ``simulate``.
        interval: of every run, as in ``simulate``.
        outputs: further variables to keep over time, beside the model's outputs.
        scalars: numbers of each run by name, or a list: "max(T)", "time_to(p, 90 %)", "steady(x)",
            "mean(valve.inlet.m_flow)"; ``sweeps.FUNCTIONS`` lists them.
        trajectories: whether values over time are kept; default: where there are no scalars.
        design: "grid", "list", "random" or "latin-hypercube".
        runs: how many, of "random" and "latin-hypercube".
        seed: of these.
        output: a file for the result, NetCDF (.nc), Parquet (.parquet) or CSV. Runs that are done are kept beside it: a
            sweep that was stopped goes on with the same call.
        executor: where runs are made: any executor of ``concurrent.futures``, a Dask client or the address of a Dask
            scheduler; default: processes of this machine, as soon as the work is worth them.
        workers: how many of these; 1: this process alone.
        files: further Modelica files.
        timeout: of every run, as in ``simulate``.
        progress: called with the number of runs done and of all runs.

    Raises:
        InputError: as ``simulate``; a name that is both varied and set; ``output`` belongs to another sweep.
        SimulationFailure: a process that makes runs ended.
    """
    if output is not None:
        check_writable(Path(output))
    foreign, fmu = is_fmu(model), build(model, files=files)
    interface = read_interface(fmu)
    patterns = _patterns(interface, vary, stop_time, interval)
    longest = max((p.inputs for p in patterns), key=lambda i: float(i.time[-1]), default=None)
    course, times = _course(interface, longest if patterns and inputs is None else inputs, stop_time, interval)
    course = None if patterns and inputs is None else course
    asked = read_scalars(scalars, interface)
    plan = Plan(
        fmu=fmu,
        interface=interface,
        design=design_of(vary, interface, design, runs, checked_seed(seed), patterns),
        fixed=resolve(parameters or {}, interface),
        inputs=course,
        times=times,
        outputs=tuple(_kept(interface, outputs)),
        scalars=asked,
        keep=not asked if trajectories is None else trajectories,
        foreign=foreign,
        timeout=timeout,
    )
    result = None if output is None else Path(output)
    made = make_sweep(plan, result, executor=executor, workers=checked_workers(workers, 1), progress=progress)
    if result is not None:
        made.save(result)
    return made
