"""Gas that takes no part in contraction."""

from __future__ import annotations

from math import tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import CP, GAMMA, P_ATM, T_ATM, R


@law
class SpringPiston(Effect):
    """A side chamber that a piston on a spring enlarges between two pressures: V (1 + e (1 + tanh((p - p_1)/w))/2).

    p is gauge, w = p_1/2: below the spring's preload the piston rests, at its stop it rests again, as in a pressure
    switch or a spring accumulator. States: pressure and mass, P' (V + gamma P dV/dP) = (gamma - 1) enthalpy. Source:
    first law for an open volume that works against the spring; accumulators in H. E. Merritt, Hydraulic Control Systems
    (1967).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-1, 1e-12)
    volume: float = 1e-5  # m3, of the chamber with the piston at its near end
    e: float = 1.0  # what the piston's stroke adds, by volume
    p_1: float = 6e4  # Pa
    conductance: float = 1e-8  # kg/(s Pa)

    def _volume(self, p: float) -> tuple[float, float]:
        """Volume [m3] and its slope [m3/Pa] at absolute pressure p [Pa]."""
        t = tanh((p - P_ATM - self.p_1) / (self.p_1 / 2))
        slope = self.volume * self.e * (1 - t * t) / self.p_1
        return self.volume * (1 + self.e * (1 + t) / 2), slope

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return P_ATM, P_ATM * self._volume(P_ATM)[0] / (R * T_ATM)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.conductance * (p - q[0])
        inside = q[0] * self._volume(q[0])[0] / (R * max(q[1], 1e-12))
        return flow, CP * flow * (temperature if flow > 0 else inside)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flow, enthalpy = self.exchange(q, now.p_gauge + P_ATM, now.temperature)
        volume, slope = self._volume(q[0])
        return (GAMMA - 1) * enthalpy / (volume + GAMMA * q[0] * slope), flow


@law
class Sorbent(Effect):
    """A side cartridge with drying agent, which holds more gas than its room: pores, and a layer that fills by tau.

    The layer takes b times the pores' content at ambient pressure to first order and saturates by Langmuir,
    a = b m_atm r/(1 + c (r - 1)) with r = p/p_atm, s' = (a - s)/tau; the grains keep the gas at ambient temperature.
    States: gas in the pores, gas in the layer. Source: I. Langmuir, J. Am. Chem. Soc. 40 (1918) 1361; linear driving
    force by E. Glueckauf, Trans. Faraday Soc. 51 (1955) 1540.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-12)
    volume: float = 1e-5  # m3, of the pores
    b: float = 1.0
    c: float = 0.3
    tau: float = 0.3  # s
    conductance: float = 1e-8  # kg/(s Pa)

    @property
    def _ambient(self) -> float:
        """Gas in the pores at ambient pressure [kg]."""
        return P_ATM * self.volume / (R * T_ATM)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return self._ambient, self.b * self._ambient

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.conductance * (p - P_ATM * q[0] / self._ambient)
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flow = self.exchange(q, now.p_gauge + P_ATM, now.temperature)[0]
        ratio = max(q[0] / self._ambient, 1e-3)
        held = self.b * self._ambient * ratio / (1 + self.c * (ratio - 1))
        taken = (held - q[1]) / self.tau
        return flow - taken, taken
