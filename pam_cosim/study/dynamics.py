"""Steps of a study that look at a model's dynamics, as one function each."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from pam_cosim.analysis.frequency_response import FrequencyResponse
from pam_cosim.analysis.isolated import work_on
from pam_cosim.analysis.linear import LinearModel
from pam_cosim.analysis.linear_models import LinearModels
from pam_cosim.analysis.linearise import linearise_at, linearise_run
from pam_cosim.analysis.sines import Sines, respond, respond_from_start
from pam_cosim.errors import InputError
from pam_cosim.fmu.read import exchange_description, interface_of, read_description, read_interface
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_fmu
from pam_cosim.model.settings import Setting, resolve, size_of, value_of
from pam_cosim.simulation import Inputs, Trajectory, models
from pam_cosim.wording import did_you_mean

Point = Literal["rest"] | Mapping[str, Setting] | float | tuple[Trajectory, float]


@dataclass(frozen=True)
class Exchange:
    """A model for model exchange that is ready to be worked on.

    Attributes:
        path: of its FMU.
        trusted: whether it was built here, and may run in this process.
        interface: its names and units.
    """

    path: Path
    trusted: bool
    interface: Interface


def exchange(model: str, files: models.Paths = ()) -> Exchange:
    """Finds or builds the FMU of a model.

    Raises:
        InputError: no such model, or one without model exchange.
    """
    path = models.build(model, files=files)
    return Exchange(path, not is_fmu(model), interface_of(exchange_description(path)))


def linearise(
    model: str,
    parameters: Mapping[str, Setting] | None = None,
    *,
    at: Point = "rest",
    free: Sequence[str] = (),
    inputs: Inputs | None = None,
    outputs: Sequence[str] | None = None,
    files: models.Paths = (),
    timeout: float | None = None,
) -> LinearModel:
    """The linear model about a point, from the FMU's exact derivatives.

    Args:
        model: a bench, a Modelica class, a ``.mo`` or an ``.fmu`` file with model exchange.
        parameters: as in ``simulate``; inputs among them are held.
        at: "rest": where a run with constant inputs settles. Values by name: that state; named states and inputs take
            their values, and where another variable is named, such as an output, the other states change as little as
            they must from their start values. A number: that time [s] of the run that ``inputs`` drive. A trajectory
            that has all states, and a time [s].
        free: inputs that the solver chooses; ``at`` is then a rest at which what is named has its value.
        inputs: over time; only for a time of a run.
        outputs: names of outputs or of any other variable; default: every output.
        files: further Modelica files.
        timeout: as in ``simulate``.

    Raises:
        InputError: an unknown name, a value that cannot be used, a model without model exchange; no rest, or no such
            state.
        SimulationFailure: the model cannot be evaluated there.
    """
    exchange_model = exchange(model, files)
    settings = resolve(parameters or {}, exchange_model.interface)
    if isinstance(at, str) and at != "rest":
        raise InputError(f"'{at}' is no point: give 'rest', values by name, or a time")
    if isinstance(at, str | Mapping):
        if inputs is not None:
            raise InputError(
                "inputs over time are for a time of a run; inputs that are held belong to the parameters"
            )
        conditions = {} if isinstance(at, str) else conditions_of(at, exchange_model.interface)
        at_rest = isinstance(at, str) or bool(free)
        return work_on(
            exchange_model.path,
            exchange_model.trusted,
            timeout,
            linearise_at,
            settings,
            conditions,
            at_rest,
            list(free),
            _listed(outputs),
        )
    if free:
        raise InputError("free inputs need a steady state")
    if isinstance(at, tuple):
        points = [_of_trajectory(at[0], float(at[1]), exchange_model)]
    else:
        points = _of_run(model, settings, inputs, [float(at)], exchange_model, files, timeout)
    return work_on(
        exchange_model.path,
        exchange_model.trusted,
        timeout,
        linearise_run,
        settings,
        points,
        _listed(outputs),
    )[0]


def linearise_along(
    model: str,
    parameters: Mapping[str, Setting] | None = None,
    inputs: Inputs | None = None,
    *,
    times: Sequence[float],
    outputs: Sequence[str] | None = None,
    files: models.Paths = (),
    timeout: float | None = None,
) -> LinearModels:
    """The linear models at several times of one run.

    Args:
        model: as in ``simulate``.
        parameters: as in ``simulate``.
        inputs: as in ``simulate``.
        files: as in ``simulate``.
        timeout: as in ``simulate``.
        times: (k,) [s], increasing.
        outputs: as in ``linearise``.

    Raises:
        InputError: as ``linearise``; no times, or times that do not increase.
        SimulationFailure: the run does not get there.
    """
    if not len(times):
        raise InputError("no time is given")
    exchange_model = exchange(model, files)
    settings = resolve(parameters or {}, exchange_model.interface)
    points = _of_run(
        model, settings, inputs, [float(t) for t in times], exchange_model, files, timeout
    )
    linear_models = work_on(
        exchange_model.path,
        exchange_model.trusted,
        timeout,
        linearise_run,
        settings,
        points,
        _listed(outputs),
    )
    return LinearModels(tuple(linear_models))


def conditions_of(at: Mapping[str, Setting], interface: Interface) -> dict[str, float]:
    """Values [SI] of any variables.

    Raises:
        InputError: an unknown name, or a value that cannot be used.
    """
    groups = (interface.inputs, interface.outputs, interface.locals, interface.sensitivities)
    variables = {name: variable for group in groups for name, variable in group.items()}
    for name in at:
        if name in interface.parameters:
            raise InputError(f"'{name}' is a parameter: set it with the parameters")
        if name not in variables:
            raise InputError(
                f"{interface.model} has no variable '{name}'; {did_you_mean(name, variables)}"
            )
    return {name: value_of(value, variables[name]) for name, value in at.items()}


def _listed(names: Sequence[str] | None) -> list[str] | None:
    return None if names is None else list(names)


def _of_trajectory(
    trajectory: Trajectory, time: float, exchange_model: Exchange
) -> tuple[float, dict[str, float]]:
    required_outputs = state_names(exchange_model.path)
    missing = [name for name in required_outputs if name not in trajectory.values]
    if missing:
        raise InputError(
            f"the trajectory lacks {', '.join(missing)}: "
            f"simulate it with the outputs {', '.join(required_outputs)}"
        )
    if not trajectory.time[0] <= time <= trajectory.time[-1]:
        span = f"from {trajectory.time[0]:g} s to {trajectory.time[-1]:g} s"
        raise InputError(f"the trajectory is {span}, without {time:g} s")
    starts = {
        name: variable.start or 0.0 for name, variable in exchange_model.interface.inputs.items()
    }
    values = {
        n: float(np.interp(time, trajectory.time, trajectory.values[n])) for n in trajectory.values
    }
    return time, starts | values


def _of_run(
    model: str,
    settings: Mapping[str, float],
    inputs: Inputs | None,
    times: list[float],
    exchange_model: Exchange,
    files: models.Paths,
    timeout: float | None,
) -> list[tuple[float, dict[str, float]]]:
    start = float(inputs.time[0]) if inputs is not None else 0.0
    if times[0] < start or any(b <= a for a, b in zip(times, times[1:], strict=False)):
        raise InputError(f"the times must increase, from {start:g} s on")
    names = [*state_names(exchange_model.path), *exchange_model.interface.inputs]
    with models.opened(model, files, timeout=timeout) as simulator:
        run = simulator.run(
            times, parameters=settings, inputs=inputs, outputs=names, start_time=start
        )
    return [(t, {name: float(run[name][i]) for name in names}) for i, t in enumerate(times)]


def state_names(path: Path) -> list[str]:
    """The continuous states of an FMU with model exchange."""
    rates = [unknown.variable for unknown in exchange_description(path).derivatives]
    return [rate.derivative.name for rate in rates if rate.derivative is not None]


def frequency_response(
    model: str,
    parameters: Mapping[str, Setting] | None = None,
    *,
    input: str,
    outputs: Sequence[str] | None = None,
    amplitude: Setting,
    frequencies: Sequence[float] | None = None,
    at: Literal["rest"] | Mapping[str, Setting] = "rest",
    free: Sequence[str] = (),
    most_periods: int = 200,
    files: models.Paths = (),
    progress: Callable[[int, int], None] | None = None,
    timeout: float | None = None,
) -> FrequencyResponse:
    """Nonlinear response of a model to sines of an input, compared with its linear model.

    An FMU for co-simulation alone swings about its start values, prolonged until it settles, without a linear model.

    Args:
        model: as in ``linearise``.
        parameters: as in ``linearise``.
        free: as in ``linearise``.
        files: as in ``linearise``.
        timeout: as in ``linearise``.
        input: that swings about its value at rest.
        outputs: names of outputs or of any other variable; default: every output.
        amplitude: of the input.
        frequencies: [Hz]; default: sixteen from 0.1 to 20 Hz.
        at: "rest", or values that a rest shall have which ``free`` inputs make possible.
        most_periods: at each frequency; a response that has not settled by then is marked.
        progress: called with the number of frequencies done and of all.

    Raises:
        InputError: as ``linearise``; an amplitude or frequency that is not above zero.
        SimulationFailure: as ``linearise``.
    """
    chosen = (
        np.geomspace(0.1, 20.0, 16) if frequencies is None else np.asarray(frequencies, dtype=float)
    )
    if not chosen.size or not np.all(np.isfinite(chosen) & (chosen > 0)):
        raise InputError("frequencies must be above zero")
    if most_periods < 2:
        raise InputError("at least two periods are needed")
    path = models.build(model, files=files)
    face = read_interface(path)
    exchanging = read_description(path).modelExchange is not None
    if input not in face.inputs:
        raise InputError(f"{face.model} has no input '{input}'; {did_you_mean(input, face.inputs)}")
    size = size_of("the amplitude", amplitude, face.inputs[input])
    sines = Sines(
        input,
        tuple(face.outputs if outputs is None else outputs),
        tuple(chosen.tolist()),
        size,
        most_periods,
    )
    settings = resolve(parameters or {}, face)
    conditions = {} if isinstance(at, str) else conditions_of(at, face)
    if conditions and not free:
        raise InputError(
            "a frequency response is about an equilibrium: name the inputs that may be chosen for it (free)"
        )
    if exchanging:
        trusted = not is_fmu(model)
        callback = progress if trusted else None  # what runs in another process cannot call
        return work_on(
            path, trusted, timeout, respond, settings, conditions, list(free), sines, callback
        )
    if conditions:
        raise InputError("a steady state needs an FMU for model exchange", path)
    with models.opened(model, files, timeout=timeout) as simulator:
        return respond_from_start(simulator, settings, sines, progress)
