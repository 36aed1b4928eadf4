"""The noise of each signal, from where the recordings are at rest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pam_cosim.drafting.mapped import MappedRecording
from pam_cosim.drafting.rest import noise_at_rest
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
        why = (
            "nothing is at rest long enough"
            if not any(c.rest for c in courses)
            else "it shows no noise at rest"
        )
        return Sigma(None, f"{why}: the software estimates it from the samples")
    value = float(np.median([one[0] for one in told]))
    _, step, rest, course, file = max(told, key=lambda one: one[2].count)
    first, last = (round(float(course.time[i]), 3) for i in (rest.start, rest.stop - 1))
    where = f"from {first:.15g} s to {last:.15g} s of {file.name}, where nothing moves"
    steps = f"; recorded in steps of {format_quantity(step, unit)}" if step > value else ""
    more = f" (median of {len(told)} recordings)" if len(told) > 1 else ""
    return Sigma(value, f"the scatter of neighbouring samples {where}{more}{steps}")
