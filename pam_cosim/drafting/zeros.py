"""The zero of a signal, from the rest that every recording begins with."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.column_statistics import REST_BAND, noise_of, span
from pam_cosim.drafting.feeding import BenchChoice, meaning_of
from pam_cosim.drafting.mapped import ColumnEntry, MappedRecording
from pam_cosim.drafting.values import NONZERO_READING
from pam_cosim.drafting.vocabulary import Meaning
from pam_cosim.model.interface import Interface
from pam_cosim.units import format_quantity
from pam_cosim.units.grammar import ATMOSPHERES

NO_PRESSURE = 0.05  # of the largest pressure; the muscle counts as without pressure below

SET_PRESSURE = Meaning("pressure", frozenset({"set"}))
ABSOLUTE_GAUGE = "as a gauge of absolute pressure does"


def with_zero(
    entry: ColumnEntry,
    name: str,
    choice: BenchChoice,
    interface: Interface,
    courses: Sequence[MappedRecording],
    pressure: dict[int, Array] | None,
) -> ColumnEntry:
    """The entry with a zero from the rest that every recording begins with, where it is away from zero there."""
    variable = {**interface.inputs, **interface.outputs}[name]
    meaning = meaning_of(variable)
    having = [i for i, course in enumerate(courses) if name in course.every]
    if meaning is None or any(courses[i].first_rest is None for i in having):
        return entry
    begin = _begin(name, [courses[i] for i in having])
    reason = ""
    if meaning.kind == "pressure" and not meaning.roles:
        reason = _reason_of_gauge(begin)
    elif meaning == SET_PRESSURE:
        if begin.absolute and _is_measured_absolute(interface, courses):
            reason = _reason_of_gauge(begin)
    elif begin.far and _unloaded(courses, pressure, having):
        is_clear = name in choice.outputs or begin.common
        reason = _reason_of_unloaded(meaning, begin) if is_clear else ""
    if not reason:
        return entry
    reading = format_quantity(begin.reading, variable.unit)
    zero = _common({i: _times(courses[i]) for i in having}, courses)
    why = (*entry.why, f"{reason.format(reading=reading)}: its zero")
    return replace(entry, zero=zero, why=why)


def _reason_of_gauge(begin: _Begin) -> str:
    """Why a pressure gets a zero; "" where it needs none."""
    if begin.absolute:
        return f"it begins with {{reading}}, {ABSOLUTE_GAUGE}"
    return "it begins at rest with {reading}" if begin.far and begin.slight else ""


def _is_measured_absolute(interface: Interface, courses: Sequence[MappedRecording]) -> bool:
    """Whether the pressure of a muscle begins with that of the atmosphere in all recordings that have it."""
    variables = {**interface.inputs, **interface.outputs}
    measured = [n for n, v in variables.items() if meaning_of(v) == Meaning("pressure")]
    having = {n: [c for c in courses if n in c.every and c.first_rest] for n in measured}
    return any(_begin(name, own).absolute for name, own in having.items() if own)


def _reason_of_unloaded(meaning: Meaning, begin: _Begin) -> str:
    """Why what is read of a muscle without pressure gets a zero; "" where it needs none."""
    small_force = (
        meaning.kind == "force" and abs(begin.reading) <= CRITERIA.starts.offset * begin.largest
    )
    if meaning.kind == "contraction" or small_force:
        return "it begins at rest, without pressure, with {reading}"
    return ""


@dataclass(frozen=True)
class _Begin:
    """What a signal reads while recordings rest at their beginning.

    Attributes:
        reading: the one farthest from zero.
        far: it is away from zero by more than its error, in some recording.
        slight: by a small part of what the signal moves, in all.
        absolute: it is that of the atmosphere in all, and the signal moves.
        common: it is the same in all, and the lowest that the signal comes to in motion: as of a machine that sets out
            from where the muscle was mounted, and not from one of several contractions.
        largest: magnitude in any row.
    """

    reading: float
    far: bool
    slight: bool
    absolute: bool
    common: bool
    largest: float


def _begin(name: str, courses: Sequence[MappedRecording]) -> _Begin:
    at_rest = [_at_rest(course, course.every[name]) for course in courses]
    moved = max((span(course.every[name]) for course in courses), default=0.0)
    low, high = ATMOSPHERES
    errors = [_error(course, name) for course in courses]
    reading = max(at_rest, key=abs)
    lowest = min((float(np.nanmin(course.every[name])) for course in courses), default=0.0)
    magnitudes = [float(np.nanmax(np.abs(course.every[name]))) for course in courses]
    return _Begin(
        reading=reading,
        far=any(abs(one) > NONZERO_READING * e for one, e in zip(at_rest, errors, strict=True)),
        slight=all(abs(one) <= CRITERIA.starts.offset * moved for one in at_rest),
        absolute=moved > 0.0 and all(low <= one <= high for one in at_rest),
        common=moved > 0.0
        and reading - lowest <= CRITERIA.starts.offset * moved
        and all(
            abs(one - reading) <= NONZERO_READING * e
            for one, e in zip(at_rest, errors, strict=True)
        ),
        largest=max(magnitudes, default=0.0),
    )


def _at_rest(course: MappedRecording, values: Array) -> float:
    assert course.first_rest is not None
    part = values[course.first_rest.start : course.first_rest.stop]
    return float(np.nanmean(part)) if np.isfinite(part).any() else 0.0


def _error(course: MappedRecording, name: str) -> float:
    """Of a mean at rest [unit]; at least what is not seen."""
    values = course.every[name]
    assert course.first_rest is not None
    return max(
        noise_of(course.time, values) / sqrt(course.first_rest.count),
        REST_BAND * span(values) / NONZERO_READING,
    )


def _unloaded(
    courses: Sequence[MappedRecording], pressure: dict[int, Array] | None, having: Sequence[int]
) -> bool:
    """Whether there is no pressure at the start of any of them, but for an offset."""
    if pressure is None:
        return False
    with_pressure = [i for i in having if i in pressure]
    largest = max((span(pressure[i]) for i in with_pressure), default=0.0)
    offsets = [_at_rest(courses[i], pressure[i] - np.nanmin(pressure[i])) for i in with_pressure]
    return largest > 0.0 and all(offset <= NO_PRESSURE * largest for offset in offsets)


def _times(course: MappedRecording) -> tuple[float, float]:
    rest = course.first_rest
    assert rest is not None
    return float(course.time[rest.start]), float(course.time[rest.stop - 1])


def _common(
    each: dict[int, tuple[float, float]], courses: Sequence[MappedRecording]
) -> dict[int, tuple[float, float]]:
    """One interval for all recordings, where their rests have enough samples in common."""
    start, stop = max(one for one, _ in each.values()), min(one for _, one in each.values())
    inside = [int(np.sum((courses[i].time >= start) & (courses[i].time <= stop))) for i in each]
    return (
        dict.fromkeys(each, (start, stop)) if min(inside) >= CRITERIA.noise.fewest_samples else each
    )


def without_offsets(
    arrays: Mapping[str, dict[int, Array]],
    entries: Mapping[str, ColumnEntry],
    times: Mapping[int, Array],
) -> dict[str, dict[int, Array]]:
    """The numbers of each column by recording, less its mean in the interval of its zero."""
    made: dict[str, dict[int, Array]] = {}
    for name, by_recording in arrays.items():
        zero = entries[name].zero
        made[name] = dict(by_recording)
        for i in zero.keys() & by_recording.keys():
            made[name][i] = by_recording[i] - _mean_between(times[i], by_recording[i], *zero[i])
    return made


def _mean_between(time: Array, values: Array, start: float, stop: float) -> float:
    inside = values[(time >= start) & (time <= stop)]
    inside = inside[np.isfinite(inside)]
    return float(np.mean(inside)) if inside.size else 0.0
