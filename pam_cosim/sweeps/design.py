"""Which runs a sweep makes: a grid, a list, random points or a Latin hypercube."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from math import prod
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.settings import Setting, resolve, settable, value_of
from pam_cosim.sweeps.patterns import INPUTS, Pattern
from pam_cosim.sweeps.spans import MOST_RUNS, values_in

DESIGNS = ("grid", "list", "random", "latin-hypercube")


@dataclass(frozen=True)
class Design:
    """The runs of a sweep.

    Attributes:
        kind: one of ``DESIGNS``.
        units: of each name that is varied, in order.
        points: (runs, names) [``units``].
        axes: of a grid, the values of each name [its unit]; the last name changes fastest. Empty for other designs.
        patterns: inputs over time, where these are varied; the points then hold their places.
    """

    kind: str
    units: dict[str, str]
    points: Array
    axes: dict[str, Array]
    patterns: tuple[Pattern, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """What is varied."""
        return tuple(self.units)

    def __len__(self) -> int:
        return len(self.points)

    def settings(self, run: int) -> dict[str, float]:
        """What is varied in a run, counted from 0 [SI]; inputs over time by their place."""
        return dict(zip(self.units, self.points[run].tolist(), strict=True))

    def labels(self, name: str, values: Array) -> Any:
        """Labels (n,) in results for values (n,) of a name: the values [SI], or the names of inputs over time."""
        if not (self.patterns and name == INPUTS):
            return values
        return np.array([self.patterns[int(v)].name for v in values], dtype=object)


def design_of(
    vary: Mapping[str, Iterable[Setting]] | Sequence[Mapping[str, Setting]] | Any,
    interface: Interface,
    kind: str = "grid",
    runs: int | None = None,
    seed: int = 0,
    patterns: tuple[Pattern, ...] = (),
) -> Design:
    """The runs of a sweep.

    Args:
        vary: "grid": the values of each name; "list": those of each name, run by run, all equally many, or a mapping
            for each run, or a pandas frame; "random" and "latin-hypercube": for each name the lowest and the highest
            value. Values are a list, or a span as a text (``spans``).
        interface: of the model.
        kind: one of ``DESIGNS``.
        runs: how many, of "random" and "latin-hypercube".
        seed: of the random numbers; the same seed makes the same runs.
        patterns: what "inputs" in ``vary`` stands for.

    Raises:
        InputError: another design, an unknown name, a value that cannot be used, no run at all or too many.
    """
    sampled = kind in ("random", "latin-hypercube")
    if kind not in DESIGNS:
        raise InputError(f"there is no design '{kind}'; there are {', '.join(DESIGNS)}")
    columns = _columns(vary, kind)
    if not columns:
        raise InputError(
            "nothing is varied: name a parameter, an input or a start value and its values"
        )
    if patterns and sampled:
        raise InputError(
            f"the design '{kind}' draws between two values, and '{INPUTS}' has none; use grid or list"
        )
    values: dict[str, Array] = {}
    units: dict[str, str] = {}
    for name, given in columns.items():
        if patterns and name == INPUTS:
            values[name], units[name] = np.arange(len(patterns), dtype=float), "1"
        else:
            variable = settable(name, interface)
            values[name], units[name] = _values(name, given, variable, sampled), variable.unit
    _check_count(kind, runs, sampled)
    if kind == "grid":
        return replace(_grid(values, units), patterns=patterns)
    points = _sampled(values, kind, runs or 0, seed) if sampled else _listed(values)
    for point in points:
        settings = dict(zip(values, point.tolist(), strict=True))
        if patterns:
            settings.pop(INPUTS, None)
        resolve(settings, interface)
    return Design(kind, units, points, {}, patterns)


def _check_count(kind: str, runs: int | None, sampled: bool) -> None:
    """Raises InputError: where a number of runs is given that the values determine, or none where they do not."""
    if sampled and runs is None:
        raise InputError(f"the design '{kind}' needs a number of runs; give the number of runs")
    if not sampled and runs is not None:
        raise InputError(
            f"the design '{kind}' takes its runs from the values; leave out the number of runs"
        )


def _columns(vary: Any, kind: str) -> dict[str, Any]:
    """Values by name; of a pandas frame its columns, of mappings run by run what they have in common."""
    if hasattr(vary, "to_dict") and not isinstance(vary, Mapping):
        return dict(vary.to_dict("list"))
    if isinstance(vary, Mapping):
        return dict(vary)
    rows = list(vary)
    if kind != "list" or not all(isinstance(row, Mapping) for row in rows):
        raise InputError("what is varied is given by name: a name and its values")
    if any(list(row) != list(rows[0]) for row in rows):
        raise InputError("every run of a list must set the same names, in the same order")
    return {name: [row[name] for row in rows] for name in (rows[0] if rows else {})}


def _values(name: str, given: Any, variable: Variable, sampled: bool) -> Array:
    """The values of one name [SI]."""
    if isinstance(given, str) and ":" in given:
        return np.array(values_in(given, name, variable, sampled))
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise InputError(f"'{name}' is varied: give a list of values, not one")
    values = [value_of(value, variable) for value in given]
    if not values:
        raise InputError(f"'{name}' is varied over no value at all; give one at least")
    return np.array(values)


def _grid(values: Mapping[str, Array], units: dict[str, str]) -> Design:
    count = prod(len(column) for column in values.values())
    if count > MOST_RUNS:
        raise InputError(f"these are {count} combinations; a sweep has {MOST_RUNS} runs at most")
    return Design("grid", units, np.array(list(product(*values.values()))), dict(values))


def _listed(values: Mapping[str, Array]) -> Array:
    counts = {name: len(column) for name, column in values.items()}
    if len(set(counts.values())) > 1:
        counts_text = ", ".join(f"{name} {count}" for name, count in counts.items())
        raise InputError(f"a list needs as many values of every name: {counts_text}")
    points = np.stack(list(values.values()), axis=1)
    if len(points) > MOST_RUNS:
        raise InputError(f"these are {len(points)} runs; a sweep has {MOST_RUNS} at most")
    return points


def _sampled(values: Mapping[str, Array], kind: str, runs: int, seed: int) -> Array:
    for name, ends in values.items():
        if len(ends) != 2 or not ends[0] < ends[1]:
            raise InputError(
                f"'{name}': the design '{kind}' needs its lowest and its highest value, and no more"
            )
    if not 1 <= runs <= MOST_RUNS:
        raise InputError(f"a sweep has between 1 and {MOST_RUNS} runs, not {runs}")
    low, high = np.stack(list(values.values()), axis=1)
    generator = np.random.default_rng(seed)
    if kind == "random":
        unit = generator.random((runs, len(values)))
    else:
        from scipy.stats import qmc  # half a second, which few need

        unit = qmc.LatinHypercube(d=len(values), rng=generator).random(runs)
    return np.asarray(low + unit * (high - low))
