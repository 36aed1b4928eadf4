"""How a run begins: in which state the rig was at its first sample."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

StartMode = Literal["rest", "steady", "measured", "estimated"]
START_MODES: tuple[StartMode, ...] = get_args(StartMode)


@dataclass(frozen=True)
class Start:
    """How a run begins.

    Attributes:
        mode: "rest": as the model begins by itself, without pressure; "steady": at rest under the first inputs;
            "measured": what is measured begins where the first samples lie, the rest of the state consistent with it;
            "estimated": as that, and every start value is a parameter of the run. None: chosen from the first samples.
        reason: why it was chosen, a sentence; empty where it is stated.
    """

    mode: StartMode | None = None
    reason: str = ""

    @property
    def is_found(self) -> bool:
        """Whether start values are looked for in the run itself."""
        return self.mode in ("measured", "estimated")
