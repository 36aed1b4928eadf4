"""Tables of points at rest: imposed values and direction of each row, and the rows that are held out."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.column_statistics import span
from pam_cosim.drafting.direction import (
    common_direction,
    directions_in_names,
    goes_up_and_down,
    order_tells_direction,
)
from pam_cosim.drafting.mapped import MappedRecording
from pam_cosim.drafting.roles import HELD_OUT_SHARE
from pam_cosim.drafting.stated_value import text_of
from pam_cosim.errors import InputError
from pam_cosim.measurement.curves import ROWS_PER_LEVEL, curves, levels
from pam_cosim.measurement.points import VALUE_TOLERANCE
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import BRANCH
from pam_cosim.units import readable_unit

_LEVELS_TO_HOLD_OUT = 4  # values of an imposed quantity, at least, of which some are held out
_POINTS_TO_HOLD_OUT = 8  # the same along a single curve, which needs most of its points


@dataclass(frozen=True)
class PointsDraft:
    """Keys of ``experiment.toml`` for tables of points at rest.

    Attributes:
        branch: direction by recording, "" where a column has it or it is unknown.
        hold_out: by recording, values that are held out, by input.
    """

    branch: tuple[str, ...]
    hold_out: tuple[dict[str, list[str]], ...]


def check_imposed(
    unfed: Sequence[str], known: Sequence[Collection[str]], interface: Interface
) -> None:
    """Checks that every imposed input has a value in each row.

    Args:
        unfed: inputs without a column, and without a value in the names of the files.
        known: by recording, names of the values that the user states.
        interface: of the bench.

    Raises:
        InputError: an imposed input has no value; the message names the option that states it.
    """
    missing = [name for name in unfed if not all(name in own for own in known)]
    if missing:
        one = interface.inputs[missing[0]]
        unit = {"Pa": "kPa", "m": "mm"}.get(one.unit, readable_unit(one.unit))
        what = one.description[:1].lower() + one.description[1:]
        say = f"--parameter '{one.name}=0 {unit}' for all rows, or --parameter '{one.name}@FILE=0 {unit}' for each file"
        raise InputError(
            f"no column and no file's name tells the {what} ({one.name}); say it: {say}"
        )


def drafted(
    courses: Sequence[MappedRecording], interface: Interface, files: Sequence[Path], by_run: bool
) -> PointsDraft:
    """Directions by the names of the files or the order of the rows where no column has them, and rows to hold out.

    Args:
        by_run: whole recordings are held out.
    """
    units = {name: variable.unit for name, variable in interface.inputs.items()}
    rows = [_imposed(course) for course in courses]
    known = any(BRANCH in course.inputs for course in courses)
    branch = [""] * len(courses) if known else directions_in_names(files) or _by_order(rows, units)
    hold_out: list[dict[str, list[str]]] = [
        {} if by_run else _held_out(own, course.outputs, interface)
        for own, course in zip(rows, courses, strict=True)
    ]
    return PointsDraft(tuple(branch), tuple(hold_out))


def _by_order(rows: Sequence[Mapping[str, Array]], units: Mapping[str, str]) -> list[str]:
    """ "order" where rows go up and come back, in a file or from one to another; "" for all where they do not."""
    between_files = {common_direction(own, units) for own in rows} >= {1, -1}
    if not between_files and not any(goes_up_and_down(own, units) for own in rows):
        return [""] * len(rows)
    return ["order" if order_tells_direction(own, units) else "none" for own in rows]


def _imposed(course: MappedRecording) -> dict[str, Array]:
    """The imposed inputs, in the rows that have a value of each."""
    inputs = {name: values for name, values in course.inputs.items() if name != BRANCH}
    whole = np.all([np.isfinite(values) for values in inputs.values()], axis=0)
    return {name: values[whole] for name, values in inputs.items()}


def _held_out(
    inputs: Mapping[str, Array], outputs: Mapping[str, Array], interface: Interface
) -> dict[str, list[str]]:
    """Values of the input with the most levels, within the span of the others; none where there are few levels."""
    found = curves(
        inputs, {n: v for n, v in outputs.items() if len(v) == len(next(iter(inputs.values())))}
    )
    along = found[0].along
    least = dict.fromkeys(found[0].at, _LEVELS_TO_HOLD_OUT) | {along: _POINTS_TO_HOLD_OUT}
    if len(found) > 1:
        least[along] = _LEVELS_TO_HOLD_OUT
    every = {name: _levels(inputs[name]) for name in least}
    able = {name: values for name, values in every.items() if len(values) >= least[name]}
    if not able:
        return {}
    name, values = max(able.items(), key=lambda one: len(one[1]))
    count = max(1, round(HELD_OUT_SHARE * len(values)))
    places = np.round(np.linspace(0, len(values) - 1, count + 2)[1:-1]).astype(int)
    return {name: [text_of(values[i], interface.inputs[name].unit) for i in places]}


def _levels(values: Array) -> list[float]:
    """The levels that readings repeat, each as it was read; none where the readings do not cluster."""
    exact = np.unique(values)
    near = VALUE_TOLERANCE * span(values)
    is_apart = float(np.diff(exact).min(initial=np.inf)) > near
    if is_apart and ROWS_PER_LEVEL * len(exact) <= len(values):
        return [float(value) for value in exact]
    number = levels(values)
    if number is None:
        return []
    groups = [values[number == k] for k in range(int(number.max(initial=0)) + 1)]
    middle = [float(np.median(group)) for group in groups]
    clear = all(float(np.max(np.abs(g - m))) <= near for g, m in zip(groups, middle, strict=True))
    return middle if clear else []
