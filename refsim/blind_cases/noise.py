"""What sensors add: white or coloured noise, dropouts, outliers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass

import numpy as np

Random = np.random.Generator
Array = np.ndarray
SIGNALS = ("p", "x", "T")
USUAL = {"p": 500.0, "x": 0.2e-3, "T": 0.3, "F": 1.0, "p_1": 500.0, "p_2": 500.0}  # Pa, m, K, N


_FAR = 7.0  # standard deviations; outliers begin at 8


@dataclass(frozen=True)
class Sensors:
    """How the instruments of one case misbehave.

    Attributes:
        sigma: standard deviation of the noise by signal [SI], but for outliers and what wanders.
        colour: white, ar1 (`memory` is the correlation of neighbours) or drift (white and a slow wander of
            `wander` standard deviations, root mean square).
        dropouts: share of samples that are missing, singly and in gaps.
        outliers: share of samples that are off by 8 to 25 standard deviations.
        stated: whether experiment.toml states sigma.
    """

    sigma: dict[str, float]
    colour: str
    memory: float = 0.0
    wander: float = 0.0
    dropouts: float = 0.0
    outliers: float = 0.0
    stated: bool = True

    def as_dict(self) -> dict[str, object]:
        """For the case's description."""
        return asdict(self)

    def without_outliers(self, name: str, error: Array) -> Array:
        """Errors of a signal's readings but for those that only an outlier is as large as."""
        return error[np.abs(error) < _FAR * self.sigma[name]] if self.outliers else error


def draw_sensors(rng: Random, signals: Sequence[str] = SIGNALS) -> Sensors:
    """65 % white, 25 % AR(1), 10 % with drift; a fifth with dropouts, 15 % with outliers, three quarters stated."""
    loud = float(np.exp(rng.uniform(np.log(0.4), np.log(2.5))))
    sigma = {name: float(f"{USUAL[name] * loud * rng.uniform(0.7, 1.4):.3g}") for name in signals}
    draw = rng.random(5)
    colour = "white" if draw[0] < 0.65 else "ar1" if draw[0] < 0.9 else "drift"
    memory, wander = round(float(rng.uniform(0.3, 0.9)), 3), round(float(rng.uniform(0.2, 0.5)), 3)
    dropouts, outliers = (
        round(float(rng.uniform(0.01, 0.06)), 4),
        round(float(rng.uniform(0.001, 0.01)), 5),
    )
    return Sensors(
        sigma,
        colour,
        memory if colour == "ar1" else 0.0,
        wander if colour == "drift" else 0.0,
        dropouts if draw[1] < 0.2 else 0.0,
        outliers if draw[2] < 0.15 else 0.0,
        bool(draw[3] < 0.75),
    )


def disturb(rng: Random, sensors: Sensors, clean: dict[str, Array]) -> dict[str, Array]:
    """What is recorded; NaN where a sample is missing. clean: signals of one run, arrays of one shape (times,)."""
    return {
        name: _disturbed(rng, sensors, clean[name], sensors.sigma[name]) for name in sensors.sigma
    }


def _disturbed(rng: Random, sensors: Sensors, clean: Array, sigma: float) -> Array:
    count = len(clean)
    noise = rng.standard_normal(count)
    if sensors.colour == "ar1":
        step = np.sqrt(1 - sensors.memory**2)
        for k in range(1, count):
            noise[k] = sensors.memory * noise[k - 1] + step * noise[k]
    elif sensors.colour == "drift":
        noise += sensors.wander * _wander(rng, count)
    if sensors.outliers:
        hit = rng.random(count) < sensors.outliers
        noise += hit * rng.choice([-1.0, 1.0], count) * rng.uniform(8.0, 25.0, count)
    seen = clean + sigma * noise
    if sensors.dropouts:
        seen[rng.random(count) < sensors.dropouts / 2] = np.nan
        gap = int(rng.integers(0, max(1, count - 60)))
        seen[gap : gap + max(3, round(sensors.dropouts / 2 * count))] = np.nan
    return seen


def _wander(rng: Random, count: int) -> Array:
    """A slow curve of root mean square one: three sines of less than 1.5 periods in the run."""
    place = np.arange(count) / count
    curve = sum(
        rng.standard_normal() * np.sin(2 * np.pi * (rng.uniform(0.2, 1.5) * place + rng.random()))
        for _ in range(3)
    )
    return np.asarray(curve / np.sqrt(np.mean(np.square(curve))))
