"""A wall that stores heat."""

from __future__ import annotations

from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import T_ATM

_LAYERS = 5


@law
class TwoLayerWall(Effect):
    """A wall in two layers, the outer one of `ratio` times the capacity, with a conductance between them."""

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    capacity: float = 0.5  # J/K
    ratio: float = 2.0
    between: float = 0.1  # W/K
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM, T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        passed = self.between * (q[0] - q[1])
        outward = passed - self.g_out * (q[1] - T_ATM)
        return (-now.heat_to_gas - passed) / self.capacity, outward / (self.ratio * self.capacity)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class FreeConvectionWall(Effect):
    """A warm wall that air cools by free convection: loss g_out dT (|dT|/5 K)^0.25."""

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.5  # J/K
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        warm = q[0] - T_ATM
        loss = self.g_out * warm * ((warm * warm + 1e-4) / 25) ** 0.125
        return ((-now.heat_to_gas - loss) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class ThickWall(Effect):
    """Heat diffuses into a thick wall, here five equal layers: the longer, the deeper.

    Of the diffusion time tau (thickness squared over diffusivity, 10 s for 1 mm of rubber) and the capacity of all.
    Source: H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids (1959), chapter 3, in finite volumes.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,) * _LAYERS
    capacity: float = 1.0  # J/K
    tau: float = 8.0  # s
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,) * _LAYERS

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        between = _LAYERS * self.capacity / self.tau
        inner = [between * (a - b) for a, b in zip(q[:-1], q[1:], strict=True)]
        passed = [-now.heat_to_gas, *inner, self.g_out * (q[-1] - T_ATM)]
        layer = self.capacity / _LAYERS
        return tuple((a - b) / layer for a, b in zip(passed[:-1], passed[1:], strict=True))

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class PressedLayers(Effect):
    """A bladder that loses its heat to the braid, and the better, the harder it is pressed: between (p/1 bar)^0.95.

    States: temperatures of bladder and braid; 5 % of 1 bar is left of the contact without gauge pressure.
    Source: M. G. Cooper, B. B. Mikic, M. M. Yovanovich, Thermal contact conductance, Int. J. Heat Mass Transf. 12
    (1969) 279, for the exponent.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    capacity: float = 0.3  # J/K, of the bladder
    ratio: float = 2.0  # capacity of the braid by that of the bladder
    between: float = 0.1  # W/K, at 1 bar
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM, T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        pressed = (0.05 + max(now.p_gauge, 0.0) / 1e5) ** 0.95
        passed = self.between * pressed * (q[0] - q[1])
        outward = passed - self.g_out * (q[1] - T_ATM)
        return (-now.heat_to_gas - passed) / self.capacity, outward / (self.ratio * self.capacity)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class FannedWall(Effect):
    """A warm wall that cools itself by moving through the air: loss g_out dT (1 + (|v|/v_0)^(1/2)).

    Source: L. V. King, On the convection of heat from small cylinders, Phil. Trans. R. Soc. A 214 (1914) 373.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.02  # W/K, at rest
    v_0: float = 0.02  # m/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        fanned = 1 + ((now.v * now.v + 1e-10) ** 0.5 / self.v_0) ** 0.5
        return ((-now.heat_to_gas - self.g_out * fanned * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class MetalEnds(Effect):
    """A bladder that loses heat to the air and to the metal fittings, which keep it: conductances g_out and g_end.

    States: temperatures of bladder and fittings. Source: heat balance of two lumps.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    capacity: float = 0.4  # J/K, of the bladder
    ratio: float = 8.0  # capacity of the fittings by that of the bladder
    g_out: float = 0.02  # W/K
    g_end: float = 0.04  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM, T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        passed = self.g_end * (q[0] - q[1])
        kept = -now.heat_to_gas - self.g_out * (q[0] - T_ATM) - passed
        return kept / self.capacity, passed / (self.ratio * self.capacity)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class ExhaustDraught(Effect):
    """The exhaust blows along the muscle and cools its wall: loss g_out dT (1 + c a) with the exhaust's opening a.

    a is the current above the threshold of 0.145 A by 0.205 A. Source: heat balance of a lump; the draught is reasoned.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.02  # W/K, without draught
    c: float = 5.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        blown = 1 + self.c * max(now.command[1] - 0.145, 0.0) / 0.205
        return ((-now.heat_to_gas - self.g_out * blown * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class ClosingGap(Effect):
    """A muscle in a guard tube, which it fills as it bulges: loss g_out dT (1 + x/x_0).

    Still air conducts across the gap, the better the narrower it is; to first order in the contraction. Reasoned.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.02  # W/K, at rest
    x_0: float = 0.01  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        nearer = 1 + max(now.x, 0.0) / self.x_0
        return ((-now.heat_to_gas - self.g_out * nearer * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class TwoPatches(Effect):
    """A wall of bare patches and of ones that fibres thicken, side by side: shares s and 1 - s of the inner surface.

    States: their temperatures; the thick ones have `ratio` times the capacity and the same loss. `coefficient` is the
    base model's between gas and wall. Source: heat balance of two lumps side by side.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    capacity: float = 0.2  # J/K, of the bare patches
    ratio: float = 5.0
    share: float = 0.5
    g_out: float = 0.02  # W/K, of both together
    coefficient: float = 9.8  # W/(m2 K)
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0
    fibre_area: float = 0.0133  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM, T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        length = self.length - now.x
        girth = sqrt(self.fibre_squared - length * length) / self.turns
        inside = self.coefficient * max(0.0, girth * length - self.fibre_area)
        bare, thick = (inside * (now.temperature - t) - self.g_out * (t - T_ATM) for t in q)
        return self.share * bare / self.capacity, (1 - self.share) * thick / (
            self.ratio * self.capacity
        )

    def wall_temperature(self, q: State, outside: float) -> float:
        return self.share * q[0] + (1 - self.share) * q[1]
