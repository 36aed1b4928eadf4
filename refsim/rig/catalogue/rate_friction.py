"""Friction that grows with the speed. Positive forces oppose contraction."""

from __future__ import annotations

from dataclasses import replace
from math import pi, pow

from rig.effect import Effect, State, law


@law
class Viscous(Effect):
    """Viscous friction c v."""

    form = "viscous"
    c: float = 300.0  # N s/m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v


@law
class PressureViscous(Effect):
    """Friction in proportion to gauge pressure and speed: c p_gauge v."""

    form = "pressure"
    c: float = 3.0e-3  # N s/(m Pa)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * p_gauge * v


@law
class PowerViscous(Effect):
    """Friction c |v|^a sign(v), made differentiable at rest: c v (v^2 + eps^2)^((a-1)/2)."""

    form = "power"
    c: float = 60.0  # N (s/m)^a
    a: float = 0.5
    eps: float = 1e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * pow(v * v + self.eps * self.eps, (self.a - 1) / 2)


@law
class LoadRate(Effect):
    """Friction ab F v/L0 with the muscle's pull F (Dzahir and Yamamoto)."""

    form = "load_rate"
    ab: float = 0.5  # s
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        pull = p_gauge * (3 * length * length - self.fibre_squared) / (4 * pi * self.turns**2)
        return self.ab * max(pull, 0.0) * v / self.length


@law
class LoadFrequency(Effect):
    """Friction ab W f v/L0 by the weight W and the frequency f of the run (Dzahir and Yamamoto (10)-(11))."""

    form = "load_frequency"
    ab: float = 0.15  # s2
    length: float = 0.3  # m
    damping: float = 0.0  # N s/m, in the run that it is in

    def in_run(self, weight: float, frequency: float) -> LoadFrequency:
        return replace(self, damping=self.ab * weight * frequency / self.length)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.damping * v
