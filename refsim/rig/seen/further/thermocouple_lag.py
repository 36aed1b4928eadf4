"""Thermometers that come late."""

from __future__ import annotations

from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import T_ATM

_CELLS = 3


@law
class FlushedProbe(Effect):
    """The bead sits in a bore that passing gas flushes, three cells in a row: T_i' = (T_(i-1) - T_i) f/tau.

    f = 0.2 + |m|/m_0: nearly nothing moves while there is no flow. Source: tanks in series, O. Levenspiel, Chemical
    Reaction Engineering (1972), chapter 9; the bore is reasoned.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,) * _CELLS
    tau: float = 0.05  # s
    m_0: float = 5e-5  # kg/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * _CELLS

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flushed = 0.2 + sqrt(now.net_mass_flow**2 + 1e-16) / self.m_0
        before = (now.temperature, *q[:-1])
        return tuple((a - b) * flushed / self.tau for a, b in zip(before, q, strict=True))

    def reading(self, q: State, temperature: float) -> float:
        return q[-1]


@law
class TouchingBead(Effect):
    """The bead touches the bladder: tau T' = T_gas - T + c (T_w - T), the spot warms: tau_w T_w' = T - 2 T_w + T_atm.

    Slow changes are shown short by c/(2 + c), quick ones by c/(1 + c). States: bead and spot. Source: contact error of
    thermometers, R. J. Moffat, Gas temperature measurement (1962); two lumps reasoned.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    tau: float = 0.15  # s
    c: float = 0.2
    tau_w: float = 2.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature, (rest.temperature + T_ATM) / 2)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        bead = now.temperature - q[0] + self.c * (q[1] - q[0])
        return bead / self.tau, (q[0] - 2 * q[1] + T_ATM) / self.tau_w

    def reading(self, q: State, temperature: float) -> float:
        return q[0]
