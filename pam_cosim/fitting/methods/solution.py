"""What a method returns."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass

from pam_cosim.fitting.levenberg_marquardt import Minimum
from pam_cosim.fitting.solve import FitProblem


@dataclass(frozen=True)
class Record(ABC):
    """What a method did on its own way, for reports: it prints itself, and gives plain data for JSON."""

    @abstractmethod
    def as_dict(self) -> dict[str, object]:
        """Plain data for JSON, SI units."""


@dataclass(frozen=True)
class Solution:
    """The point that a method found, with the slopes there, and what it did on the way where that is worth telling."""

    end: Minimum
    record: Record | None = None


Method = Callable[[FitProblem], Solution]
