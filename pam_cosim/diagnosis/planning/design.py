"""The search for the course that separates rivals most."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import warnings_of
from pam_cosim.diagnosis.diagnose import Diagnosis
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.events import Remark
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.planning.challengers import challenged
from pam_cosim.diagnosis.planning.course import Course
from pam_cosim.diagnosis.planning.limits import Limits, limits_of
from pam_cosim.diagnosis.planning.members import members
from pam_cosim.diagnosis.planning.moves import Moves, Random
from pam_cosim.diagnosis.planning.rivals import Rivals, soft_minimum
from pam_cosim.diagnosis.planning.run_plan import NO_EFFECT, PlannedRun, RunPlan, Separation
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.measurement import Run
from pam_cosim.processes.workers import on_one_thread

_DRAWN_COURSES = 40  # courses at random within the limits of a rig
_IMPROVED_COURSES = 80  # courses derived from the best ones
_PARENTS = 6  # best courses, from which others are derived
_EQUIVALENT_SHARE = (
    0.8  # of the chi-square of the best course, from which on a simpler one is preferred
)


@on_one_thread
def plan(
    diagnosis: Diagnosis,
    limits: Limits | None = None,
    *,
    runs: int = 1,
    files: Sequence[Path] = (),
    seed: int = 0,
    say: Callable[[Message], None] = lambda message: None,
) -> RunPlan:
    """Designs the runs that separate the models which a diagnosis leaves, or that test the one which it names.

    Courses are drawn at random and taken from the recordings, and the best of them are changed and joined. What counts
    is the chi-square that is expected between two rivals, of which the wrong one was fitted again, for the pair that
    is least apart. Of several runs each is designed to add to those before it.

    Where a verdict leaves no choice the run is one that would refute it: ``identified`` is tested against the models of
    other families that came nearest, ``none_missing`` against effects as weak as the recordings just show them, those
    that must be strongest for that.

    Args:
        diagnosis: with any verdict.
        limits: within which the rig can be driven; None: what the recordings span.
        runs: how many to design.
        files: further Modelica files, as for the diagnosis.
        seed: of the random numbers.
        say: predictions what happens, line by line.

    Raises:
        InputError: no other model is known, or within the limits nothing can be chosen.
        SimulationFailure: no course could be simulated.
    """
    if runs < 1:
        raise InputError("plan one run at least")
    limits = limits_of(diagnosis.data) if limits is None else limits
    if limits.is_fixed:
        raise InputError(
            "no input and no parameter differs in the recordings: state limits within which they may"
        )
    remaining_models = members(diagnosis)
    explanations = remaining_models if len(remaining_models) > 1 else challenged(diagnosis, files)
    if len(explanations) < 2:
        raise InputError(
            f"the verdict is {diagnosis.verdict.kind}: there are no rivals to decide between"
        )
    tests = len(remaining_models) < 2
    recorded = [run for run in diagnosis.data.runs if not run.is_static]
    moves, rng = Moves(limits, recorded), np.random.default_rng(seed)
    with Rivals(explanations, diagnosis.data, limits, files, tests_first=tests) as rivals:
        names = tuple(_name(model) for model in rivals.models)
        say(Remark(f"looking for the run that separates {', '.join(names)}").message)
        search = _Search(rivals, moves, rng)
        planned: list[PlannedRun] = []
        for _ in range(runs):
            planned.append(search.best(names))
        variables = {**rivals.interface.inputs, **rivals.interface.parameters}
        units = {n: variables[n].unit for n in (*limits.inputs, *limits.parameters)}
        sigma = dict(rivals.sigma)
    return RunPlan(
        diagnosis.data.title,
        diagnosis.model,
        diagnosis.verdict.kind,
        names,
        tuple(tuple(_name(model) for model in models) for models in explanations),
        tuple(dict.fromkeys(_families(diagnosis, names))),
        tuple(planned),
        units | {n: diagnosis.data.signals[n].unit for n in sigma},
        sigma,
        search.tried,
        warnings_of(diagnosis.final.comparison.runs),
    )


def _name(model: Candidate) -> str:
    return " + ".join(model.effects) or NO_EFFECT


def _families(diagnosis: Diagnosis, names: Sequence[str]) -> list[str]:
    family_of = {c.effect: c.family for c in diagnosis.candidates}
    return [family_of.get(effect, "") for name in names for effect in name.split(" + ")]


@dataclass
class _Search:
    """The state of a search: what the runs that were planned already say, and how many courses were simulated."""

    rivals: Rivals
    moves: Moves
    rng: Random
    information: Array | float = 0.0
    tried: int = 0

    def best(self, names: Sequence[str]) -> PlannedRun:
        """The next run to make."""
        drawn = [self._scored(self.moves.drawn(self.rng)) for _ in range(_DRAWN_COURSES)]
        scored = [*drawn, *(self._scored(variation) for variation in self.moves.recorded())]
        usable = [entry for entry in scored if entry is not None]
        if not usable:
            raise SimulationFailure(
                "no input trajectory within the limits can be simulated with every remaining model"
            )
        for _ in range(_IMPROVED_COURSES):
            usable.sort(key=lambda entry: -entry[0])
            child = self._scored(self._child([course for _, course in usable[:_PARENTS]]))
            usable += [child] if child is not None else []
        # what counts of a run is what it adds to those before it
        base = soft_minimum(self._total(np.zeros(len(self.rivals.pairs))))
        most = max(score for score, _ in usable) - base
        nearly = [entry for entry in usable if entry[0] - base >= _EQUIVALENT_SHARE * most]
        course = min(nearly, key=lambda entry: (entry[1].complexity, -entry[0]))[1]
        chances = [entry[0] for entry in drawn if entry is not None]
        return self._planned(
            course, names, float(np.median(chances)) - base if chances else float("nan")
        )

    def _child(self, parents: Sequence[Course]) -> Course:
        child = parents[int(self.rng.integers(len(parents)))]
        if len(parents) > 1 and self.rng.integers(3) == 0:
            child = self.moves.joined(
                self.rng, child, parents[int(self.rng.integers(len(parents)))]
            )
        return self.moves.changed(self.rng, child)

    def _scored(self, course: Course) -> tuple[float, Course] | None:
        self.tried += 1
        separations = self.rivals.thinned(course)
        return None if separations is None else (soft_minimum(self._total(separations)), course)

    def _total(self, separations: Array) -> Array:
        return np.asarray(separations + self.information)

    def _planned(self, course: Course, names: Sequence[str], at_random: float) -> PlannedRun:
        run = self.rivals.run_of(course)
        predictions = self.rivals.predictions(run)
        if predictions is None:
            raise SimulationFailure(
                "the best input trajectory could be simulated with few samples, but not with all samples"
            )
        separations = self.rivals.separations(predictions)
        self.information = self._total(separations)
        rows = len(run.time)
        predicted = {
            name: {
                signal: prediction.values[i * rows : (i + 1) * rows]
                for i, signal in enumerate(self.rivals.sigma)
            }
            for name, prediction in zip(names, predictions, strict=True)
        }
        pairs = [
            Separation(names[i], names[j], float(chi2))
            for (i, j), chi2 in zip(self.rivals.pairs, separations, strict=True)
        ]
        parameters = dict(course.parameters)
        return PlannedRun(parameters, _table(run), tuple(pairs), at_random, run.time, predicted)


def _table(run: Run) -> dict[str, list[float]]:
    """The inputs where any of them bends, and the ends."""
    columns = np.column_stack([np.zeros(len(run.time)), *run.inputs.values()])
    step = np.diff(run.time)[:, None]
    jump = step == 0
    slope = np.divide(
        np.diff(columns, axis=0), step, out=np.full_like(columns[1:], np.inf), where=~jump
    )
    is_needed = np.ones(len(run.time), dtype=bool)
    bends = ~np.isclose(slope[1:], slope[:-1], rtol=1e-6, atol=1e-12).all(axis=1)
    is_needed[1:-1] = bends | jump[1:, 0] | jump[:-1, 0]
    return {
        "time": run.time[is_needed].tolist(),
        **{n: v[is_needed].tolist() for n, v in run.inputs.items()},
    }
