"""A model's curve over a measurement."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from pam_cosim.comparison import Comparison, RunComparison
from pam_cosim.reporting.account.labels import short_model
from pam_cosim.reporting.style import AFTER, BEFORE

COLUMNS = 6  # runs side by side; more go to another figure
SPARSE = 60  # samples of a run up to which each is drawn large


@dataclass(frozen=True)
class Layer:
    """One model in the figures.

    Attributes:
        label: its name in the legend.
        comparison: its curves.
        colour: of its curves.
        dashed: whether the curves are dashed.
    """

    label: str
    comparison: Comparison
    colour: str
    dashed: bool = False

    def run(self, name: str) -> RunComparison | None:
        """The run of this name; None when this model was not run on it."""
        return next((r for r in self.comparison.runs if r.run.name == name), None)


def before_and_after(base: Comparison, final: Comparison | None, label: str) -> tuple[Layer, ...]:
    """The base model dashed and, where an effect was added, the model with it solid."""
    before = Layer("base model", base, BEFORE, dashed=final is not None)
    return (before,) if final is None else (before, Layer(label, final, AFTER))


def alone(comparison: Comparison) -> Layer:
    """A single model."""
    return Layer(short_model(comparison.model), comparison, AFTER)


def pages(runs: Sequence[RunComparison], most: int = COLUMNS) -> list[Sequence[RunComparison]]:
    """Runs in groups of nearly equal size that fit side by side."""
    count = -(-len(runs) // most)
    size = -(-len(runs) // count) if count else 0
    return [runs[i * size : (i + 1) * size] for i in range(count)]
