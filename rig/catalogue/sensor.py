"""Effects in what instruments read."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from rig.effect import Effect, Now, Rest


@dataclass(frozen=True)
class ThermocoupleLag(Effect):
    """The temperature reading follows the gas through a first-order lag."""

    family = "thermocouple_lag"
    form = "first_order"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.15  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        return ((now.temperature - q[0]) / self.tau,)

    def reading(self, q: Sequence[float], temperature: float) -> float:
        return q[0]


@dataclass(frozen=True)
class PressureOffset(Effect):
    """The pressure reading is off by a constant."""

    family = "pressure_offset"
    form = "constant"
    offset: float = 5.0e3  # Pa

    def pressure_reading(self, p_gauge: float) -> float:
        return p_gauge + self.offset


@dataclass(frozen=True)
class PressureGain(Effect):
    """The pressure reading is off by a factor."""

    family = "pressure_offset"
    form = "gain"
    gain: float = 1.05

    def pressure_reading(self, p_gauge: float) -> float:
        return self.gain * p_gauge
