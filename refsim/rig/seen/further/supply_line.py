"""Lines between valves and muscle."""

from __future__ import annotations

from math import sqrt

from rig.catalogue.supply_line import Tube
from rig.effect import law
from rig.flow import P_ATM


@law
class CoiledHose(Tube):
    """A spiral hose, whose flow turns over as it goes: p_a^2 - p_b^2 = 2 p_atm m (1 + (|m|/m_0)^(1/2))/G.

    In coils the friction factor is that of the straight tube times a number that goes with the root of Dean's. Source:
    W. R. Dean, Phil. Mag. 5 (1928) 673; C. M. White, Proc. R. Soc. Lond. A 123 (1929) 645; the sum of both limits is
    reasoned.
    """

    conductance: float = 6e-9  # kg/(s Pa)
    m_0: float = 1e-4  # kg/s

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        laminar = self.conductance * (p_a * p_a - p_b * p_b) / (2 * P_ATM)
        size = abs(laminar) / self.m_0  # = y^2 + y^3 with the root y of |m|/m_0
        y = min(sqrt(size), float(size ** (1 / 3)))
        for _ in range(6):  # Newton's steps, from above
            if y > 1e-12:
                y -= (y * y * (1 + y) - size) / (y * (2 + 3 * y))
        flow = self.m_0 * y * y
        return flow if laminar > 0 else -flow


@law
class FlowLimiter(Tube):
    """A flow limiter with a rubber lip, which narrows as the drop grows: m_max u/sqrt(u^2 + p_l^2) either way.

    u = (p_a^2 - p_b^2)/(2 p_atm); beyond p_l the flow hardly grows any more. Source: data sheets of constant-flow
    restrictors; the law is reasoned.
    """

    m_max: float = 3e-4  # kg/s
    p_l: float = 4e4  # Pa

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        u = (p_a * p_a - p_b * p_b) / (2 * P_ATM)
        return self.m_max * u / sqrt(u * u + self.p_l * self.p_l)
