"""The rows of a rig as every method gets them, and the score that every method is given. Needs NumPy alone."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.real_rigs.folders import EXAMPLES, ROLES, Array, read_columns

LOST = 10.0  # ranges; what a free run that leaves the scale or is not a number is scored as
Predict = Callable[["Course"], Array]


@dataclass(frozen=True)
class Course:
    """One run as it was recorded: time (n,), inputs (n, m), measured (n,), scored from a time on."""

    name: str
    time: Array
    inputs: Array
    measured: Array
    score_from: float

    def even(self, step: float) -> Course:
        """The same at equal intervals, missing samples bridged by straight lines."""
        there = ~np.isnan(self.measured)
        grid = np.arange(self.time[0], self.time[-1] + 1e-9, step)
        inputs = np.array([np.interp(grid, self.time, u) for u in self.inputs.T]).T.reshape(
            len(grid), -1
        )
        measured = np.interp(grid, self.time[there], self.measured[there])
        return Course(self.name, grid, inputs, measured, self.score_from)


@dataclass(frozen=True)
class Rows:
    """A rig: its courses by role, interval of time, whether it has points at rest, and the library of its bench."""

    name: str
    title: str
    signal: str
    step: float
    static: bool
    inputs: tuple[str, ...]
    courses: Mapping[str, tuple[Course, ...]]
    repeats: tuple[tuple[str, str], ...]
    library: tuple[Path, ...]

    @property
    def range(self) -> float:
        """Largest minus smallest measured value of all rows."""
        values = np.concatenate([c.measured for role in ROLES for c in self.courses[role]])
        return float(np.nanmax(values) - np.nanmin(values))

    @property
    def repeatability(self) -> float | None:
        """Root mean square of the difference of repeats over the square root of two, in ranges."""
        every = {c.name: c for role in ROLES for c in self.courses[role]}
        squares: list[float] = []
        for a, b in ((every[x], every[y]) for x, y in self.repeats):
            # repeats differ in when a valve was switched too: over time, as a free run is scored
            end = min(a.time[-1], b.time[-1])
            kept = a.time <= end
            squares.append(
                float(
                    np.mean((a.measured[kept] - np.interp(a.time[kept], b.time, b.measured)) ** 2)
                    / 2
                )
            )
        return float(np.sqrt(np.mean(squares))) / self.range if squares else None


def read_rows(folder: Path) -> Rows:
    """A rig from its folder."""
    about = json.loads((folder / "rig.json").read_text(encoding="utf-8"))
    names = tuple(about["inputs"])
    courses = {}
    for role in ROLES:
        own = []
        for run, score_from in about["runs"][role].items():
            table = read_columns(folder / role / f"{run}.csv")
            count = len(table[about["signal"]])
            inputs = np.array([table[n] for n in names]).T.reshape(count, len(names))
            time = table.get("time", np.zeros(count))
            own.append(Course(run, time, inputs, table[about["signal"]], score_from))
        courses[role] = tuple(own)
    return Rows(
        folder.name,
        about["title"],
        about["signal"],
        about["step"],
        about["static"],
        names,
        courses,
        repeats=tuple((a, b) for a, b in about["repeats"]),
        library=library_of(about),
    )


def library_of(about: Mapping[str, Any]) -> tuple[Path, ...]:
    """The library that the bench of a rig is from, by what is said about the rig; none: that of the package."""
    return (EXAMPLES / about["library"],) if about["library"] else ()


def score(rows: Rows, predicted: Mapping[str, Mapping[str, Array]]) -> dict[str, dict[str, float]]:
    """Root mean square error of every run by role, in ranges.

    Args:
        rows: the rig.
        predicted: by role and run (n,) at the run's own rows; NaN in rows that are not scored.
    """
    scores: dict[str, dict[str, float]] = {}
    for role in ROLES:
        for course in rows.courses[role]:
            values = predicted.get(role, {}).get(course.name)
            scores.setdefault(role, {})[course.name] = _error(course, values, rows.range)
    return scores


def overall(scores: Mapping[str, float]) -> float:
    """Root mean square of the errors of the runs of a role, each of them no more than what is lost."""
    return float(np.sqrt(np.mean([min(e, LOST) ** 2 for e in scores.values()])))


def _error(course: Course, values: Array | None, span: float) -> float:
    if values is None:
        return LOST
    kept = ~np.isnan(course.measured) & (course.time >= course.score_from)
    error = (values - course.measured)[kept] / span
    started = np.isnan(values[kept]) & (
        np.cumsum(~np.isnan(values[kept])) == 0
    )  # first samples, which it was given
    error = error[~started]
    value = float(np.sqrt(np.mean(error**2))) if len(error) else LOST
    return min(value, LOST) if np.isfinite(value) else LOST
