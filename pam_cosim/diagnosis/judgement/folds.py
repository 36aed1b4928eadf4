"""The result of a cross-validation over runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Folds:
    """Which effects of a model are needed when runs are left out in turn.

    Attributes:
        count: of folds.
        needed: in how many of them each effect was needed, by its name.
        unbelievable: ratios to what is stated that came out too far from one, by the name of the effect.
        rmse: error of each signal on the runs that were left out [its unit], with the effects that are named; the
            middle one of the folds.
        worst: the largest one, and the runs that were left out then, by signal.
    """

    json_keys = "count needed unbelievable rmse worst=_worst"

    count: int
    needed: Mapping[str, int]
    unbelievable: Mapping[str, float]
    rmse: Mapping[str, float] = field(default_factory=dict)
    worst: Mapping[str, tuple[float, tuple[str, ...]]] = field(default_factory=dict)

    @property
    def named(self) -> tuple[str, ...]:
        """The effects that are needed in most folds, and whose values can be believed."""
        return tuple(
            e for e, n in self.needed.items() if 2 * n > self.count and e not in self.unbelievable
        )

    @property
    def _worst(self) -> dict[str, object]:
        return {name: {"rmse": rmse, "runs": runs} for name, (rmse, runs) in self.worst.items()}
