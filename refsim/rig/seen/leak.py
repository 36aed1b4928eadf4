"""Gas that gets out."""

from __future__ import annotations

from math import exp, log, pi, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import CP, P_ATM, T_ATM, R, mass_flow


@law
class TurbulentLeak(Effect):
    """Gas lost through a rough crack: c sqrt(p_gauge), linear below 2 kPa."""

    c: float = 6e-9  # kg/(s Pa^1/2)

    def leak(self, p: float, temperature: float) -> float:
        gauge = p - P_ATM
        return self.c * gauge / sqrt(sqrt(gauge * gauge + 4e6))


@law
class SquaredLeak(Effect):
    """Gas lost through a capillary: c (p^2 - p_atm^2)."""

    c: float = 4e-17  # kg/(s Pa2)

    def leak(self, p: float, temperature: float) -> float:
        return self.c * (p * p - P_ATM * P_ATM)


@law
class LiftingLeak(Effect):
    """A seal that lifts at a pressure: G (p_gauge - p_0), rounded over 5 kPa."""

    conductance: float = 4e-11  # kg/(s Pa)
    p_0: float = 6e4  # Pa

    def leak(self, p: float, temperature: float) -> float:
        over = p - P_ATM - self.p_0
        return self.conductance * (over + sqrt(over * over + 2.5e7)) / 2


@law
class LipSeal(Effect):
    """A lip that pressure presses shut: G p_gauge exp(-p_gauge/p_0), so that most is lost at middling pressure.

    Reasoned from self-energised seals, whose contact pressure rises with the pressure that they hold.
    """

    conductance: float = 6e-11  # kg/(s Pa)
    p_0: float = 6e4  # Pa

    def leak(self, p: float, temperature: float) -> float:
        gauge = p - P_ATM
        return self.conductance * gauge * exp(-max(gauge, 0.0) / self.p_0)


@law
class StretchedLeak(Effect):
    """A leak that depends on the contraction, its state; left to define: the flow."""

    atol: ClassVar[tuple[float, ...]] = (1e-8,)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.v,)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.flow(q[0], p - P_ATM)
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)

    def flow(self, x: float, gauge: float) -> float:
        """Mass flow [kg/s] to the surroundings, by contraction [m] and gauge pressure [Pa]."""
        raise NotImplementedError


@law
class StretchedPores(StretchedLeak):
    """Pores of the bladder that open as it is stretched: laminar, G p_gauge exp(x/x_0). State: the contraction.

    A pore's conductance goes as the fourth power of its width (Poiseuille), and contraction stretches the hoops.
    """

    conductance: float = 6e-12  # kg/(s Pa)
    x_0: float = 0.02  # m

    def flow(self, x: float, gauge: float) -> float:
        return self.conductance * gauge * exp(min(x / self.x_0, 8.0))


@law
class WideningGap(Effect):
    """A narrow gap that pressure pushes apart: G p_gauge (1 + p_gauge/p_0)^3.

    Flow through a gap goes with the cube of its width (O. Reynolds, Phil. Trans. R. Soc. 177 (1886) 157), and the width
    gives way in proportion to pressure.
    """

    conductance: float = 6e-12  # kg/(s Pa)
    p_0: float = 2e5  # Pa

    def leak(self, p: float, temperature: float) -> float:
        gauge = p - P_ATM
        return self.conductance * gauge * (1 + max(gauge, 0.0) / self.p_0) ** 3


@law
class PulledCrimp(StretchedLeak):
    """A crimped end that leaks as the bladder is pulled out of it: G p_gauge F/F_0 with the muscle's pull F.

    State: the contraction. Reasoned: the pull takes away some of the crimp's contact pressure.
    """

    conductance: float = 2e-11  # kg/(s Pa)
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0
    f_0: float = 100.0  # N

    def flow(self, x: float, gauge: float) -> float:
        length = self.length - x
        pull = gauge * (3 * length * length - self.fibre_squared) / (4 * pi * self.turns**2)
        return self.conductance * gauge * max(pull, 0.0) / self.f_0


@law
class CutBladder(StretchedLeak):
    """A cut along the bladder gapes with the hoop stress: an orifice of area A p_gauge/1 bar (D/D0)^2 L/L0.

    The stress is p D/(2 t), and the wall thins as the bladder's area grows. A crack opens in proportion to the
    stress. Source: H. Tada, P. C. Paris, G. R. Irwin, The Stress Analysis of Cracks Handbook (2000). State: the
    contraction.
    """

    area: float = 5e-9  # m2, at 1 bar and rest
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        length = self.length - q[0]
        wider = (self.fibre_squared - length * length) / (self.fibre_squared - self.length**2)
        gaping = self.area * max(p - P_ATM, 0.0) / 1e5 * wider * length / self.length
        flow = mass_flow(gaping, p, temperature, P_ATM, T_ATM)
        return flow, CP * flow * temperature


@law
class Labyrinth(Effect):
    """A leak along the thread of a fitting: A sqrt((p^2 - p_atm^2)/(R T (n + ln(p/p_atm)))), n turns in series.

    Linear below 1 kPa. Source: H. M. Martin, Labyrinth packings, Engineering 85 (1908) 35.
    """

    area: float = 1e-8  # m2
    n: float = 5.0

    def leak(self, p: float, temperature: float) -> float:
        drop = p * p - P_ATM * P_ATM
        edge = 2e3 * P_ATM
        root = drop / sqrt(sqrt(drop * drop + edge * edge))
        return self.area * root / sqrt(R * temperature * (self.n + log(max(p / P_ATM, 0.5))))


@law
class PressedLip(Effect):
    """A leak past a lip that the pressure presses shut, so that most is lost at 40 kPa: a leak of no listed form."""

    conductance: float = 8e-10  # kg/(s.Pa), without pressure
    p_0: float = 4e4  # Pa

    def leak(self, p: float, temperature: float) -> float:
        gauge = p - P_ATM
        return self.conductance * gauge * exp(-max(gauge, 0.0) / self.p_0)


@law
class ChangingLeak(Effect):
    """A laminar leak whose conductance follows a state of its own; left to define: by how much, and its rate."""

    conductance: float = 2e-11  # kg/(s Pa)

    def factor(self, q: State) -> float:
        """Factor on the conductance."""
        raise NotImplementedError

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.conductance * (p - P_ATM) * self.factor(q)
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)


@law
class MovingSeal(ChangingLeak):
    """A seal that rides up on a film while it slides: G p (1 + (|v|/v_0)^(1/2)). State: the speed behind 5 ms.

    Source: H. K. Mueller, B. S. Nau, Fluid Sealing Technology (1998): the film goes with the root of speed.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-8,)
    v_0: float = 5e-3  # m/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.v - q[0]) / 5e-3,)

    def factor(self, q: State) -> float:
        return float(1 + ((q[0] * q[0] + 1e-10) ** 0.5 / self.v_0) ** 0.5)


@law
class CreepingSeal(ChangingLeak):
    """A soft seal that creeps into its gap under pressure and out again: G p s, s' = (1/(1 + p/p_0) - s)/tau.

    Reasoned from the set of rubber seals (A. N. Gent, Engineering with Rubber, 3rd ed., 2012).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    p_0: float = 4e4  # Pa
    tau: float = 1.5  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (1.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((1 / (1 + max(now.p_gauge, 0.0) / self.p_0) - q[0]) / self.tau,)

    def factor(self, q: State) -> float:
        return q[0]


@law
class ColdSeal(Effect):
    """A seal that shrinks more than its groove when the gas is cold: G p exp(-(T - T_atm)/theta_0).

    Rubber contracts about ten times as much as metal, and a gap's flow goes with the cube of its width (O. Reynolds,
    Phil. Trans. R. Soc. 177 (1886) 157); the exponential is reasoned. The exponent stays within 3.
    """

    conductance: float = 2e-11  # kg/(s Pa)
    theta_0: float = 12.0  # K

    def leak(self, p: float, temperature: float) -> float:
        cold = min(max((T_ATM - temperature) / self.theta_0, -3.0), 3.0)
        return self.conductance * (p - P_ATM) * exp(cold)
