"""What a line of the table is made of: a form, the sets that it belongs to, and how it is drawn by its strength.

`make(rng, muscle)` draws what does not measure strength and returns a function from strength to effect; strength 1 is
an ordinary size, strength 0 would be none, and `low` and `high` are what physics and the catalogue's bounds allow.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from rig import catalogue
from rig.effect import Effect
from rig.muscle import MuscleParameters

SETS = ("tuning", "score")
Random = np.random.Generator
At = Callable[[float], Effect]
Make = Callable[[Random, MuscleParameters], At]


@dataclass(frozen=True)
class Form:
    """One line of the table.

    low, high: bounds of the strength. sign: whether half of the cases have a negative strength.
    """

    family: str
    name: str
    sets: tuple[str, ...]
    catalogue: bool
    make: Make
    low: float = 1e-4
    high: float = 12.0
    signed: bool = False


def spread(rng: Random, low: float, high: float) -> float:
    """Between low and high, evenly by order of magnitude."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def plain(
    kind: type[Effect], parameter: str, unit: float, /, **shapes: tuple[float, float]
) -> Make:
    """`parameter` = unit times strength; further parameters are drawn between bounds."""

    def make(rng: Random, muscle: MuscleParameters) -> At:
        drawn = {name: spread(rng, *bounds) for name, bounds in shapes.items()}
        return lambda s: kind(**{parameter: unit * s}, **drawn)

    return make


def braided(
    kind: type[Effect],
    parameter: str,
    unit: float,
    turns: bool = False,
    /,
    **shapes: tuple[float, float],
) -> Make:
    """As `plain`, with the muscle's geometry."""

    def make(rng: Random, muscle: MuscleParameters) -> At:
        drawn = {name: spread(rng, *bounds) for name, bounds in shapes.items()}
        braid = {"length": muscle.length, "fibre_squared": muscle.fibre_squared}
        if turns:
            braid["turns"] = muscle.turns
        return lambda s: kind(**{parameter: unit * s}, **braid, **drawn)

    return make


def excess(kind: type[Effect], parameter: str, unit: float) -> Make:
    """`parameter` = 1 + unit times strength."""
    return lambda rng, muscle: lambda s: kind(**{parameter: 1 + unit * s})


def tube(
    kind: type[Effect],
    parameter: str,
    unit: float,
    volume: tuple[float, float] | None,
    /,
    **shapes: tuple[float, float],
) -> Make:
    """A resistance that grows with strength; a volume that counts shrinks with a weak line, so that the line goes."""

    def make(rng: Random, muscle: MuscleParameters) -> At:
        drawn = 3e-7 if volume is None else spread(rng, *volume)
        further = {name: spread(rng, *bounds) for name, bounds in shapes.items()}

        def at(s: float) -> Effect:
            counted = drawn if volume is None else max(drawn * min(s, 2.0), 3e-7)
            return kind(**{parameter: unit / s, "volume": counted}, **further)

        return at

    return make


def fraction(kind: type[Effect], unit: float, /, **shapes: tuple[float, float]) -> Make:
    """A heat capacity that falls with strength, and the conductance to ambient that falls with it."""

    def make(rng: Random, muscle: MuscleParameters) -> At:
        drawn = {name: spread(rng, *bounds) for name, bounds in shapes.items()}
        return lambda s: kind(capacity=unit / s, **drawn)

    return make


def gas(kind: type[Effect], /, **shapes: tuple[float, float]) -> Make:
    """Without a strength: what remains is how loud the noise is."""

    def make(rng: Random, muscle: MuscleParameters) -> At:
        drawn = {name: spread(rng, *bounds) for name, bounds in shapes.items()}
        if kind is not catalogue.gas_energy.GasEnergy:  # whose h is that of films and wall together
            drawn["wall"] = muscle.t_wall / muscle.k_wall
        return lambda s: kind(**drawn)

    return make


def gas_form(
    name: str,
    sets: tuple[str, ...],
    catalogue: bool,
    kind: type[Effect],
    /,
    **shapes: tuple[float, float],
) -> Form:
    """A line of the family that has no strength."""
    return Form("gas_energy", name, sets, catalogue, gas(kind, **shapes), 1.0, 1.0)


def swing(kind: type[Effect], parameter: str, unit: float, frequency: tuple[float, float]) -> Make:
    """`parameter` = unit times strength; frequency and phase are drawn."""

    def make(rng: Random, muscle: MuscleParameters) -> At:
        shape = {"frequency": spread(rng, *frequency), "phase": rng.uniform(0.0, 6.28)}
        return lambda s: kind(**{parameter: unit * s}, **shape)

    return make
