"""An input that was not measured itself: a map of what was, or a constant. What its names are in a model."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class InputMap:
    """How an input follows from what was recorded: gain times that plus offset; without a record, a constant.

    Attributes:
        name: of the input; ``unit``: of the input.
        raw: unit of what was recorded; None: nothing was.
        gain: [unit/raw].
        offset: [unit]; without a record, the input itself.
    """

    name: str
    unit: str
    raw: str | None
    gain: float
    offset: float


def raw_of(name: str) -> str:
    """The input of a model with a map: what was recorded in the place of an input."""
    return f"{name}_raw"


def gain_of(name: str) -> str:
    """The parameter that what was recorded is multiplied by."""
    return f"{name}_gain"


def offset_of(name: str) -> str:
    """The parameter that is added to it."""
    return f"{name}_offset"


def constant_of(name: str) -> str:
    """The parameter that takes the place of an input that was not recorded."""
    return f"{name}_constant"
