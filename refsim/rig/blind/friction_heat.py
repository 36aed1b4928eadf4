"""Heat of friction that reaches the gas."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State


@dataclass(frozen=True)
class PressedContact(Effect):
    """The harder fibres are pressed on the bladder, the more of their heat goes to it: power times share p/(p + p_0).

    The rest goes to the air outside. State: the heat behind the 20 ms that it takes through a film of rubber; friction
    heats in both directions. Source: conductances of contact go nearly with pressure (M. G. Cooper et al., Int. J. Heat
    Mass Transf. 12 (1969) 279), beside a constant one to the air.
    """

    family = "friction_heat"
    form = "pressed_contact"
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


@dataclass(frozen=True)
class TwoPaths(Effect):
    """What fibres rub off the bladder reaches the gas soon, what they rub off each other behind tau.

    States: both heats [W]; friction heats in both directions. Source: conduction from two places at different depths,
    each in one lump.
    """

    family = "friction_heat"
    form = "two_paths"
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
