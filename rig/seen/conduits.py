"""A line whose gas has inertia, chambers and stubs beside the muscle, and ways out of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import log, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import GAMMA, P_ATM, T_ATM, R, mass_flow
from rig.seen.gas import CP, CV, Tube
from rig.seen.pneumatics import StretchedLeak

State = Sequence[float]


@dataclass(frozen=True)
class InertialLine(Tube):
    """A long tube whose gas must be set going: I m' = p_a - p_b - m 2 p_atm/(G (p_a + p_b)). Third state: the flow.

    The inertance I is length over section (1.6e5/m for 2 m of 4 mm tube); once flow is steady it is a laminar tube.
    Source: J. Watton, Fluid Power Systems (1989), on lumped lines.
    """

    form = "inertial"
    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7, 1e-10)
    conductance: float = 4e-9  # kg/(s Pa)
    inertance: float = 1.6e5  # 1/m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (*super().initial(rest), 0.0)

    def node(self, q: State) -> tuple[float, float]:
        return super().node(q[:2])

    def into_muscle(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return q[2], CP * q[2] * (self.node(q)[1] if q[2] > 0 else temperature)

    def line_rates(self, q: State, from_valves: tuple[float, float], p: float, temperature: float) -> tuple[float, ...]:
        p_a = self.node(q)[0]
        drop = q[2] * 2 * P_ATM / (self.conductance * (p_a + p))
        return (*super().line_rates(q, from_valves, p, temperature), (p_a - p - drop) / self.inertance)


@dataclass(frozen=True)
class OrificeChamber(Effect):
    """A rigid chamber behind a drilled hole, as the cavity of a T-piece; compressible flow, no heat exchange.

    States: mass, energy. Source: first law for an open volume; flow by A. de Saint-Venant and L. Wantzel (1839).
    """

    family = "dead_volume"
    form = "orifice_chamber"
    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 1e-5  # m3
    area: float = 3e-7  # m2, effective

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM), P_ATM * self.volume / (GAMMA - 1))

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        t_side = q[1] / (CV * q[0])
        flow = mass_flow(self.area, p, temperature, (GAMMA - 1) * q[1] / self.volume, t_side)
        return flow, CP * flow * (temperature if flow > 0 else t_side)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self.exchange(q, now.p_gauge + P_ATM, now.temperature)


_LUMPS = 3


@dataclass(frozen=True)
class CapillaryStub(Effect):
    """A thin dead-end tube, as that to a far gauge: gas spreads along it by laminar flow, at the wall's temperature.

    States: the masses in three equal lumps. Source: isothermal Poiseuille flow of a gas, as in S. Dushman, Scientific
    Foundations of Vacuum Technique (1962), in finite volumes.
    """

    family = "dead_volume"
    form = "capillary_stub"
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


@dataclass(frozen=True)
class CutBladder(StretchedLeak):
    """A cut along the bladder gapes with the hoop stress: an orifice of area A p_gauge/1 bar (D/D0)^2 L/L0.

    The stress is p D/(2 t), and the wall thins as the bladder's area grows. A crack opens in proportion to the
    stress. Source: H. Tada, P. C. Paris, G. R. Irwin, The Stress Analysis of Cracks Handbook (2000). State: the
    contraction.
    """

    form = "cut"
    area: float = 5e-9  # m2, at 1 bar and rest
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        length = self.length - q[0]
        wider = (self.fibre_squared - length * length) / (self.fibre_squared - self.length**2)
        gaping = self.area * max(p - P_ATM, 0.0) / 1e5 * wider * length / self.length
        flow = mass_flow(gaping, p, temperature, P_ATM, T_ATM)
        return flow, CP * flow * temperature


@dataclass(frozen=True)
class Labyrinth(Effect):
    """A leak along the thread of a fitting: A sqrt((p^2 - p_atm^2)/(R T (n + ln(p/p_atm)))), n turns in series.

    Linear below 1 kPa. Source: H. M. Martin, Labyrinth packings, Engineering 85 (1908) 35.
    """

    family = "leak"
    form = "labyrinth"
    area: float = 1e-8  # m2
    n: float = 5.0

    def leak(self, p: float, temperature: float) -> float:
        drop = p * p - P_ATM * P_ATM
        edge = 2e3 * P_ATM
        root = drop / sqrt(sqrt(drop * drop + edge * edge))
        return self.area * root / sqrt(R * temperature * (self.n + log(max(p / P_ATM, 0.5))))
