"""Masses that move with the load, with their weight or without. Positive forces oppose contraction."""

from __future__ import annotations

from rig.effect import Effect, law


@law
class HangingMass(Effect):
    """The rig's own moving mass hangs on the muscle too: inertia and weight."""

    form = "hanging"
    m: float = 0.8  # kg

    def hanging_mass(self) -> float:
        return self.m


@law
class BalancedMass(Effect):
    """Inertia without weight."""

    form = "balanced"
    m: float = 3.0  # kg

    def balanced_mass(self, x: float) -> float:
        return self.m
