"""Manometers that are off."""

from __future__ import annotations

from rig.effect import Effect, State, law


@law
class PressureOffset(Effect):
    """The pressure reading is off by a constant."""

    form = "constant"
    offset: float = 5.0e3  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + self.offset


@law
class PressureGain(Effect):
    """The pressure reading is off by a factor."""

    form = "gain"
    gain: float = 1.05

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return self.gain * p_gauge
