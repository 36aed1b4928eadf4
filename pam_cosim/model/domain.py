"""How a field of physics is spoken of. It is data of a Modelica library; here is its form, and words for any field."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

WRONG_PARAMETER = "wrong_parameter"
"""The family of what no library has a class for: a scale, a ruler or a gauge misled who described the rig."""


@dataclass(frozen=True)
class Domain:
    """What reports and drawings must know of a field.

    Attributes:
        balances: in the order in which they are opened and drawn.
        confused: rows of two balances and a sentence. Where a term of the first is missing while a law hides the
            second, models that have a balance of the second are tried too; the sentence is printed where both fit.
        phases: rows of a unit and three words. The first output with that unit divides a run into parts in which it
            rises, rests and falls.
        moving: units of outputs of which it matters whether they grow, rest or shrink, and how fast.
        axes: variables that a missing term is drawn against, the telling ones first.
        planes: pairs of variables that a missing term is drawn over; the first that a term has both of counts.
        tested: what a tested range is a range of.
        ranges: rows of a unit, the least and the largest number of it that a rig of the field usually has; of "s", the
            duration of a run.
        instruments: rows of a family and a sentence: the family is a fault of an instrument; the sentence is on that
            instrument.
    """

    balances: tuple[str, ...] = ()
    confused: tuple[tuple[str, str, str], ...] = ()
    phases: tuple[tuple[str, str, str, str], ...] = ()
    moving: tuple[str, ...] = ()
    axes: tuple[str, ...] = ()
    planes: tuple[tuple[str, str], ...] = ()
    tested: str = "inputs and loads"
    ranges: tuple[tuple[str, str, str], ...] = ()
    instruments: tuple[tuple[str, str], ...] = ()

    def faults(self, families: Sequence[str]) -> dict[str, str]:
        """The sentence on the instrument for each family of instrument faults."""
        sentences = {
            WRONG_PARAMETER: "what the data set states of a parameter is not so",
            **dict(self.instruments),
        }
        return {family: sentences[family] for family in families if family in sentences}

    def place(self, balance: str) -> int:
        """Where a balance stands in the order; those that are not in it come last."""
        return self.balances.index(balance) if balance in self.balances else len(self.balances)
