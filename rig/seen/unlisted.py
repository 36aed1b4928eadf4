"""Effects that the catalogue does not hold, to see what a diagnosis makes of them."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, pi, sin

from rig.flow import P_ATM
from rig.named import Effect


@dataclass(frozen=True)
class Ripple(Effect):
    """A force that goes up and down along the travel."""

    family = "ripple"
    form = "sine"
    amplitude: float = 6.0  # N
    length: float = 0.03  # m

    def force(self, q: object, x: float, v: float, p_gauge: float) -> float:
        return self.amplitude * sin(2 * pi * x / self.length) if x > 0 else 0.0


@dataclass(frozen=True)
class Coupled(Effect):
    """A force that grows with the pressure and with the square of the travel."""

    family = "coupled"
    form = "quadratic"
    c: float = 8e-4  # N/Pa at 70 mm

    def force(self, q: object, x: float, v: float, p_gauge: float) -> float:
        return self.c * p_gauge * (x / 0.07) ** 2


@dataclass(frozen=True)
class PressedLip(Effect):
    """A leak past a lip that the pressure presses shut, so that most is lost at 40 kPa: a leak of no listed form."""

    family = "leak"
    form = "pressed_lip"
    conductance: float = 8e-10  # kg/(s.Pa), without pressure
    p_0: float = 4e4  # Pa

    def leak(self, p: float, temperature: float) -> float:
        gauge = p - P_ATM
        return self.conductance * gauge * exp(-max(gauge, 0.0) / self.p_0)


UNLISTED: dict[str, Effect] = {"ripple": Ripple(), "coupled": Coupled(), "pressed_lip": PressedLip()}
