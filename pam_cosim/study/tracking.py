"""A step of a study: how closely a controlled model follows a sine."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np

from pam_cosim.analysis.tracking import Tracking
from pam_cosim.arrays import Array
from pam_cosim.cosimulation import Controller
from pam_cosim.cosimulation.system import MOST_STEPS
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface
from pam_cosim.model.settings import Setting, size_of, value_of
from pam_cosim.simulation import Inputs, Trajectory, models
from pam_cosim.study.coupling import couple
from pam_cosim.wording import did_you_mean

SAMPLES = 200  # of a period, as what is wanted is drawn and compared
_SETTLED = 0.01  # of the amplitude
_PLANT, _CONTROL = "plant", "control"


def track(
    plant: str,
    controller: str | Callable[[], Controller],
    parameters: Mapping[str, Setting] | None = None,
    *,
    output: str,
    mean: Setting,
    amplitude: Setting,
    frequencies: Sequence[float],
    rate: float = 80.0,
    lead: float = 4.0,
    periods: int = 4,
    files: models.Paths = (),
    progress: Callable[[int, int], None] | None = None,
    timeout: float | None = None,
) -> Tracking:
    """Lets a controlled output follow sines and measures the error.

    The controller's inputs and outputs are joined to those of the plant by their names; what the output shall be goes
    to its input ``<output>_wanted``. It acts at samples, an FMU as one in Python: what it makes of its inputs of that
    time stays until the next one.

    Args:
        plant: a bench, a Modelica class, a ``.mo`` or an ``.fmu`` file.
        controller: the same, or a function without arguments that makes a ``pam.controller``: one for each frequency,
            since it may keep a memory.
        parameters: "plant.NAME" or "control.NAME", as in ``couple``.
        output: of the plant, that is controlled.
        mean: of the sine that is wanted; with units.
        amplitude: of the sine that is wanted; with units.
        frequencies: [Hz].
        rate: of samples [Hz], of a controller that is an FMU; one in Python says it itself.
        lead: [s] to come to the mean before the sine begins.
        periods: of the sine; the last one counts.
        files: as in ``simulate``.
        timeout: as in ``simulate``.
        progress: called with the number of frequencies done and of all.

    Raises:
        InputError: unknown names, values that cannot be used, a controller that fits no input of the plant or raises.
        SimulationFailure: a component failed.
    """
    chosen = np.asarray(frequencies, dtype=float)
    _check_times(chosen, rate, lead, periods)
    face = models.describe(plant, files)
    middle, swing = _sizes(face, output, mean, amplitude)
    made = [controller() if callable(controller) else controller for _ in chosen]
    interval = _interval(made[0], rate)
    _check_steps(lead + periods / float(chosen.min()), interval, periods)
    joined, acting = _connections(face, _face(made[0], files), output)
    rows = []
    for i, (frequency, one) in enumerate(zip(chosen, made, strict=True)):
        system = couple(
            {_PLANT: plant, _CONTROL: one},
            joined,
            parameters,
            samples=_samples(one, interval),
            files=files,
            timeout=timeout,
        )
        wanted = _sine(middle, swing, float(frequency), lead, periods)
        run = system.simulate(
            float(wanted[0][-1]),
            method="jacobi",
            extrapolation="constant",
            step=interval,
            inputs=Inputs(wanted[0], {f"{_CONTROL}.{output}_wanted": wanted[1]}),
            outputs=[f"{_PLANT}.{name}" for name in acting],
        ).trajectory
        rows.append(_measured(run, output, acting, middle, swing, float(frequency), lead, periods))
        if progress is not None:
            progress(i + 1, len(chosen))
    gain, error, peak, settled, courses = (
        np.array(column) for column in list(zip(*rows, strict=True))[:5]
    )
    return Tracking(
        face.model,
        _name_of(controller),
        output,
        face.outputs[output].unit,
        middle,
        swing,
        1 / interval,
        chosen,
        gain,
        error,
        peak,
        settled,
        np.arange(SAMPLES) / SAMPLES,
        courses,
        {name: np.array([row[5][name] for row in rows]) for name in acting},
    )


def _check_times(frequencies: Array, rate: float, lead: float, periods: int) -> None:
    if (
        not frequencies.size
        or not np.all(np.isfinite(frequencies) & (frequencies > 0))
        or not rate > 0
    ):
        raise InputError("frequencies and the rate must be above zero")
    if periods < 2 or not 0 < lead < np.inf:
        raise InputError(
            f"two periods at least are compared, after a finite lead above zero; not {periods} after {lead:g} s"
        )


def _check_steps(length: float, interval: float, periods: int) -> None:
    """Refuses what nobody waits for, before there is a course of it."""
    if max(length / interval, periods * SAMPLES) > MOST_STEPS:
        raise InputError(
            f"a run has {MOST_STEPS} steps at most; {periods} periods take {length:g} s in steps of {interval:g} s"
        )


def _sizes(plant: Interface, output: str, mean: Setting, amplitude: Setting) -> tuple[float, float]:
    """Mean and amplitude of the sine [SI]."""
    if output not in plant.outputs:
        raise InputError(
            f"{plant.model} has no output '{output}'; {did_you_mean(output, plant.outputs)}"
        )
    variable = plant.outputs[output]
    return value_of(mean, variable), size_of("the amplitude", amplitude, variable)


def _name_of(controller: str | Callable[[], Controller]) -> str:
    if not isinstance(controller, str):
        return str(getattr(controller, "__name__", "a controller in Python"))
    return Path(controller).stem if controller.endswith((".fmu", ".mo")) else controller


def _interval(one: str | Controller, rate: float) -> float:
    return one.seconds if isinstance(one, Controller) else 1 / rate


def _samples(one: str | Controller, interval: float) -> dict[str, float]:
    """Of a controller that does not say it itself: what is wanted has points of its own, at which it is not to act."""
    return {} if isinstance(one, Controller) else {_CONTROL: interval}


def _face(one: str | Controller, files: models.Paths) -> Interface:
    return one.interface if isinstance(one, Controller) else models.describe(one, files)


def _connections(plant: Interface, control: Interface, output: str) -> tuple[list[str], list[str]]:
    """What is joined by its name, and which inputs of the plant the controller sets."""
    target = f"{output}_wanted"
    if target not in control.inputs:
        raise InputError(f"{control.model} has no input '{target}' for what {output} shall be")
    if output not in control.inputs:
        raise InputError(f"{control.model} has no input '{output}', which it is to control")
    acting = [name for name in control.outputs if name in plant.inputs]
    if not acting:
        known = ", ".join(plant.inputs) or "none"
        raise InputError(
            f"no output of {control.model} has the name of an input of {plant.model}: {known}"
        )
    seen = [name for name in control.inputs if name in plant.outputs]
    there = [f"{_PLANT}.{name} -> {_CONTROL}.{name}" for name in seen]
    return [*there, *(f"{_CONTROL}.{name} -> {_PLANT}.{name}" for name in acting)], acting


def _sine(
    middle: float, swing: float, frequency: float, lead: float, periods: int
) -> tuple[Array, Array]:
    """What is wanted: half the lead to the mean along a line, half of it there, then the sine."""
    t = np.arange(periods * SAMPLES + 1) / (SAMPLES * frequency)
    time = np.concatenate(([0.0, lead / 2], lead + t))
    return time, np.concatenate(([0.0, middle], middle + swing * np.sin(2 * np.pi * frequency * t)))


def _measured(
    run: Trajectory,
    output: str,
    acting: list[str],
    middle: float,
    swing: float,
    frequency: float,
    lead: float,
    periods: int,
) -> tuple[complex, float, float, bool, Array, dict[str, Array]]:
    grid = np.arange(SAMPLES) / SAMPLES
    times = [lead + (periods - back + grid) / frequency for back in (2, 1)]
    before, last = (np.interp(t, run.time, run[f"{_PLANT}.{output}"]) for t in times)
    off = last - middle - swing * np.sin(2 * np.pi * grid)
    fundamental = np.sum((last - middle) * np.exp(-2j * np.pi * grid)) * 2 / SAMPLES
    acts = {}
    for name in acting:  # held between samples
        values = run[f"{_PLANT}.{name}"]
        acts[name] = values[
            np.clip(np.searchsorted(run.time, times[1], side="right") - 1, 0, len(values) - 1)
        ]
    settled = bool(np.abs(last - before).max() <= _SETTLED * swing)
    rms, peak = float(np.sqrt(np.mean(off**2))), float(np.abs(off).max())
    return complex(fundamental / (-1j * swing)), rms, peak, settled, last, acts
