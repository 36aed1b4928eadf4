"""Gas that gets out."""

from __future__ import annotations

from math import tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import CP, P_ATM, T_ATM


@law
class DissolvedGas(Effect):
    """Gas dissolves in a bladder of silicone or latex, diffuses through and comes off outside: 2 G (p - c) goes in.

    State: c, the pressure with which the middle of the wall would be in balance, tau c' = p + p_atm - 2 c; what
    permeates is G (p - p_atm) once it has settled. Source: R. M. Barrer, Permeation, diffusion and solution of gases in
    organic polymers, Trans. Faraday Soc. 35 (1939) 628, in one lump.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-1,)
    conductance: float = 2e-11  # kg/(s Pa)
    tau: float = 1.5  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM,)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = 2 * self.conductance * (p - q[0])
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.p_gauge + 2 * P_ATM - 2 * q[0]) / self.tau,)


@law
class PoppingSeal(Effect):
    """A seal that pops open at a pressure and shuts again at a lower one: G p s, s towards 0 or 1 in 30 ms.

    s' = ((1 + tanh((p - p_0 + b p_0 (s - 1/2))/w))/2 - s)/30 ms, w = b p_0/8: once it is open the flow holds it, as the
    huddling chamber of a relief valve does. Source: API Standard 520 on blowdown; the law is reasoned.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    conductance: float = 3e-11  # kg/(s Pa)
    p_0: float = 5e4  # Pa, in the middle of both
    b: float = 0.3  # difference of both by p_0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        over = now.p_gauge - self.p_0 + self.b * self.p_0 * (q[0] - 0.5)
        return (((1 + tanh(over / (self.b * self.p_0 / 8))) / 2 - q[0]) / 0.03,)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.conductance * (p - P_ATM) * q[0]
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)
