"""Which recordings are held out: they differ from those that are fitted, and lie within what those span."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.column_statistics import is_constant, span
from pam_cosim.drafting.mapped import MappedRecording
from pam_cosim.drafting.recorded_column import IMPOSED_RANGE
from pam_cosim.drafting.sources import RecordingSource, places_of
from pam_cosim.errors import InputError
from pam_cosim.measurement import ROLES
from pam_cosim.measurement.run_names import patterns_first
from pam_cosim.model.interface import Interface
from pam_cosim.units import format_quantity
from pam_cosim.wording import shown

_SAME_TRAIT = 0.02  # of the largest value: smaller differences do not distinguish runs
HELD_OUT_SHARE = 0.25  # share of the runs, or of the values of a table, that are held out
_RUNS_TO_HOLD_OUT = 3  # at least; fewer runs are all needed for the fit


@dataclass(frozen=True)
class Role:
    """``fit`` or ``holdout``, and why."""

    role: str
    why: str = ""


@dataclass(frozen=True)
class _Trait:
    """One number of each recording, such as the mean of an input; NaN where it has none.

    ``imposed``: it is of an input, which the experimenter chose.
    """

    name: str
    unit: str
    values: Array
    imposed: bool = False


def roles(
    courses: Sequence[MappedRecording],
    interface: Interface,
    own: Sequence[dict[str, float]] = (),
    *,
    paced: bool = True,
) -> list[Role]:
    """One for each recording; those of points at rest have no pace.

    A quarter is held out, each the one that differs most from its nearest neighbour among those that are fitted while
    every trait of it (level, span and pace of each signal, and what is known of the run) lies between theirs; where
    there is none, the one that lies least outside.
    """
    count = len(courses)
    made = [Role("fit") for _ in courses]
    if count < _RUNS_TO_HOLD_OUT:
        return made
    traits = [
        t
        for t in _traits(courses, interface, own, paced)
        if np.isfinite(t.values).all()
        and span(t.values) > _SAME_TRAIT * float(np.max(np.abs(t.values)))
    ]
    if not traits:
        made[-1] = Role("holdout", "the last: as far as is seen, all are alike")
        return made
    scaled = np.array([(t.values - t.values.min()) / span(t.values) for t in traits]).T
    left = list(range(count))
    for _ in range(max(1, round(HELD_OUT_SHARE * count))):
        order = sorted((_outside(scaled, left, i), -_apart(scaled, left, i), i) for i in left)
        outside, _, chosen = order[0]
        left.remove(chosen)
        made[chosen] = Role("holdout", _why(traits, scaled, left, chosen, outside))
    return made


def _traits(
    courses: Sequence[MappedRecording],
    interface: Interface,
    own: Sequence[dict[str, float]],
    paced: bool,
) -> list[_Trait]:
    variables = {**interface.inputs, **interface.outputs, **interface.parameters}
    traits = []
    for name in dict.fromkeys(name for course in courses for name in course.every):
        unit, imposed = variables[name].unit, name in interface.inputs
        values = [course.every.get(name) for course in courses]
        traits.append(
            _Trait(f"mean of {name}", unit, _each(values, lambda v: float(np.nanmean(v))), imposed)
        )
        if _all_held(values):
            continue
        traits.append(_Trait(f"span of {name}", unit, _each(values, span), imposed))
        if paced:
            paces = [
                np.nan if v is None else _pace(c.time, v)
                for c, v in zip(courses, values, strict=True)
            ]
            traits.append(_Trait(f"pace of {name}", f"{unit}/s", np.array(paces), imposed))
    for name in dict.fromkeys(name for values in own for name in values):
        traits.append(
            _Trait(
                name, variables[name].unit, np.array([values.get(name, np.nan) for values in own])
            )
        )
    return traits


def _all_held(values: Sequence[Array | None]) -> bool:
    """Whether a signal moves in no recording by more than a small part of what it differs by between them."""
    recorded = [v for v in values if v is not None]
    whole = span(np.concatenate(recorded))
    return all(span(v) <= IMPOSED_RANGE * whole or is_constant(v) for v in recorded)


def _pace(time: Array, values: Array) -> float:
    """How far a signal goes in a second, up and down, in some two hundred steps."""
    steps = np.diff(values[:: max(1, len(values) // 200)])
    return float(np.nansum(np.abs(steps))) / (float(np.ptp(time)) or np.inf)


def _each(values: Sequence[Array | None], number: Callable[[Array], float]) -> Array:
    return np.array(
        [np.nan if v is None or not np.isfinite(v).any() else number(v) for v in values]
    )


def _outside(scaled: Array, left: Sequence[int], one: int) -> float:
    """How far a recording lies outside what the others span, summed over the traits."""
    others = scaled[[i for i in left if i != one]]
    low, high = others.min(axis=0), others.max(axis=0)
    return round(
        float(np.sum(np.maximum(low - scaled[one], 0.0) + np.maximum(scaled[one] - high, 0.0))), 9
    )


def _apart(scaled: Array, left: Sequence[int], one: int) -> float:
    """Distance to the nearest other."""
    others = scaled[[i for i in left if i != one]]
    return float(np.min(np.sqrt(np.sum((others - scaled[one]) ** 2, axis=1))))


def stated_roles(
    guessed: Sequence[Role], sources: Sequence[RecordingSource], stated: Mapping[str, str]
) -> list[Role]:
    """The roles, those by name or pattern that the user states instead of guesses.

    Raises:
        InputError: there is no such recording or role, or none would be left to fit.
    """
    made = list(guessed)
    for name, role in patterns_first(stated):
        called = places_of(name, sources)
        if role not in ROLES:
            raise InputError(
                f"{shown(role)} is no role of a recording; it is one of {', '.join(ROLES)}"
            )
        for i in called:
            made[i] = Role(role)
    if not any(one.role == "fit" for one in made):
        raise InputError("no recording would be left to fit")
    return made


def _why(
    traits: Sequence[_Trait], scaled: Array, left: Sequence[int], one: int, outside: float
) -> str:
    """The trait in which it differs most from its nearest neighbour; where none lies within, by which it is beyond."""
    if outside > 0.0:
        most = int(np.argmax([_outside(scaled[:, [k]], left, one) for k in range(len(traits))]))
        said = _said(traits[most], left, one)
        return f"none lies within what the others span, and this one goes least beyond it: {said}"
    near = min(left, key=lambda i: float(np.sum((scaled[i] - scaled[one]) ** 2)))
    differs = np.abs(scaled[near] - scaled[one])
    imposed = [k for k, trait in enumerate(traits) if trait.imposed and differs[k] > 0.0]
    most = max(imposed or range(len(traits)), key=lambda k: float(differs[k]))
    said = _said(traits[most], left, one)
    return f"it lies within what the fitted runs span and differs from each: {said}"


def _said(trait: _Trait, left: Sequence[int], one: int) -> str:
    """A trait of a run, and what the others span."""
    low, high = float(np.min(trait.values[left])), float(np.max(trait.values[left]))
    own, *ends = (format_quantity(v, trait.unit) for v in (float(trait.values[one]), low, high))
    return f"{trait.name} {own}, theirs {' to '.join(ends)}"
