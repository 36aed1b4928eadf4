"""The product of planning: runs that a rig can play, and what each of them is expected to decide."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.exports import Columns, Tabular
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, listed, look_first

NO_EFFECT = "no effect"
"""Name of the model without effects among rivals."""
_STRENGTH = ", each as weak as the recordings just show it"


@dataclass(frozen=True)
class Separation:
    """How far apart two rivals are expected to be.

    Attributes:
        first, second: effects of the two models, joined by " + ".
        chi2: that the wrong one of them is expected to leave more than the right one, after it was fitted again.
    """

    first: str
    second: str
    chi2: float

    @property
    def decides(self) -> bool:
        """Whether that is very strong evidence."""
        return self.chi2 >= CRITERIA.evidence.very_strong


@dataclass(frozen=True)
class PlannedRun:
    """One run.

    Attributes:
        parameters: what is set before it [SI].
        table: columns of time [s] and inputs [SI] where any of them bends; lines join the rows, and a step is two rows
            at one time.
        separations: of each pair of models with different families, by this run alone.
        at_random: the same for the pair that is least apart, by a course drawn at random, in the median; NaN: none of
            those that were drawn could be simulated.
        time: (n,) [s] of the predictions.
        predicted: by rival and signal (n,) [SI].
    """

    json_keys = "parameters table separations chi2 at_random"

    parameters: dict[str, float]
    table: dict[str, list[float]]
    separations: tuple[Separation, ...]
    at_random: float
    time: Array
    predicted: dict[str, dict[str, Array]]

    @property
    def chi2(self) -> float:
        """Of the pair that is least apart."""
        return min(s.chi2 for s in self.separations)

    @property
    def inputs(self) -> dict[str, Array]:
        """(n,) values of each input at the times of the predictions [SI]; of a step the first row is before it."""
        at = np.array(self.table["time"])
        is_last = np.append(np.diff(self.time) > 0, True)
        after, before = (
            np.searchsorted(at, self.time, side="right") - 1,
            np.searchsorted(at, self.time, side="left"),
        )
        on_row = np.isin(self.time, at)
        columns = {name: np.array(values) for name, values in self.table.items() if name != "time"}
        return {
            name: np.where(
                on_row, values[np.where(is_last, after, before)], np.interp(self.time, at, values)
            )
            for name, values in columns.items()
        }


@dataclass(frozen=True)
class RunPlan(Printed, Tabular):
    """Runs that would decide between the models that a diagnosis leaves, or test the one that it names.

    Attributes:
        title: of the data set.
        model: the base model.
        verdict: kind of the verdict.
        rivals: effects of each model, joined by " + ": those of one explanation after one another, best first.
        explanations: the same, of each set of families the models that stand for it.
        families: of these effects.
        runs: to be made, one after another.
        units: by name of an input, a parameter or a signal.
        sigma: noise of each signal [SI].
        tried: courses that were simulated.
        warnings: of the model that the verdict is about, in the recorded runs.
    """

    json_keys = (
        "title model verdict rivals explanations families chi2 decides expectation separations "
        "tried units runs warnings?"
    )

    title: str
    model: str
    verdict: str
    rivals: tuple[str, ...]
    explanations: tuple[tuple[str, ...], ...]
    families: tuple[str, ...]
    runs: tuple[PlannedRun, ...]
    units: dict[str, str]
    sigma: dict[str, float]
    tried: int
    warnings: tuple[str, ...] = ()

    @property
    def separations(self) -> tuple[Separation, ...]:
        """Of each pair of rivals, by all runs together."""
        first = self.runs[0].separations
        sums = [sum(run.separations[i].chi2 for run in self.runs) for i in range(len(first))]
        return tuple(
            Separation(s.first, s.second, chi2) for s, chi2 in zip(first, sums, strict=True)
        )

    @property
    def chi2(self) -> float:
        """Expected between the two rivals that are least apart."""
        return min(s.chi2 for s in self.separations)

    @property
    def tests(self) -> bool:
        """Whether the verdict left no choice: its model, the first explanation, is told from each other one."""
        return self.verdict in ("identified", "none_missing")

    @property
    def decides(self) -> bool:
        """Whether every pair of rivals is expected to be predictions apart by very strong evidence."""
        return all(s.decides for s in self.separations)

    @property
    def expectation(self) -> str:
        """What the runs are expected to decide, in a sentence."""
        runs = "this run" if len(self.runs) == 1 else f"these {len(self.runs)} runs"
        least = min(self.separations, key=lambda s: s.chi2)
        strong = CRITERIA.evidence.very_strong
        if self.decides and self.tests:
            says = f"{runs} should test {self._tested}"
        elif self.decides:
            says = f"{runs} should decide between {listed(_named(models) for models in self.explanations)}"
        else:
            close = [f"{s.first} and {s.second}" for s in self.separations if not s.decides]
            says = f"{runs} will not decide between {listed(close)}: measure another signal, or widen the limits"
        return (
            f"{says[0].upper()}{says[1:]}: whichever is right, the others are expected to leave a chi-square that "
            f"is at least {least.chi2:.3g} larger after they are fitted again ({strong:g} is very strong evidence"
            f"{self._beside}); the pair with the smallest separation is {least.first} and {least.second}."
        )

    @property
    def _left(self) -> str:
        if self.tests:
            return "a run that would test this verdict"
        return f"{len(self.explanations)} explanations are left"

    @property
    def _tested(self) -> str:
        (tested_models, *alternatives) = self.explanations
        strength = _STRENGTH if tested_models == (NO_EFFECT,) else ""
        return f"{_named(tested_models)} against {listed(_named(models) for models in alternatives)}{strength}"

    @property
    def _beside(self) -> str:
        chance = sum(run.at_random for run in self.runs)
        return (
            f"; courses drawn at random bring {chance:.3g} in the median"
            if chance == chance
            else ""
        )

    def frame_columns(self) -> Columns:
        """A row for each point of each run, numbered from 1."""
        tables = [run.table for run in self.runs]
        numbers = np.repeat(range(1, len(tables) + 1), [len(table["time"]) for table in tables])
        return {"run": (numbers, "")} | {
            name: (np.concatenate([table[name] for table in tables]), self.units.get(name, "s"))
            for name in tables[0]
        }

    def __str__(self) -> str:
        lines = [
            f"{self.title}: the verdict is {self.verdict}; {self._left}",
            *look_first(self.warnings),
            self.expectation,
        ]
        lines += [
            f"  {s.first} against {s.second}: chi-square {s.chi2:.3g}" for s in self.separations
        ]
        for number, run in enumerate(self.runs, 1):
            lines.append(
                f"run {number}: {run.table['time'][-1]:.4g} s{_settings(run.parameters, self.units)}"
            )
        return "\n".join(lines)


def _named(models: Sequence[str]) -> str:
    """The best law of an explanation, and the others that fit as well."""
    best, *equivalent_laws = models
    return f"{best} (or {', '.join(equivalent_laws)})" if equivalent_laws else best


def _settings(parameters: Mapping[str, float], units: Mapping[str, str]) -> str:
    values = [
        f"{name} = {format_quantity(value, units.get(name, ''), 4)}"
        for name, value in parameters.items()
    ]
    return f", with {listed(values)}" if values else ""
