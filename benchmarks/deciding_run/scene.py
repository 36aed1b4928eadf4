"""What a case needs: a first recording that says little, what a further run may be, and a rig that plays it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from pam_cosim.diagnosis.planning import Limits
from pam_cosim.measurement import DataSet, Run


@dataclass(frozen=True)
class Scene:
    """One case.

    Attributes:
        description: what is hidden, as ``benchmarks.hidden_effects.outcome.judged`` reads it.
        data: the first recording.
        limits: of a further run.
        play: a planned run with what is recorded when it is made; RuntimeError where the rig cannot play it. Of the
            muscle, a number beside it gives the run noise of its own.
        seed: of what is drawn at random.
    """

    description: Mapping[str, Any]
    data: DataSet
    limits: Limits
    play: Callable[..., Run]
    seed: int
