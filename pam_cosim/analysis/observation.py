"""The product of an observer: estimates over time with their uncertainty, and whether that can be believed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.special import chdtri, ndtri

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.exports import Exported, Table, headed
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, did_you_mean

LEVEL = 0.95
DEVIATIONS = float(ndtri((1 + LEVEL) / 2))  # half the width of a band of that probability


@dataclass(frozen=True)
class Error:
    """Of one estimate against what was true.

    Attributes:
        rms, bias, max: [unit].
        nees: mean of the squared error by the estimated variance; 1 where the uncertainty is right.
        inside: share of samples within the interval of 95 %.
    """

    rms: float
    bias: float
    max: float
    nees: float
    inside: float


@dataclass(frozen=True)
class Observation(Printed, Exported):
    """Estimates from measurements by an extended Kalman filter, each after the sample of its time was taken in.

    Attributes:
        model: its name.
        time: (N,) [s].
        values: by name (N,): states, unknown inputs and outputs [``units``].
        deviations: by name (N,): standard deviations.
        units: by name.
        outputs: names of what was requested.
        measured: by name (N,), not a number where a sample is missing.
        innovations: by name (N,): measurement less prediction, by its standard deviation.
        sizes: (N, 3) normalised innovation squared of all signals together, how many they were, and the logarithm of
            the determinant of their covariance.
        truth: by name (N,): what was true, where that is known.
        begins: where the recording begins, as far as that is elsewhere than the model does by itself.
    """

    json_keys = "model units outputs time values deviations consistency=_consistency errors"

    model: str
    time: Array
    values: dict[str, Array]
    deviations: dict[str, Array]
    units: dict[str, str]
    outputs: tuple[str, ...]
    measured: dict[str, Array]
    innovations: dict[str, Array]
    sizes: Array
    truth: dict[str, Array] = field(default_factory=dict)
    begins: str = ""

    def __getitem__(self, name: str) -> Array:
        return self.values[name]

    @property
    def nis(self) -> float:
        """Mean normalised innovation squared by measurement: 1 where the filter's uncertainty is right."""
        count = float(self.sizes[:, 1].sum())
        return float(self.sizes[:, 0].sum()) / count if count else float("nan")

    @property
    def nis_range(self) -> tuple[float, float]:
        """In which ``nis`` lies with 95 % probability if what the filter assumes is true."""
        count = float(self.sizes[:, 1].sum())
        if not count:
            return float("nan"), float("nan")
        low, high = chdtri(count, [(1 + LEVEL) / 2, (1 - LEVEL) / 2])  # by the probability above
        return float(low / count), float(high / count)

    @property
    def is_consistent(self) -> bool:
        """Whether ``nis`` lies in its range."""
        low, high = self.nis_range
        return low <= self.nis <= high

    @property
    def log_likelihood(self) -> float:
        """Of the measurements, given the settings of the filter: larger for settings that explain them better."""
        squared, count, determinant = self.sizes.sum(axis=0)
        return float(-0.5 * (squared + determinant + count * np.log(2 * np.pi)))

    @property
    def whiteness(self) -> dict[str, float]:
        """Correlation of neighbouring innovations by signal: near zero where nothing predictable is left."""
        return {name: _neighbours(values) for name, values in self.innovations.items()}

    def with_truth(self, truth: Mapping[str, Array]) -> Observation:
        """With what was true at the same times.

        Raises:
            InputError: of something that was not estimated, or at other times.
        """
        for name, values in truth.items():
            if name not in self.values:
                raise InputError(f"'{name}' was not estimated; {did_you_mean(name, self.values)}")
            if np.shape(values) != self.time.shape:
                raise InputError(
                    f"'{name}' has {np.size(values)} values for {self.time.size} times"
                )
        return replace(
            self, truth={**self.truth, **{n: np.asarray(v, dtype=float) for n, v in truth.items()}}
        )

    def errors(self, since: float = 0.0) -> dict[str, Error]:
        """By name, where the truth is known, from a time [s] on: before, the start still counts."""
        return {name: self._error(name, self.time >= self.time[0] + since) for name in self.truth}

    def _error(self, name: str, chosen: Array) -> Error:
        off = (self.values[name] - self.truth[name])[chosen]
        size = self.deviations[name][chosen]
        return Error(
            float(np.sqrt(np.mean(off**2))),
            float(off.mean()),
            float(np.abs(off).max()),
            float(np.mean((off / size) ** 2)),
            float(np.mean(np.abs(off) <= DEVIATIONS * size)),
        )

    @property
    def _consistency(self) -> dict[str, object]:
        low, high = self.nis_range
        return {
            "nis": self.nis,
            "low": low,
            "high": high,
            "consistent": self.is_consistent,
            "log_likelihood": self.log_likelihood,
            "whiteness": self.whiteness,
        }

    def table(self) -> Table:
        """Each estimate and its standard deviation, a row for each sample."""
        heads, columns = ["time [s]"], [self.time]
        for name, values in self.values.items():
            unit = self.units[name]
            heads += [headed(name, unit), headed(f"{name} standard deviation", unit)]
            columns += [values, self.deviations[name]]
        return heads, zip(*columns, strict=True)

    def _lines(self) -> list[str]:
        lines = []
        for name in self.outputs:
            unit = self.units[name]
            last, around = (
                format_quantity(float(v[name][-1]), unit, 4) for v in (self.values, self.deviations)
            )
            middle = format_quantity(float(np.median(self.deviations[name])), unit)
            lines.append(
                f"{name}: {last} ± {around} at the end, standard deviation {middle} as a rule"
            )
        low, high = self.nis_range
        verdict = (
            "consistent"
            if self.is_consistent
            else "too sure of itself"
            if self.nis > high
            else "too unsure"
        )
        lines.append(
            f"innovations squared by measurement: {self.nis:.3f}, 95 %: {low:.3f} to {high:.3f}: {verdict}"
        )
        parts = [f"{name} {value:.2f}" for name, value in self.whiteness.items()]
        lines.append(f"correlation of neighbouring innovations: {', '.join(parts)}")
        for name, error in self.errors().items():
            rms, worst = (format_quantity(v, self.units[name]) for v in (error.rms, error.max))
            lines.append(
                f"{name} against the truth: rms {rms}, at most {worst}, error squared by variance {error.nees:.2f}, "
                f"{error.inside:.0%} within the interval of {LEVEL:.0%}"
            )
        return lines

    def __str__(self) -> str:
        span = f"{len(self.time)} samples from {self.time[0]:g} s to {self.time[-1]:g} s"
        begins = [self.begins] if self.begins else []
        return "\n".join(
            [f"{self.model}, from {', '.join(self.measured)}: {span}", *begins, *self._lines()]
        )


def _neighbours(values: Array) -> float:
    earlier, later = values[:-1], values[1:]
    is_pair = np.isfinite(earlier) & np.isfinite(later)
    size = float(np.sum(values[np.isfinite(values)] ** 2))
    return float(np.sum(earlier[is_pair] * later[is_pair]) / size) if size > 0 else float("nan")
