"""The frequency response of the model itself, nonlinear as it is, by sines of a given amplitude."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.analysis.flow import InputFunction, flow
from pam_cosim.analysis.frequency_response import FrequencyResponse
from pam_cosim.analysis.linear import LinearModel
from pam_cosim.analysis.linearise import linearise_at
from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.simulation import AnySimulator, Inputs

SAMPLES = 64  # of a period
_HARMONICS = 10  # that the distortion counts, the second to this one
# A response has settled when its fundamental and its mean change by less than this part of the fundamental in a period.
_SETTLED = 1e-3
_BATCH = 2  # periods
_FIRST_PERIODS = 8  # of a run from the start values


@dataclass(frozen=True)
class Sines:
    """What is to be done.

    Attributes:
        input: that swings.
        outputs: that are looked at.
        frequencies: (k,) [Hz].
        amplitude: of the input [SI].
        most_periods: at a frequency, after which the response is taken as it is.
    """

    input: str
    outputs: tuple[str, ...]
    frequencies: tuple[float, ...]
    amplitude: float
    most_periods: int


@dataclass(frozen=True)
class _SineResponse:
    """At one frequency: complex gains, distortions and shifts of the mean (p,), periods done, whether settled."""

    gain: Array
    distortion: Array
    shift: Array
    periods: int
    settled: bool


def respond(
    model: ExchangeModel,
    parameters: Mapping[str, float],
    conditions: Mapping[str, float],
    free: Sequence[str],
    sines: Sines,
    progress: Callable[[int, int], None] | None = None,
) -> FrequencyResponse:
    """The response about a rest; each sine begins on the linear model's cycle, so that little is left to settle."""
    linear = linearise_at(model, parameters, conditions, True, free, sines.outputs)
    at = list(linear.inputs).index(sines.input)
    check_range(
        model.interface.inputs[sines.input].min,
        model.interface.inputs[sines.input].max,
        linear,
        sines,
    )
    equilibrium, held = (
        np.array(list(linear.point.states.values())),
        np.array(list(linear.point.inputs.values())),
    )
    answers = []
    for i, frequency in enumerate(sines.frequencies):
        answers.append(_swing(model, linear, equilibrium, held, at, frequency, sines))
        if progress is not None:
            progress(i + 1, len(sines.frequencies))
    return _collected(answers, sines, linear.model, linear.units, linear.select([sines.input]))


def check_range(low: float | None, high: float | None, linear: LinearModel, sines: Sines) -> None:
    """Raises InputError where the sine would leave the range of its input."""
    middle = linear.point.inputs[sines.input]
    if (low is not None and middle - sines.amplitude < low) or (
        high is not None and middle + sines.amplitude > high
    ):
        raise InputError(
            f"{sines.input} would swing between {middle - sines.amplitude:.6g} and {middle + sines.amplitude:.6g} "
            f"{linear.units[sines.input]}, outside of its range; choose a smaller amplitude"
        )


def _swing(
    model: ExchangeModel,
    linear: LinearModel,
    equilibrium: Array,
    held: Array,
    at: int,
    frequency: float,
    sines: Sines,
) -> _SineResponse:
    omega = 2 * np.pi * frequency
    unit = np.zeros(len(held))
    unit[at] = sines.amplitude

    def inputs(t: float) -> Array:
        return np.asarray(held + unit * np.sin(omega * t))

    begin = equilibrium
    if len(equilibrium):
        # of a sine, the state at phase zero is the imaginary part
        cycle = np.linalg.solve(
            1j * omega * np.eye(len(equilibrium)) - linear.A, linear.B[:, at] * sines.amplitude
        )
        begin = equilibrium + cycle.imag
    ahead, periods, spectrum = begin, 0, None
    mean = np.array([linear.point.outputs[name] for name in sines.outputs])
    while True:
        ahead, periods_of_outputs = _periods(
            model, ahead, periods, frequency, inputs, sines.outputs
        )
        periods += _BATCH
        for samples in periods_of_outputs:
            before, spectrum = spectrum, _Spectrum(samples, sines.amplitude, mean)
        assert before is not None and spectrum is not None
        settled = spectrum.agrees(before)
        if settled or periods >= sines.most_periods:
            return _SineResponse(
                spectrum.gain, spectrum.distortion, spectrum.shift, periods, settled
            )


def _periods(
    model: ExchangeModel,
    state: Array,
    done: int,
    frequency: float,
    inputs: InputFunction,
    outputs: Sequence[str],
) -> tuple[Array, list[Array]]:
    """The state after a batch of periods, and for each of them the outputs (SAMPLES, p)."""
    times = (done + np.arange(_BATCH * SAMPLES + 1) / SAMPLES) / frequency
    states = flow(model, state, times, inputs)
    values = np.zeros((len(times) - 1, len(outputs)))
    for i, t in enumerate(times[:-1]):
        model.set(t, states[:, i], inputs(t))
        values[i] = model.values(outputs)
    return states[:, -1], np.split(values, _BATCH)


class _Spectrum:
    """Of one period (SAMPLES, p) of the outputs, from a sine of the input."""

    def __init__(self, samples: Array, amplitude: float, mean: Array) -> None:
        lines = np.fft.rfft(samples - mean, axis=0) * (2 / len(samples))
        self.fundamental = lines[1]
        self.gain = lines[1] / (-1j * amplitude)
        self.shift = lines[0].real / 2
        over = np.sqrt((np.abs(lines[2 : _HARMONICS + 1]) ** 2).sum(axis=0))
        size = np.abs(lines[1])
        self.distortion = np.divide(over, size, out=np.zeros_like(over), where=size > 0)

    def agrees(self, other: _Spectrum) -> bool:
        """Whether the two periods agree."""
        tolerance = _SETTLED * np.abs(self.fundamental)
        changes = np.maximum(
            np.abs(self.fundamental - other.fundamental), np.abs(self.shift - other.shift)
        )
        return bool(np.all(changes <= tolerance))


def respond_from_start(
    simulator: AnySimulator,
    parameters: Mapping[str, float],
    sines: Sines,
    progress: Callable[[int, int], None] | None = None,
) -> FrequencyResponse:
    """The response of an FMU for co-simulation alone, which has no linear model.

    Each run begins at the start values and is prolonged until it settles.
    """
    interface = simulator.interface
    variable = interface.inputs[sines.input]
    middle = parameters.get(sines.input, variable.start or 0.0)
    constants = {name: value for name, value in parameters.items() if name != sines.input}
    answers = []
    for i, frequency in enumerate(sines.frequencies):
        answers.append(_swing_from_start(simulator, constants, middle, frequency, sines))
        if progress is not None:
            progress(i + 1, len(sines.frequencies))
    units = {
        name: v.unit
        for name, v in (interface.inputs | interface.outputs | interface.locals).items()
    }
    return _collected(answers, sines, interface.model, units, None)


def _swing_from_start(
    simulator: AnySimulator,
    parameters: Mapping[str, float],
    middle: float,
    frequency: float,
    sines: Sines,
) -> _SineResponse:
    periods = min(_FIRST_PERIODS, sines.most_periods)
    while True:
        times = np.arange(periods * SAMPLES + 1) / (SAMPLES * frequency)
        samples = middle + sines.amplitude * np.sin(2 * np.pi * frequency * times)
        run = simulator.run(
            times,
            parameters=parameters,
            inputs=Inputs(times, {sines.input: samples}),
            outputs=sines.outputs,
        )
        values = np.array([run[name][:-1] for name in sines.outputs]).T
        # the fundamental of the straight lines between samples
        amplitude = sines.amplitude * float(np.sinc(1 / SAMPLES)) ** 2
        mean = np.zeros(len(sines.outputs))
        before, spectrum = (_Spectrum(p, amplitude, mean) for p in np.split(values, periods)[-2:])
        settled = spectrum.agrees(before)
        if settled or periods >= sines.most_periods:
            return _SineResponse(
                spectrum.gain, spectrum.distortion, spectrum.shift, periods, settled
            )
        periods = min(2 * periods, sines.most_periods)


def _collected(
    answers: Sequence[_SineResponse],
    sines: Sines,
    model: str,
    units: Mapping[str, str],
    linear: LinearModel | None,
) -> FrequencyResponse:
    return FrequencyResponse(
        model,
        sines.input,
        sines.outputs,
        {name: units.get(name, "") for name in (sines.input, *sines.outputs)},
        sines.amplitude,
        np.array(sines.frequencies),
        np.array([a.gain for a in answers]),
        np.array([a.distortion for a in answers]),
        np.array([a.shift for a in answers]),
        np.array([a.periods for a in answers]),
        np.array([a.settled for a in answers]),
        linear,
    )
