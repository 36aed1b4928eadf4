"""How a run begins: in which state the rig was at its first sample, and what is known of the time before."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, get_args

from pam_cosim.arrays import Array

StartMode = Literal["rest", "steady", "measured", "estimated"]
START_MODES: tuple[StartMode, ...] = get_args(StartMode)


@dataclass(frozen=True)
class Start:
    """How a run begins.

    Attributes:
        mode: "rest": as the model begins by itself, without pressure; "steady": at rest under the first inputs;
            "measured": what is measured begins where the first samples lie, the rest of the state consistent with it;
            "estimated": as that, and every start value is a parameter of the run. None: chosen from the first samples.
        reason: where it was chosen and is not rest, the sentence for it.
        chosen: the mode was chosen, not stated.
        before: inputs [SI] that were held before the first sample, for ``seconds`` [s]; ``mode`` is that of then.
        seconds: 0: nothing is known of the time before.
        lead: [s] at the beginning that are simulated and not scored.
        leading: the samples of that time, by signal: times (m,) [s] and values (m,) [SI].
        periodic: the run is one period of a periodic motion.
        periods: how many of them are simulated before it; 0: not known yet.
    """

    mode: StartMode | None = None
    reason: str = ""
    chosen: bool = False
    before: Mapping[str, float] = field(default_factory=dict)
    seconds: float = 0.0
    lead: float = 0.0
    leading: Mapping[str, tuple[Array, Array]] = field(default_factory=dict)
    periodic: bool = False
    periods: int = 0

    @property
    def is_found(self) -> bool:
        """Whether the run's own samples determine where it begins."""
        return self.mode in ("measured", "estimated") or self.periodic
