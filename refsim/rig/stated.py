"""Known parameters that are not what the description of the experiment states."""

from __future__ import annotations

from dataclasses import dataclass

from rig.effect import Effect


@dataclass(frozen=True)
class WrongParameter(Effect):
    """A parameter is in truth `factor` times what is stated: the weighed load, a length, the supply's gauge."""

    family = "wrong_parameter"
    form = "factor"
    name: str = "load.m"
    factor: float = 1.05

    def in_truth(self, name: str, stated: float) -> float:
        """`factor` times what is stated, for the one parameter."""
        return self.factor * stated if name == self.name else stated
