"""The product of a method of fitting."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from pam_cosim.fitting.levenberg_marquardt import Minimum
from pam_cosim.fitting.methods.global_search import GlobalSearch
from pam_cosim.fitting.solve import FitProblem


@dataclass(frozen=True)
class Solution:
    """The result of a method.

    Attributes:
        end: the point that it found, with the slopes there.
        search: the search over all of the bounds that came before the descents, if there was one.
    """

    end: Minimum
    search: GlobalSearch | None = None


Method = Callable[[FitProblem], Solution]
