"""Manometers that are off."""

from __future__ import annotations

from dataclasses import dataclass

from rig.effect import Effect, State


@dataclass(frozen=True)
class PressureOffset(Effect):
    """The pressure reading is off by a constant."""

    family = "pressure_offset"
    form = "constant"
    offset: float = 5.0e3  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + self.offset


@dataclass(frozen=True)
class PressureGain(Effect):
    """The pressure reading is off by a factor."""

    family = "pressure_offset"
    form = "gain"
    gain: float = 1.05

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return self.gain * p_gauge
