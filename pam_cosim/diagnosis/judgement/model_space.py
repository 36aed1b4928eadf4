"""What is known of a rig before it is measured: effects that cannot be missing, and those that are likely."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cache

from pam_cosim.catalogue import EffectClass
from pam_cosim.model.domain import WRONG_PARAMETER
from pam_cosim.wording import did_you_mean, shown


@dataclass(frozen=True)
class ModelSpace:
    """How many sets of effects there are to choose from, which is what a choice among them costs.

    Attributes:
        count: of effects. expected: names of those that are likely: they are chosen from among themselves.
    """

    count: int
    expected: frozenset[str] = frozenset()

    def cost(self, effects: Collection[str]) -> float:
        """Twice the logarithm of the number of such sets (extended criterion, Chen and Chen 2008)."""
        likely = sum(name in self.expected for name in effects) if self.expected else 0
        return _cost(self.count, len(self.expected), likely, len(effects) - likely)


@cache
def _cost(all_effects: int, expected: int, likely: int, other: int) -> float:
    """What it costs to choose so many of the expected effects, and so many others of all."""
    return 2 * math.log(
        math.comb(expected, likely) * math.comb(all_effects, min(other, all_effects))
    )


def effects_named(available: Sequence[EffectClass], name: str) -> frozenset[str]:
    """Names of the effects that are meant by the name of a family or of an effect.

    Raises:
        ValueError: neither a family nor an effect.
    """
    effects = frozenset(e.name for e in available if name in (e.name, e.family))
    if not effects and name != WRONG_PARAMETER:  # a data set need not state one
        families, members = [e.family for e in available], [e.name for e in available]
        hint = did_you_mean(name, dict.fromkeys([*families, WRONG_PARAMETER, *members]))
        raise ValueError(f"there is no family and no effect {shown(name)}; {hint}")
    return effects
