"""An extended Kalman filter on an FMU: the model between samples, its exact derivatives for the covariance.

Continuous model and discrete samples (Jazwinski 1970, section 8.3; Simon 2006, section 13.2.3). Unmeasured inputs are
states without dynamics, driven by noise: random walks.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import block_diag, expm

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.analysis.flow import flow
from pam_cosim.analysis.observation import Observation
from pam_cosim.analysis.operating_point import go_to_state
from pam_cosim.arrays import Array

# Standard deviations carried over in so many pieces and in twice as many differ by less than this part.
_ALIKE = 0.01
_MOST_PIECES = 32
_TOLERANCE = 1e-6  # of the states between samples, far below what sensors resolve
_SMALL = 0.5  # norm of a matrix whose exponential needs no care


@dataclass(frozen=True)
class RecordedSamples:
    """What was recorded.

    Attributes:
        times: (N,) [s].
        inputs: name to (N,) [SI]; inputs that are not there are held at their values at the start.
        measured: name to (N,) [SI], not a number where a sample is missing.
        held: whether inputs are held from one row to the next, rather than joined by lines.
    """

    times: Array
    inputs: Mapping[str, Array]
    measured: Mapping[str, Array]
    held: bool


@dataclass(frozen=True)
class Belief:
    """Settings of the filter; all [SI].

    Attributes:
        noise: standard deviation of each measured signal.
        unknown: unmeasured inputs: standard deviation at the start, and of its change within a second.
        drift: standard deviation of what the model does not know of a state, within a second.
        spread: standard deviation of a state at the start; else a hundredth of its nominal size.
        start: values at the start, by the name of any variable.
    """

    noise: Mapping[str, float]
    unknown: Mapping[str, tuple[float, float]]
    drift: Mapping[str, float]
    spread: Mapping[str, float]
    start: Mapping[str, float]


UNTOLD_SPREAD = 0.01  # of the nominal size


def observe_samples(
    model: ExchangeModel,
    parameters: Mapping[str, float],
    samples: RecordedSamples,
    belief: Belief,
    outputs: Sequence[str],
) -> Observation:
    """Filters all samples in their order."""
    model.restart(parameters, float(samples.times[0]))
    model.check([*outputs, *samples.measured])
    go_to_state(model, belief.start)
    filtered = _Filter(model, belief, list(samples.measured))
    input_functions = _input_functions(model, samples)
    rows = []
    for k, time in enumerate(samples.times):
        if k and time > samples.times[k - 1]:
            filtered.predict(float(samples.times[k - 1]), float(time), input_functions(k - 1))
        reading = np.array([values[k] for values in samples.measured.values()])
        innovation, sizes = filtered.update(float(time), input_functions(k)(float(time)), reading)
        rows.append((*filtered.estimate(outputs), innovation, sizes))
    columns = list(zip(*rows, strict=True))
    values, deviations, innovations, sizes = map(np.array, columns)
    names = [*filtered.names, *outputs]
    return Observation(
        model.interface.model,
        samples.times,
        {name: values[:, i] for i, name in enumerate(names)},
        {name: deviations[:, i] for i, name in enumerate(names)},
        {name: model.unit(name) for name in (*names, *samples.measured)},
        tuple(outputs),
        {name: np.asarray(column) for name, column in samples.measured.items()},
        {name: innovations[:, i] for i, name in enumerate(samples.measured)},
        sizes,
    )


def _input_functions(
    model: ExchangeModel, samples: RecordedSamples
) -> Callable[[int], Callable[[float], Array]]:
    """For each interval the inputs over time."""
    names, base = list(model.interface.inputs), model.inputs()
    table = np.tile(base, (len(samples.times), 1))
    for name, values in samples.inputs.items():
        table[:, names.index(name)] = values

    def interval(k: int) -> Callable[[float], Array]:
        last = min(k + 1, len(table) - 1)
        begin, end = samples.times[k], samples.times[last]
        if samples.held or not end > begin:
            return lambda _: table[k]
        slope = (table[last] - table[k]) / (end - begin)
        return lambda t: np.asarray(table[k] + slope * (t - begin))

    return interval


class _Filter:
    """Mean and covariance of the states and of the unmeasured inputs."""

    def __init__(self, model: ExchangeModel, belief: Belief, measured: list[str]) -> None:
        self.model, self.measured = model, measured
        self.unknown = list(belief.unknown)
        self.names = [*model.states, *self.unknown]
        self._places = [list(model.interface.inputs).index(name) for name in self.unknown]
        self._scale = np.array(
            [model.scale(name) for name in model.states] + [1.0] * len(self.unknown)
        )
        self.mean = np.append(model.state(), model.values(self.unknown))
        spread = [belief.spread.get(n, UNTOLD_SPREAD * model.scale(n)) for n in model.states]
        self.covariance = np.diag(
            np.square([*spread, *(start for start, _ in belief.unknown.values())])
        )
        drift = [belief.drift.get(n, 0.0) for n in model.states] + [
            rate for _, rate in belief.unknown.values()
        ]
        self._power = np.diag(np.square(drift))
        self._noise = np.square([belief.noise[name] for name in measured])

    def _inputs(self, known_inputs: Array) -> Array:
        all_inputs = known_inputs.copy()
        all_inputs[self._places] = self.mean[len(self.model.states) :]
        return all_inputs

    def _go(self, time: float, known_inputs: Array) -> None:
        self.model.set(time, self.mean[: len(self.model.states)], self._inputs(known_inputs))

    def predict(self, begin: float, end: float, inputs_at: Callable[[float], Array]) -> None:
        """To the next sample, in as many pieces as the covariance needs."""
        n, scale = len(self.model.states), self._scale[:, None] * self._scale
        start, power = self.covariance / scale, self._power / scale
        pieces, coarse = 2, None
        while True:
            times = np.linspace(begin, end, pieces + 1)
            states = flow(
                self.model, self.mean[:n], times, lambda t: self._inputs(inputs_at(t)), _TOLERANCE
            )
            slopes = [self._slope(t, states[:, i], inputs_at) for i, t in enumerate(times)]
            if coarse is None:
                coarse = carried(start, slopes[::2], power, end - begin)
            fine = carried(start, slopes, power, end - begin)
            sizes = [np.sqrt(np.diag(spread)) for spread in (coarse, fine)]
            if np.all(np.abs(sizes[0] - sizes[1]) <= _ALIKE * sizes[1]) or pieces >= _MOST_PIECES:
                break
            coarse, pieces = fine, 2 * pieces
        self.covariance = fine * scale
        self.mean = np.append(states[:, -1], self.mean[n:])

    def _slope(self, time: float, state: Array, inputs_at: Callable[[float], Array]) -> Array:
        """The Jacobian of the rates, in nominal sizes; the random walks have none."""
        self.model.set(time, state, self._inputs(inputs_at(time)))
        rows = self.model.jacobian(self.model.rate_names, self.names)[0]
        augmented = np.vstack([rows, np.zeros((len(self.unknown), len(self.names)))])
        return np.asarray(augmented * self._scale / self._scale[:, None])

    def update(self, time: float, known_inputs: Array, reading: Array) -> tuple[Array, Array]:
        """Takes a sample in; its innovations by their standard deviations (m,), and a row of ``Observation.sizes``."""
        self._go(time, known_inputs)
        seen = np.flatnonzero(np.isfinite(reading))
        normalised = np.full(len(reading), np.nan)
        if not seen.size:
            return normalised, np.zeros(3)
        names = [self.measured[i] for i in seen]
        slope = self.model.jacobian(names, self.names)[0]
        innovation = reading[seen] - self.model.values(names)
        noise = np.diag(self._noise[seen])
        expected = slope @ self.covariance @ slope.T + noise
        gain = np.linalg.solve(expected, slope @ self.covariance).T
        self.mean = self.mean + gain @ innovation
        complement = np.eye(len(self.mean)) - gain @ slope
        self.covariance = (
            complement @ self.covariance @ complement.T + gain @ noise @ gain.T
        )  # Joseph: stays a covariance
        normalised[seen] = innovation / np.sqrt(np.diag(expected))
        self._go(time, known_inputs)
        squared = float(innovation @ np.linalg.solve(expected, innovation))
        return normalised, np.array([squared, seen.size, np.linalg.slogdet(expected)[1]])

    def estimate(self, outputs: Sequence[str]) -> tuple[Array, Array]:
        """Values and standard deviations of the states, the unknown inputs and the outputs, where the model is."""
        slope = np.vstack([np.eye(len(self.names)), self.model.jacobian(outputs, self.names)[0]])
        values = np.append(self.mean, self.model.values(outputs))
        variance = np.einsum("ij,jk,ik->i", slope, self.covariance, slope)
        return values, np.sqrt(np.maximum(variance, 0.0))


def carried(covariance: Array, slopes: Sequence[Array], power: Array, span: float) -> Array:
    """Covariance (n, n) of the states after a time span.

    Args:
        covariance: (n, n) at the begin [SI^2].
        slopes: (n, n) each, derivatives of the rates by the states at evenly spaced times of the span [1/s].
        power: (n, n) power of the process noise [SI^2/s].
        span: duration [s].
    """
    for at_begin, at_end in zip(slopes, slopes[1:], strict=False):
        over, added = transition((at_begin + at_end) / 2, power, span / (len(slopes) - 1))
        covariance = over @ covariance @ over.T + added
    return covariance


def transition(slope: Array, power: Array, step: float) -> tuple[Array, Array]:
    """Transition matrix (n, n) of a linear system over a step, and the covariance (n, n) that white noise adds.

    Args:
        slope: (n, n) derivatives of the rates by the states [1/s].
        power: (n, n) power of the noise [SI^2/s].
        step: duration [s].

    By Van Loan's exponential over a small part of the step, doubled until it is whole: stiff systems do not overflow.
    """
    size = float(np.linalg.norm(slope, 1)) * step
    doublings = max(0, int(np.ceil(np.log2(max(size, _SMALL) / _SMALL))))
    part, n = step / 2**doublings, len(slope)
    blocks = block_diag(-slope, slope.T)
    blocks[:n, n:] = power
    exponential = expm(blocks * part)
    over = exponential[n:, n:].T
    added = over @ exponential[:n, n:]
    for _ in range(doublings):
        added = over @ added @ over.T + added
        over = over @ over
    return over, (added + added.T) / 2
