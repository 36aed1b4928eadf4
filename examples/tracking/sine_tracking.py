"""A tracking test: a controlled output follows a sine, and the error over the last period, by frequency."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import pam_cosim as pam

Array = NDArray[np.float64]
SAMPLES = 200  # of a period, as the reference is drawn and compared
PERIODS = 4  # at each frequency; the last one is evaluated
SETTLED = 0.01  # of the amplitude: the largest difference of the last two periods


@dataclass(frozen=True)
class Tracking:
    """An output that follows mean + amplitude sin(2 pi f t), in the unit of the output.

    Attributes:
        frequencies: (k,) [Hz].
        gain: (k,) complex, fundamental of the output over the fundamental of the reference.
        relative_error: (k,) rms error over the rms of the sine: 1 is the error of an output at rest.
        settled: (k,) whether the last two periods are equal to a hundredth of the amplitude.
        phase: (s,) within the last period, 0 to 1.
        reference: (s,) over the last period.
        courses: (k, s) of the output over the last period.
    """

    frequencies: Array
    gain: NDArray[np.complex128]
    relative_error: Array
    settled: NDArray[np.bool_]
    phase: Array
    reference: Array
    courses: Array

    def __str__(self) -> str:
        lines = ["frequency [Hz]  rms error  gain  phase [deg]"]
        for f, gain, error, settled in zip(
            self.frequencies, self.gain, self.relative_error, self.settled, strict=True
        ):
            row = f"{f:14.3g} {error:10.1%} {abs(gain):5.2f} {np.degrees(np.angle(gain)):12.1f}"
            lines.append(row if settled else f"{row}  not settled")
        return "\n".join(lines)


def track(
    plant: str,
    controller: str | Callable[[], pam.Controller],
    parameters: Mapping[str, float | str] | None = None,
    *,
    output: str,
    mean: float,
    amplitude: float,
    frequencies: Sequence[float],
    interval: float = 0.0125,
    lead: float = 4.0,
) -> Tracking:
    """Simulates the closed loop at each frequency.

    Inputs and outputs of the same name are connected; the reference is the controller's input ``<output>_wanted``.

    Args:
        plant: a bench, a Modelica class, a ``.mo`` or an ``.fmu`` file.
        controller: the same, or a function that makes a ``pam.controller``: a new one for each frequency, since a
            controller can have a memory.
        parameters: "plant.NAME" or "control.NAME", as in ``pam.couple``.
        output: the controlled output of the plant.
        mean: of the reference. amplitude: of the reference.
        frequencies: [Hz].
        interval: between the samples of a controller that is an FMU [s]; a ``pam.controller`` has its own.
        lead: time to reach the mean before the sine begins [s].
    """
    phase = np.arange(SAMPLES) / SAMPLES
    rows = []
    for frequency in frequencies:
        system, step = closed_loop(plant, controller, parameters, interval)
        t = np.arange(PERIODS * SAMPLES + 1) / (SAMPLES * frequency)
        time = np.concatenate(([0.0, lead / 2], lead + t))
        sine = mean + amplitude * np.sin(2 * np.pi * frequency * t)
        reference = np.concatenate(([0.0, mean], sine))
        run = system.simulate(
            float(time[-1]),
            method="jacobi",
            extrapolation="constant",
            step=step,
            inputs=pam.Inputs(time, {f"control.{output}_wanted": reference}),
        ).trajectory
        before, last = (
            np.interp(lead + (PERIODS - n + phase) / frequency, run.time, run[f"plant.{output}"])
            for n in (2, 1)
        )
        fundamental = np.mean((last - mean) * np.exp(-2j * np.pi * phase)) * 2j / amplitude
        error = np.sqrt(np.mean((last - sine[:SAMPLES]) ** 2)) / (amplitude / np.sqrt(2))
        rows.append((fundamental, error, np.abs(last - before).max() <= SETTLED * amplitude, last))
    gain, errors, settled, courses = (np.array(column) for column in zip(*rows, strict=True))
    reference = mean + amplitude * np.sin(2 * np.pi * phase)
    return Tracking(np.array(frequencies), gain, errors, settled, phase, reference, courses)


def closed_loop(
    plant: str,
    controller: str | Callable[[], pam.Controller],
    parameters: Mapping[str, float | str] | None,
    interval: float,
) -> tuple[pam.System, float]:
    """The plant with its controller, and the interval between the controller's samples [s]."""
    control: str | pam.Controller = controller() if callable(controller) else controller
    sampled = isinstance(control, pam.Controller)
    outside, inside = (control.interface if sampled else pam.describe(control)), pam.describe(plant)
    measured = [name for name in outside.inputs if name in inside.outputs]
    acting = [name for name in outside.outputs if name in inside.inputs]
    system = pam.couple(
        {"plant": plant, "control": control},
        [f"plant.{name} -> control.{name}" for name in measured]
        + [f"control.{name} -> plant.{name}" for name in acting],
        parameters,
        samples={} if sampled else {"control": interval},
    )
    return system, control.seconds if sampled else interval
