"""Heat of friction that reaches the gas."""

from __future__ import annotations

from dataclasses import dataclass

from rig.effect import Effect


@dataclass(frozen=True)
class FrictionHeat(Effect):
    """A share of the power that fibre friction dissipates heats the gas."""

    family = "friction_heat"
    form = "share"
    share: float = 1.0

    def friction_heat(self, fibre: float, bladder: float) -> float:
        return self.share * (fibre + bladder)


@dataclass(frozen=True)
class FibreHeat(Effect):
    """A share of the power of fibre on fibre heats the gas."""

    family = "friction_heat"
    form = "fibre"
    share: float = 1.0

    def friction_heat(self, fibre: float, bladder: float) -> float:
        return self.share * fibre
