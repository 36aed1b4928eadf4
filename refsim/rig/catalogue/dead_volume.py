"""Gas that takes no part in contraction."""

from __future__ import annotations

from rig.effect import Effect, law


@law
class DeadVolume(Effect):
    """Gas volume in fittings that does not take part in contraction."""

    form = "constant"
    volume: float = 1.0e-5  # m3

    def extra_volume(self) -> float:
        return self.volume
