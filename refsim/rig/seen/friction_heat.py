"""Heat of friction that reaches the gas."""

from __future__ import annotations

from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law


@law
class RisingHeat(Effect):
    """A share of the power heats the gas while the muscle contracts; extension cools itself from outside."""

    share: float = 1.0

    def friction_heat(self, fibre: float, bladder: float) -> float:
        return self.share * (fibre + bladder) if bladder > 0 else 0.0


@law
class LateHeat(Effect):
    """The power of friction warms the fibres first and reaches the gas through a lag."""

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    share: float = 1.0
    tau: float = 0.3  # s
    crossing: float = (
        2.4e-3  # m2, A_ff mu_d K_f ...: force of fibre on fibre per pressure and speed
    )

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((self.share * self.crossing * max(now.p_gauge, 0.0) * now.v**2 - q[0]) / self.tau,)

    def heat(self, q: State) -> float:
        return q[0]


@law
class BladderHeat(Effect):
    """A share of what fibres lose by rubbing on the bladder heats the gas; the crossings cool outside.

    Only the bladder lies between the contact and the gas, while air reaches the fibres' crossings. Friction heats in
    both directions.
    """

    share: float = 1.0

    def friction_heat(self, fibre: float, bladder: float) -> float:
        return self.share * abs(bladder)


@law
class SoakedHeat(Effect):
    """What the fibres lose by rubbing, on each other and on the bladder, soaks through the bladder: two lags of tau/2.

    States: heat [W] that has come half and all the way. Reasoned as conduction through a wall in two lumps; friction
    heats in both directions.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    share: float = 1.0
    tau: float = 0.3  # s
    crossing: float = 2.4e-3  # m s, force of fibre on fibre per pressure and speed
    covered: float = 2e-4  # m2, force of fibres on the bladder per pressure

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        rubbed = max(now.p_gauge, 0.0) * (self.crossing * now.v**2 + self.covered * abs(now.v))
        return (self.share * rubbed - q[0]) * 2 / self.tau, (q[0] - q[1]) * 2 / self.tau

    def heat(self, q: State) -> float:
        return q[1]


@law
class MovingContact(Effect):
    """The faster a contact moves, the less of its heat goes to the bladder: power times share/(1 + (|v|/v_0)^(1/2)).

    State: the heat behind the lag of 20 ms that it takes through a film of rubber; friction heats in both directions.
    Source: J. C. Jaeger, Moving sources of heat and the temperature at sliding contacts, Proc. R. Soc. NSW 76 (1942)
    203: the partition goes with the root of the Peclet number.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    share: float = 1.0
    v_0: float = 0.05  # m/s
    crossing: float = 2.4e-3  # m s, force of fibre on fibre per pressure and speed
    covered: float = 2e-4  # m2, force of fibres on the bladder per pressure
    tau: float = 0.02  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        rubbed = max(now.p_gauge, 0.0) * (self.crossing * now.v**2 + self.covered * abs(now.v))
        return ((self.share * rubbed / (1 + sqrt(abs(now.v) / self.v_0)) - q[0]) / self.tau,)

    def heat(self, q: State) -> float:
        return q[0]


@law
class PressedContact(Effect):
    """The harder fibres are pressed on the bladder, the more of their heat goes to it: power times share p/(p + p_0).

    The rest goes to the air outside. State: the heat behind the 20 ms that it takes through a film of rubber; friction
    heats in both directions. Source: conductances of contact go nearly with pressure (M. G. Cooper et al., Int. J. Heat
    Mass Transf. 12 (1969) 279), beside a constant one to the air.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    share: float = 1.0
    p_0: float = 3e4  # Pa
    crossing: float = 2.4e-3  # m s, force of fibre on fibre per pressure and speed
    covered: float = 2e-4  # m2, force of fibres on the bladder per pressure
    tau: float = 0.02  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        p = max(now.p_gauge, 0.0)
        rubbed = p * (self.crossing * now.v**2 + self.covered * abs(now.v))
        return ((self.share * rubbed * p / (p + self.p_0) - q[0]) / self.tau,)

    def heat(self, q: State) -> float:
        return q[0]


@law
class TwoPaths(Effect):
    """What fibres rub off the bladder reaches the gas soon, what they rub off each other behind tau.

    States: both heats [W]; friction heats in both directions. Source: conduction from two places at different depths,
    each in one lump.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    share: float = 1.0
    tau: float = 0.5  # s
    crossing: float = 2.4e-3  # m s, force of fibre on fibre per pressure and speed
    covered: float = 2e-4  # m2, force of fibres on the bladder per pressure

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        pressed = self.share * max(now.p_gauge, 0.0)
        bladder, crossings = pressed * self.covered * abs(now.v), pressed * self.crossing * now.v**2
        return (bladder - q[0]) / 0.02, (crossings - q[1]) / self.tau

    def heat(self, q: State) -> float:
        return q[0] + q[1]
