"""Heat of friction that reaches the gas."""

from __future__ import annotations

from rig.effect import Effect, law


@law
class FrictionHeat(Effect):
    """A share of the power that fibre friction dissipates heats the gas."""

    form = "share"
    share: float = 1.0

    def friction_heat(self, fibre: float, bladder: float) -> float:
        return self.share * (fibre + bladder)


@law
class FibreHeat(Effect):
    """A share of the power of fibre on fibre heats the gas."""

    form = "fibre"
    share: float = 1.0

    def friction_heat(self, fibre: float, bladder: float) -> float:
        return self.share * fibre
