"""Gas that takes no part in contraction."""

from __future__ import annotations

from dataclasses import dataclass

from rig.effect import Effect


@dataclass(frozen=True)
class DeadVolume(Effect):
    """Gas volume in fittings that does not take part in contraction."""

    family = "dead_volume"
    form = "constant"
    volume: float = 1.0e-5  # m3

    def extra_volume(self) -> float:
        return self.volume
