"""Short names that tell models apart."""

from __future__ import annotations

from collections.abc import Sequence

from pam_cosim.comparison import Comparison
from pam_cosim.model.references import is_file


def short_model(name: str) -> str:
    """The last part of a qualified class name."""
    return (
        name.rsplit("/", 1)[-1].rsplit(".", 1)[-1] if not is_file(name) else name.rsplit("/", 1)[-1]
    )


def model_labels(comparisons: Sequence[Comparison]) -> list[str]:
    """A label for each; equal names are numbered."""
    names = [short_model(c.model) for c in comparisons]
    return [
        name if names.count(name) == 1 else f"{name} ({names[: i + 1].count(name)})"
        for i, name in enumerate(names)
    ]
