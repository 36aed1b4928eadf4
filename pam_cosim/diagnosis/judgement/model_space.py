"""What is known of a rig before it is measured: effects that cannot be missing, and those that are likely."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from functools import cache

from pam_cosim.catalogue import EffectClass
from pam_cosim.errors import InputError
from pam_cosim.model.domain import WRONG_PARAMETER
from pam_cosim.wording import did_you_mean, shown


@dataclass(frozen=True)
class ModelSpace:
    """How many sets of effects there are to choose from, which is what a choice among them costs.

    Attributes:
        every: number of effects. expected: names of those that are likely: they are chosen from among themselves.
    """

    every: int
    expected: frozenset[str] = frozenset()

    def cost(self, effects: Collection[str]) -> float:
        """Twice the logarithm of the number of such sets (extended criterion, Chen and Chen 2008)."""
        likely = sum(name in self.expected for name in effects) if self.expected else 0
        return _cost(self.every, len(self.expected), likely, len(effects) - likely)


@cache
def _cost(every: int, expected: int, likely: int, other: int) -> float:
    """What it costs to choose so many of the expected effects, and so many others of all."""
    return 2 * math.log(math.comb(expected, likely) * math.comb(every, min(other, every)))


def contradiction(
    available_effects: Sequence[EffectClass], excluded: Sequence[str], expected: Sequence[str]
) -> str | None:
    """The first name of a family or an effect that is expected, of which all is excluded; None: there is none."""
    left_out = {e.name for e in available_effects if not {e.name, e.family}.isdisjoint(excluded)}
    for name in expected:
        own = {e.name for e in available_effects if name in (e.name, e.family)}
        if name in excluded or (own and own <= left_out):
            return name
    return None


def effects_named(
    available_effects: Sequence[EffectClass],
    names: Sequence[str],
    error: Callable[[str], InputError],
) -> frozenset[str]:
    """Names of the effects that are meant by names of families or effects.

    Args:
        available_effects: all effects.
        names: as somebody wrote them.
        error: makes the error from its message.

    Raises:
        InputError: neither a family nor an effect.
    """
    chosen: set[str] = set()
    for name in names:
        own = {e.name for e in available_effects if name in (e.name, e.family)}
        if not own and name != WRONG_PARAMETER:  # a data set need not state one
            known = dict.fromkeys(
                [
                    *(e.family for e in available_effects),
                    WRONG_PARAMETER,
                    *(e.name for e in available_effects),
                ]
            )
            raise error(
                f"there is no family and no effect {shown(name)}; {did_you_mean(name, known)}"
            )
        chosen |= own
    return frozenset(chosen)
