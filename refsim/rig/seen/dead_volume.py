"""Gas that takes no part in contraction."""

from __future__ import annotations

from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import CP, CV, GAMMA, P_ATM, RHO, T_ATM, R, mass_flow

_LUMPS = 3


@law
class SideChamber(Effect):
    """A rigid side volume behind an opening, without heat exchange (states: mass, energy)."""

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 1e-5  # m3
    conductance: float = 2e-9  # kg/(s Pa)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM), P_ATM * self.volume / (GAMMA - 1))

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        p_side, t_side = (GAMMA - 1) * q[1] / self.volume, q[1] / (CV * q[0])
        flow = self.conductance * (p - p_side)
        return flow, CP * flow * (temperature if flow > 0 else t_side)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self.exchange(q, now.p_gauge + P_ATM, now.temperature)


@law
class CoolChamber(Effect):
    """A rigid side volume behind a wide opening whose walls keep the gas at ambient temperature (state: mass)."""

    atol: ClassVar[tuple[float, ...]] = (1e-12,)
    volume: float = 1e-5  # m3
    conductance: float = 1e-8  # kg/(s Pa)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM),)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.conductance * (p - q[0] * R * T_ATM / self.volume)
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (self.exchange(q, now.p_gauge + P_ATM, now.temperature)[0],)


@law
class Hose(Effect):
    """A soft hose as side volume, V (1 + e (p - p_atm)), behind a wide opening, without heat exchange.

    States: mass; energy of the gas and what the hose took up as elastic work, E = p V/(gamma - 1) + V_0 e p^2/2, which
    only flow changes. Hoses are sold with their expansion per pressure (SAE J1401 for those of brakes).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 1e-5  # m3, at ambient pressure
    expansion: float = 5e-6  # 1/Pa
    conductance: float = 1e-8  # kg/(s Pa)

    @property
    def _soft(self) -> float:
        return self.volume * self.expansion  # m3/Pa

    def initial(self, rest: Rest) -> tuple[float, ...]:
        energy = P_ATM * self.volume / (GAMMA - 1) + self._soft * P_ATM**2 / 2
        return (P_ATM * self.volume / (R * T_ATM), energy)

    def _gas(self, q: State) -> tuple[float, float]:
        """Pressure and temperature: E = p (V_0 - soft p_atm)/(gamma - 1) + soft p^2 (1/(gamma - 1) + 1/2)."""
        square = self._soft * (1 / (GAMMA - 1) + 0.5)
        linear = self.volume * (1 - self.expansion * P_ATM) / (GAMMA - 1)
        p = 2 * q[1] / (linear + sqrt(linear * linear + 4 * square * q[1]))
        return p, p * self.volume * (1 + self.expansion * (p - P_ATM)) / (R * q[0])

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        p_side, t_side = self._gas(q)
        flow = self.conductance * (p - p_side)
        return flow, CP * flow * (temperature if flow > 0 else t_side)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self.exchange(q, now.p_gauge + P_ATM, now.temperature)


@law
class DeadEnd(Effect):
    """A rigid dead end, as the tube to a gauge, whose gas takes the wall's temperature in tau (at ambient density).

    States: mass, energy. Filling warms it by compression, and the wall, at ambient temperature, cools it again, so that
    it goes on taking up gas. Source: first law for an open volume with a constant film.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 1e-5  # m3
    tau: float = 0.3  # s
    conductance: float = 1e-8  # kg/(s Pa)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        mass = RHO * self.volume
        return (mass, CV * mass * T_ATM)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.conductance * (p - R * q[1] / (CV * self.volume))
        return flow, CP * flow * (temperature if flow > 0 else q[1] / (CV * q[0]))

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flow, enthalpy = self.exchange(q, now.p_gauge + P_ATM, now.temperature)
        cooled = CV * RHO * self.volume / self.tau * (q[1] / (CV * q[0]) - T_ATM)
        return flow, enthalpy - cooled


@law
class OrificeChamber(Effect):
    """A rigid chamber behind a drilled hole, as the cavity of a T-piece; compressible flow, no heat exchange.

    States: mass, energy. Source: first law for an open volume; flow by A. de Saint-Venant and L. Wantzel (1839).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 1e-5  # m3
    area: float = 3e-7  # m2, effective

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM), P_ATM * self.volume / (GAMMA - 1))

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        t_side = max(q[1] / (CV * max(q[0], 1e-15)), 1.0)  # a solver's trial steps go anywhere
        flow = mass_flow(
            self.area, p, temperature, max((GAMMA - 1) * q[1] / self.volume, 1.0), t_side
        )
        return flow, CP * flow * (temperature if flow > 0 else t_side)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self.exchange(q, now.p_gauge + P_ATM, now.temperature)


@law
class CapillaryStub(Effect):
    """A thin dead-end tube, as that to a far gauge: gas spreads along it by laminar flow, at the wall's temperature.

    States: the masses in three equal lumps. Source: isothermal Poiseuille flow of a gas, as in S. Dushman, Scientific
    Foundations of Vacuum Technique (1962), in finite volumes.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-12,) * _LUMPS
    volume: float = 1e-5  # m3
    conductance: float = 1e-8  # kg/(s Pa), of the whole length

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / _LUMPS / (R * T_ATM),) * _LUMPS

    def _flows(self, q: State, p: float) -> tuple[float, ...]:
        """Into each lump from the one before [kg/s]; from the mouth to the first middle it is half as far."""
        pressures = [p, *(m * R * T_ATM * _LUMPS / self.volume for m in q)]
        steps = [self.conductance * _LUMPS * (2 if k == 0 else 1) for k in range(_LUMPS)]
        pairs = zip(steps, pressures[:-1], pressures[1:], strict=True)
        return tuple(g * (a * a - b * b) / (2 * P_ATM) for g, a, b in pairs)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self._flows(q, p)[0]
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flows = (*self._flows(q, now.p_gauge + P_ATM), 0.0)
        return tuple(a - b for a, b in zip(flows[:-1], flows[1:], strict=True))


@law
class Chamber(Effect):
    """A rigid side volume behind an opening; its gas gives ua (T - T_atm) to its wall (states: mass, energy)."""

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 3e-5  # m3
    conductance: float = 3e-9  # kg/(s Pa)
    ua: float = 0.0  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return P_ATM * self.volume / (R * T_ATM), P_ATM * self.volume / (GAMMA - 1)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        inside, t = self._inside(q)
        flow = self.conductance * (p - inside)
        return flow, GAMMA * R / (GAMMA - 1) * flow * (temperature if flow > 0 else t)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flow, enthalpy = self.exchange(q, now.p_gauge + P_ATM, now.temperature)
        return flow, enthalpy - self.ua * (self._inside(q)[1] - T_ATM)

    def _inside(self, q: State) -> tuple[float, float]:
        return (GAMMA - 1) * q[1] / self.volume, (GAMMA - 1) * q[1] / (R * q[0])


@law
class Pocket(Effect):
    """A rigid side volume without heat exchange (states: mass, energy, then others); left to define: the flow."""

    volume: float = 1.5e-5  # m3

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM), P_ATM * self.volume / (GAMMA - 1))

    def inside(self, q: State) -> float:
        """Absolute pressure in it [Pa]."""
        return (GAMMA - 1) * q[1] / self.volume

    def flow(self, q: State, p: float) -> float:
        """Gas [kg/s] from the muscle at p [Pa]."""
        raise NotImplementedError

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.flow(q, p)
        return flow, CP * flow * (temperature if flow > 0 else q[1] / (CV * q[0]))

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self.exchange(q, now.p_gauge + P_ATM, now.temperature)


@law
class TrappedPocket(Pocket):
    """A pocket behind a lip of the bladder, which opens to fill it and lets out slowly: G in, share G out.

    Reasoned from folds at the end plugs; any lip seal is a check valve one way.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    conductance: float = 6e-9  # kg/(s Pa)
    share: float = 0.1

    def flow(self, q: State, p: float) -> float:
        flow = self.conductance * (p - self.inside(q))
        return flow if flow > 0 else self.share * flow


@law
class Resonator(Pocket):
    """A chamber behind a neck whose gas has inertia: I m' = p - p_side - m/G. Third state: the flow in the neck.

    The inertance I is length over section of the neck (1e5/m for 0.3 m of 2 mm bore). Source: H. von Helmholtz, Die
    Lehre von den Tonempfindungen (1863).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7, 1e-10)
    inertance: float = 1e5  # 1/m
    conductance: float = 2e-8  # kg/(s Pa)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (*super().initial(rest), 0.0)

    def flow(self, q: State, p: float) -> float:
        return q[2]

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        p = now.p_gauge + P_ATM
        return (
            *super().rates(q, now),
            (p - self.inside(q) - q[2] / self.conductance) / self.inertance,
        )
