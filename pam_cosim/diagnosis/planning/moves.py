"""Courses that are drawn, taken from recordings, and made out of others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.diagnosis.planning.course import LEVELS, Course
from pam_cosim.diagnosis.planning.limits import Limits, Range
from pam_cosim.measurement import Run

_RECORDED_LEVELS = 60  # of a recorded course that is improved, at most
_CYCLES = (0.5, 20.0)  # in a run, of the slowest and the fastest sine

Random = np.random.Generator


@dataclass(frozen=True)
class Moves:
    """What courses there are within limits.

    Attributes:
        limits: of the rig.
        runs: that were recorded: which values its inputs have together.
    """

    limits: Limits
    runs: Sequence[Run]

    @property
    def _ranges(self) -> Array:
        """(k, 2) of the inputs that move."""
        return np.array([self.limits.inputs[name] for name in self.limits.moving]).reshape(-1, 2)

    def drawn(self, rng: Random) -> Course:
        """A staircase, ramps, a few steps or sines, at random."""
        kind = ("steps", "staircase", "ramps", "sines")[int(rng.integers(4))]
        fewest, most = LEVELS
        if kind == "sines":
            count = 1
        elif kind == "steps":
            count = int(rng.integers(fewest, 2 * fewest + 1))
        else:
            count = int(rng.integers(2 * fewest, most + 1))
        knots = np.sort(np.concatenate([[0.0], rng.uniform(size=count - 1)]))
        levels = np.array([self._level(rng) for _ in range(count)]).reshape(count, -1)
        waves = np.zeros((len(self.limits.moving), 4))
        if kind == "sines":
            waves = np.array([self._wave(rng) for _ in self.limits.moving]).reshape(-1, 4)
        return Course(
            knots,
            levels,
            kind != "ramps",
            waves,
            self._constants(rng),
            self._each(rng, self.limits.parameters),
        )

    def recorded(self) -> list[Course]:
        """The runs that there are, as long as a new one lasts, within the limits."""
        return [self._of_run(run) for run in self.runs]

    def changed(self, rng: Random, course: Course) -> Course:
        """The same with one to three things changed."""
        for _ in range(int(rng.integers(1, 4))):
            course = self._changed_once(rng, course)
        return course

    def joined(self, rng: Random, a: Course, b: Course) -> Course:
        """The beginning of one and the end of another; what is set before the run comes from either."""
        cut = rng.uniform()
        early, late = a.knots <= cut, b.knots > cut
        first, second = (a, b) if rng.random() < 0.5 else (b, a)
        return replace(
            a,
            knots=np.concatenate([a.knots[early], b.knots[late]]),
            levels=np.concatenate([a.levels[early], b.levels[late]]),
            waves=first.waves,
            constants=first.constants,
            parameters=second.parameters,
        )

    def _of_run(self, run: Run) -> Course:
        low, high = self._ranges.T
        seconds = run.time - run.time[0]
        columns = np.column_stack(
            [run.inputs[n] for n in self.limits.moving] or [np.zeros((len(seconds), 0))]
        )
        bends = np.flatnonzero(np.any(np.diff(columns, axis=0) != 0, axis=1)) + 1
        is_stepped = run.interpolation == "previous"
        rows = np.unique(
            np.concatenate([[0], bends, bends - 1] if not is_stepped else [[0], bends])
        )
        if len(rows) > _RECORDED_LEVELS:
            rows = rows[np.linspace(0, len(rows) - 1, _RECORDED_LEVELS).astype(int)]
        rows = rows[seconds[rows] <= self.limits.seconds]
        constants = {
            n: _within(float(run.inputs[n][0]), self.limits.inputs[n]) for n in self.limits.constant
        }
        parameters = {
            n: _within(run.parameters[n], limits) for n, limits in self.limits.parameters.items()
        }
        return Course(
            seconds[rows] / self.limits.seconds,
            np.clip(columns[rows], low, high),
            is_stepped,
            np.zeros((len(self.limits.moving), 4)),
            constants,
            parameters,
        )

    def _changed_once(self, rng: Random, course: Course) -> Course:
        kinds = ["level", "row", "knot", "more", "less", "constant", "wave", "stepped"]
        kind = kinds[int(rng.integers(len(kinds)))]
        count, inputs = course.levels.shape
        if not inputs or (kind == "constant" and (course.constants or course.parameters)):
            return self._changed_constant(rng, course)
        i, j = int(rng.integers(count)), int(rng.integers(inputs))
        match kind:
            case "level":
                return self._with_other_value(rng, course, i, j)
            case "row":
                return replace(course, levels=_with_row(course.levels, i, self._level(rng)))
            case "knot" if i:
                return _with_moved_knot(rng, course, i)
            case "more":
                return self._with_knot(rng, course)
            case "less" if i:
                return replace(
                    course,
                    knots=np.delete(course.knots, i),
                    levels=np.delete(course.levels, i, axis=0),
                )
            case "wave":
                wave = self._wave(rng) if rng.random() < 0.5 else np.zeros(course.waves.shape[1])
                return replace(course, waves=_with_row(course.waves, j, wave))
            case "stepped":
                return replace(course, is_stepped=not course.is_stepped)
        return course

    def _with_other_value(self, rng: Random, course: Course, i: int, j: int) -> Course:
        """Another value of input ``j`` at knot ``i``: near the present one, or anything of its range."""
        low, high = self._ranges[j]
        levels = course.levels.copy()
        nearby_value = float(np.clip(levels[i, j] + rng.normal(0.0, 0.2) * (high - low), low, high))
        levels[i, j] = nearby_value if rng.random() < 0.5 else self._value(rng, (low, high))
        return replace(course, levels=levels)

    def _with_knot(self, rng: Random, course: Course) -> Course:
        """One more knot, with levels of its own."""
        time = rng.uniform()
        place = int(np.searchsorted(course.knots, time, side="right"))
        levels = np.insert(course.levels, place, self._level(rng), axis=0)
        return replace(course, knots=np.insert(course.knots, place, time), levels=levels)

    def _changed_constant(self, rng: Random, course: Course) -> Course:
        names = [*course.constants, *course.parameters]
        if not names:
            return course
        name = names[int(rng.integers(len(names)))]
        ranges = {**self.limits.inputs, **self.limits.parameters}
        value = self._value(rng, ranges[name])
        if name in course.constants:
            return replace(course, constants={**course.constants, name: value})
        return replace(course, parameters={**course.parameters, name: value})

    def _level(self, rng: Random) -> Array:
        """(k,) values that were recorded together; of each input with chance 1/3 another one of its range."""
        if not self.limits.moving:
            return np.zeros(0)
        run = self.runs[int(rng.integers(len(self.runs)))]
        row = int(rng.integers(len(run.time)))
        low, high = self._ranges.T
        values = np.clip([run.inputs[name][row] for name in self.limits.moving], low, high)
        for i, limits in enumerate(self._ranges):
            if rng.integers(3) == 0:
                values[i] = self._value(rng, (float(limits[0]), float(limits[1])))
        return np.asarray(values)

    def _value(self, rng: Random, limits: Range) -> float:
        """An end of a range, or anything between, each as likely."""
        return (limits[0], limits[1], float(rng.uniform(*limits)))[int(rng.integers(3))]

    def _wave(self, rng: Random) -> Array:
        """(4,) a sine, slow or fast, or one that gets faster or slower."""
        slow, fast = np.log(_CYCLES)
        first, last = np.exp(rng.uniform(slow, fast, size=2))
        return np.array(
            [rng.uniform(0.1, 1.0), first, first if rng.random() < 0.5 else last, rng.uniform()]
        )

    def _constants(self, rng: Random) -> dict[str, float]:
        return self._each(
            rng, {n: self.limits.inputs[n] for n in self.limits.inputs if n in self.limits.constant}
        )

    def _each(self, rng: Random, ranges: Mapping[str, Range]) -> dict[str, float]:
        return {name: float(rng.uniform(*limits)) for name, limits in ranges.items()}


def _with_row(rows: Array, i: int, values: Array) -> Array:
    changed = rows.copy()
    changed[i] = values
    return changed


def _with_moved_knot(rng: Random, course: Course, i: int) -> Course:
    """Knot ``i`` at another time between its neighbours, or the end of the run."""
    knots = course.knots.copy()
    after = knots[i + 1] if i + 1 < len(knots) else 1.0
    knots[i] = rng.uniform(knots[i - 1], after)
    return replace(course, knots=knots)


def _within(value: float, limits: Range) -> float:
    return min(max(value, limits[0]), limits[1])
