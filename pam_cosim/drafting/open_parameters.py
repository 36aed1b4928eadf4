"""Which parameters of a bench somebody can state, and which only a fit tells."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from pam_cosim.model.interface import Interface, Variable

_DATA_SHEET_TOLERANCE = 0.3  # of its value: bounds of a parameter of the fibres in a fit


# What a rule, scales, a thermometer or a gauge tells, or the maker's drawing: it is stated, not fitted.
_MEASURED = ("m", "m2", "m3", "kg", "kg.m2", "K", "Pa", "N")
_OPEN = (
    "calibration",
    "effective area",
    "discharge coefficient",
    "pressure lost per mass flow",
    "time constant",
)
_PERHAPS = ("polytropic", "coefficient of friction", "film coefficient", "damping", "friction")
_CHOSEN = ("filter",)
# What lies in the rubber of a muscle, where no rule reaches: of the fibres, and of the wall.
_OF_FIBRES, _OF_WALLS = (
    ("fibres lie", "fibres and axis"),
    ("wall takes", "bent open", "the muscle pulls"),
)
_GEOMETRY = ("m", "m2", "m3", "kg", "kg.m2", "1", "")


def to_state(interface: Interface, points: bool = False) -> dict[str, Variable]:
    """Parameters that somebody with a rule and scales can state, of parts that stand in the bench itself.

    Args:
        points: points at rest were recorded, which depend on sizes and loads alone.
    """
    fitted = {*free(interface), *perhaps(interface)}
    own = {name: v for name, v in interface.parameters.items() if name.count(".") <= 1}
    known = {name: v for name, v in own.items() if name not in fitted and _is_measure(name, v)}
    return {name: v for name, v in known.items() if is_geometry(v) or not points}


def _is_measure(name: str, variable: Variable) -> bool:
    """Whether it has a value and a least one, and is neither where a run begins nor a choice."""
    has_value = variable.start is not None and variable.min is not None
    return has_value and not name.endswith("_start") and not _speaks_of(variable, _CHOSEN)


def _speaks_of(variable: Variable, words: Sequence[str]) -> bool:
    description = variable.description.casefold()
    return any(word in description for word in words)


def _is_bounded(variable: Variable) -> bool:
    return variable.min is not None and variable.max is not None


def is_geometry(variable: Variable) -> bool:
    """Whether it is of a size, a count or a mass."""
    return variable.unit in _GEOMETRY


def free(interface: Interface, points: bool = False) -> dict[str, Variable]:
    """Parameters that only a fit tells: calibrations, discharge, lag and droop, by what is said of them.

    Args:
        points: points at rest were recorded, which tell what lies in the rubber of a muscle, nothing that takes time.
    """
    return hidden(interface) if points else _told_by_fit(interface, _OPEN)


def perhaps(interface: Interface, points: bool = False) -> dict[str, Variable]:
    """Others that may be left free."""
    told = _told_by_fit(interface, _PERHAPS)
    if points:
        return {name: v for name, v in told.items() if _speaks_of(v, ["friction"])}
    return {**told, **hidden(interface)}


def hidden(interface: Interface) -> dict[str, Variable]:
    """Measures within the wall of a muscle that has one: where its fibres lie, and what the wall takes of its pull."""
    walls = _inside(interface, _OF_WALLS)
    owners = {_owner(name) for name in walls}
    fibres = _inside(interface, _OF_FIBRES)
    of_owners = {name: v for name, v in fibres.items() if _owner(name) in owners}
    near = {name: _nearby(v) for name, v in of_owners.items() if v.start}
    return {**near, **walls}


def _owner(name: str) -> str:
    """The component around the one that has the parameter."""
    return name.rpartition(".")[0].rpartition(".")[0]


def _inside(interface: Interface, words: Sequence[str]) -> dict[str, Variable]:
    deep = {name: v for name, v in interface.parameters.items() if name.count(".") == 2}
    bounded = {name: v for name, v in deep.items() if _is_bounded(v)}
    return {n: v for n, v in bounded.items() if any(word in v.description for word in words)}


def _nearby(variable: Variable) -> Variable:
    """The variable with bounds about its value: those of a measure that may be zero, not stated, are no help."""
    assert variable.start is not None
    low, high = (
        variable.start * (1.0 - _DATA_SHEET_TOLERANCE),
        variable.start * (1.0 + _DATA_SHEET_TOLERANCE),
    )
    return replace(variable, min=low, max=high)


def _told_by_fit(interface: Interface, words: Sequence[str]) -> dict[str, Variable]:
    own = {name: v for name, v in interface.parameters.items() if name.count(".") == 1}
    bounded = {name: v for name, v in own.items() if _is_bounded(v) and v.unit not in _MEASURED}
    return {
        name: v
        for name, v in bounded.items()
        if _speaks_of(v, words) and not _speaks_of(v, _CHOSEN)
    }
