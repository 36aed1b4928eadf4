"""Rubber that relaxes: forces that fade while the contraction is held. Positive forces oppose contraction."""

from __future__ import annotations

from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law


@law
class Creep(Effect):
    """A spring that relaxes (Maxwell element): k (x - q) with q' = (x - q)/tau."""

    form = "maxwell"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 1.5  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.x - q[0]) / self.tau,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@law
class Prony(Effect):
    """Two Maxwell elements whose times lie a decade apart."""

    form = "prony"
    atol: ClassVar[tuple[float, ...]] = (1e-10, 1e-10)
    k: float = 300.0  # N/m, of the fast one
    ratio: float = 1.0  # stiffness of the slow one by that of the fast one
    tau: float = 0.8  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x, rest.x)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.x - q[0]) / self.tau, (now.x - q[1]) / (10 * self.tau))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0] + self.ratio * (x - q[1]))
