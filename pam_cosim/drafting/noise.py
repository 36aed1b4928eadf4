"""The noise of each signal, from where the recordings are at rest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pam_cosim.drafting.mapped import MappedRecording
from pam_cosim.drafting.rest import noise_at_rest
from pam_cosim.measurement.markers import marker_of
from pam_cosim.units import format_quantity


@dataclass(frozen=True)
class Sigma:
    """Standard deviation [SI], None where it is not told; and from where."""

    value: float | None
    why: str


def sigma_of(
    name: str, unit: str, courses: Sequence[MappedRecording], files: Sequence[Path]
) -> Sigma:
    """The median over the recordings, each of its longest rest."""
    told = []
    for course, file in zip(courses, files, strict=True):
        values = course.outputs.get(name)
        if values is None or not course.rest:
            continue
        rest = max(course.rest, key=lambda one: one.count)
        sigma, step = noise_at_rest(course.time, values, rest)
        if sigma > 0.0:
            told.append((sigma, step, rest, course, file))
    if not told:
        return Sigma(
            None, f"{_why_none(name, courses)}: the software estimates it from the samples"
        )
    value = float(np.median([one[0] for one in told]))
    _, step, rest, course, file = max(told, key=lambda one: one[2].count)
    first, last = (round(float(course.time[i]), 3) for i in (rest.start, rest.stop - 1))
    where = f"from {first:.15g} s to {last:.15g} s of {file.name}, where nothing moves"
    steps = f"; recorded in steps of {format_quantity(step, unit)}" if step > value else ""
    more = f" (median of {len(told)} recordings)" if len(told) > 1 else ""
    return Sigma(value, f"the scatter of neighbouring samples {where}{more}{steps}")


def _why_none(name: str, courses: Sequence[MappedRecording]) -> str:
    """Why the recordings tell no noise."""
    if not any(course.rest for course in courses):
        return "nothing is at rest long enough"
    values = [course.outputs[name] for course in courses if name in course.outputs]
    if values and marker_of(np.concatenate(values)) is not None:
        return "one number is far from all others, as where a sample is missing"
    return "it shows no noise at rest"
