"""How large an effect is, in standard deviations of the noise, before and after the base parameters made up for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

Array = np.ndarray
Signals = dict[str, Array]
_UNSEEN = 0.05  # standard deviations: a four-hundredth of the noise's variance
_STEP = 0.02  # of the range of a parameter
_REFITS, _GAIN = 15, 0.7  # steps, and the share of the squares that each may leave


@dataclass(frozen=True)
class FreeParameter:
    """A base parameter that experiment.toml leaves free.

    Attributes:
        name: as the bench calls it. field: as the simulator calls it.
        low, high, true: bounds and truth [SI]. nominal: the value in [parameters] from which a fit starts; None
            where the bench's own default is the start.
    """

    name: str
    field: str
    low: float
    high: float
    true: float
    nominal: float | None = None


def joined(signals: Sequence[Signals], name: str) -> Array:
    """One signal over all runs, shape (samples,)."""
    return np.concatenate([run[name] for run in signals])


class Measured(Protocol):
    """What a `Ruler` needs of a rig."""

    @property
    def free(self) -> tuple[FreeParameter, ...]:
        """Base parameters that may move."""

    @property
    def signals(self) -> tuple[str, ...]:
        """Names of what is measured."""

    def simulate(
        self, effects: Sequence[Any] = (), changed: Mapping[str, float] | None = None
    ) -> list[Signals]:
        """Noise-free signals of every run."""

    def roles(self) -> Array:
        """For every sample whether it is of role fit."""


class Ruler:
    """Measures effects against the base simulation of a bench and its sensitivities, which it makes once."""

    def __init__(self, bench: Measured) -> None:
        self.bench = bench
        self.base = bench.simulate()
        self._seen: dict[Any, list[Signals]] = {}
        self._slopes: list[list[Signals]] = []
        for p in bench.free:
            step = _STEP * (p.high - p.low)
            self._slopes.append(bench.simulate((), {p.field: p.true + step}))

    def sizes(
        self, with_effect: Sequence[Signals], sigma: Mapping[str, float]
    ) -> tuple[dict[str, float], ...]:
        """Root mean square differences by signal in sigma: plain, and what the free parameters cannot make up for.

        The free parameters move linearly, to fit the runs of role fit best; all runs are then counted.
        """
        count, names = len(self.bench.roles()), self.bench.signals
        away = np.concatenate(
            [(joined(with_effect, n) - joined(self.base, n)) / sigma[n] for n in names]
        )
        slopes = np.stack(
            [
                np.concatenate([(joined(s, n) - joined(self.base, n)) / sigma[n] for n in names])
                for s in self._slopes
            ],
            axis=1,
        )
        fitted = np.tile(self.bench.roles(), len(names))
        moved = np.linalg.lstsq(slopes[fitted], away[fitted], rcond=1e-8)[0]
        left = away - slopes @ moved
        return tuple(
            {
                n: float(np.sqrt(np.mean(v[k * count : (k + 1) * count] ** 2)))
                for k, n in enumerate(names)
            }
            for v in (away, left)
        )

    def size_if_imitated(self, effect: Any, sigma: Mapping[str, float]) -> float | None:
        """What is left of an effect once free parameters have moved within their bounds; None: some could see it.

        The projected size is that of slopes: what is left may be their curvature alone. Broyden's method follows it,
        for as long as it gains.
        """
        free, names = self.bench.free, self.bench.signals
        fitted = np.tile(self.bench.roles(), len(names))
        seen, spans = self.simulated([effect]), np.array([p.high - p.low for p in free])

        def away(base: Sequence[Signals]) -> Array:
            return np.concatenate([(joined(seen, n) - joined(base, n)) / sigma[n] for n in names])

        low, high = np.array([(p.low, p.high) for p in free]).T / spans
        place, left = np.array([p.true for p in free]) / spans, away(self.base)
        slopes = np.stack([away(s) - left for s in self._slopes], axis=1) / _STEP
        for _ in range(_REFITS):
            step = np.linalg.lstsq(slopes[fitted], -left[fitted], rcond=1e-8)[0]
            step = np.clip(place + step, low, high) - place
            changed = {p.field: float(v) for p, v in zip(free, (place + step) * spans, strict=True)}
            try:
                then = away(self.bench.simulate((), changed))
            except RuntimeError:
                return None
            if not then[fitted] @ then[fitted] < _GAIN * (left[fitted] @ left[fitted]):
                return None
            slopes += np.outer(then - left - slopes @ step, step) / (step @ step)
            place, left = place + step, then
            size = float(np.sqrt(np.mean(left.reshape(len(names), -1) ** 2, axis=1)).max())
            if size < _UNSEEN:
                return size
        return None

    def simulated(self, effects: Sequence[Any]) -> list[Signals]:
        """As the bench's own, without doing the same work twice. Raises RuntimeError as that does."""
        if len(effects) != 1:
            return self.bench.simulate(effects)
        if effects[0] not in self._seen:
            self._seen[effects[0]] = self.bench.simulate(effects)
        return self._seen[effects[0]]

    def size(self, effect: Any, sigma: Mapping[str, float]) -> float:
        """The projected size on the signal that shows the effect most."""
        return max(self.sizes(self.simulated([effect]), sigma)[1].values())


def calibrated(
    ruler: Ruler,
    make: Callable[[float], Any],
    sigma: Mapping[str, float],
    target: float,
    low: float,
    high: float,
) -> tuple[float, float]:
    """Strength within [low, high] at which the projected size is near `target`, and the size there.

    Up to four simulations of the plan; within 20 % of the target where the bounds allow it. A strength that cannot be
    simulated is quartered. Raises RuntimeError when nothing can be simulated.
    """
    seen: list[tuple[float, float]] = []
    strength = min(max(1.0, low), high)
    for _ in range(5):
        try:
            seen.append((strength, max(ruler.size(make(strength), sigma), 1e-9)))
        except (RuntimeError, OverflowError, ZeroDivisionError, ValueError):
            high = strength
            strength = max(strength / 4, low)
            continue
        if abs(np.log(seen[-1][1] / target)) < 0.2 or len(seen) == 3:
            break
        power = 1.0
        if len(seen) > 1 and seen[-1][0] != seen[-2][0]:
            power = float(np.log(seen[-1][1] / seen[-2][1]) / np.log(seen[-1][0] / seen[-2][0]))
        proposed = strength * (target / seen[-1][1]) ** (1 / min(max(power, 0.4), 3.0))
        proposed = float(min(max(proposed, low), high))
        if proposed == strength:
            break
        strength = proposed
    if not seen:
        raise RuntimeError("no strength of this effect can be simulated")
    return min(seen, key=lambda pair: abs(np.log(pair[1] / target)))
