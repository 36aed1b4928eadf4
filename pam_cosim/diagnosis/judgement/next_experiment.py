"""Which further run would tell rivals apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.prediction import Hypothesis
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, Run
from pam_cosim.model.references import BRANCH
from pam_cosim.simulation.inputs import Interpolation

FACTORS = (0.5, 0.75, 1.25, 1.5)  # on inputs and loads, within reach of most rigs
_PACES = (0.5, 2.0)  # factors on all times
_MOST_JOINED = 3  # best changes of a run, two of which are combined


@dataclass(frozen=True)
class NextExperiment:
    """The run that would tell two rivals apart.

    Attributes:
        run: name of the run to repeat.
        change: what to change.
        separation: what is expected between the rivals, root mean square over all samples in noise standard deviations.
        evidence: the sum of its squares.
        between: families of the rivals.
        parameters: what to set [SI].
        interpolation: of the inputs between the points of the table, as in a data set.
        table: inputs [SI] over time [s], as columns, at the points between which they are straight or held; of points
            at rest, without time.
        units: by name of an input or parameter.
    """

    run: str
    change: str
    separation: float
    evidence: float
    between: tuple[str, str]
    parameters: dict[str, float]
    interpolation: Interpolation
    table: dict[str, list[float]]
    units: dict[str, str]

    @property
    def decides(self) -> bool:
        """Whether the run is expected to be very strong evidence for one of the rivals."""
        return self.evidence >= CRITERIA.evidence.very_strong


RivalPlan = tuple[Candidate, NextExperiment | None]


def next_experiment(
    data: DataSet, a: Candidate, b: Candidate, files: Sequence[Path] = ()
) -> NextExperiment | None:
    """Searches variations of the runs at hand for the one that tells two fitted rivals apart best.

    Each input of each run, and each parameter that differs between runs, is scaled by a few factors; whole runs are
    made faster and slower; and the two best changes of one run are made together. Whichever rival is right, the
    other would be fitted again with the new run among its data: what counts is what it then still misses. None when
    no variation can be simulated.
    """
    with Hypothesis(a, data, files) as first, Hypothesis(b, data, files) as second:
        scored = [
            (_separation(first, second, run), run, change) for run, change in variations(data)
        ]
        scored += [
            (_separation(first, second, run), run, change)
            for run, change in _combined_changes(scored)
        ]
        usable = [
            (evidence, run, change) for evidence, run, change in scored if evidence is not None
        ]
        if not usable:
            return None
        evidence, run, change = max(usable, key=lambda entry: entry[0])
        samples = len(first.sigma) * len(run.time)
        variables = first.interface.inputs | first.interface.parameters
    varied = _varied(data)
    return NextExperiment(
        run=run.name,
        change=change,
        separation=float(np.sqrt(evidence / samples)),
        evidence=evidence,
        between=(a.family, b.family),
        parameters={name: run.parameters[name] for name in varied if name in run.parameters},
        interpolation=run.interpolation,
        table=_table(run),
        units={name: variables[name].unit for name in (*run.inputs, *varied)},
    )


def _separation(a: Hypothesis, b: Hypothesis, run: Run) -> float | None:
    try:
        one, two = a.predict(run), b.predict(run)
        return min(b.refitted_miss(one, two), a.refitted_miss(two, one))
    except SimulationFailure:
        return None


def distinguishable_rivals(
    data: DataSet, best: Candidate, rivals: Sequence[Candidate], files: Sequence[Path] = ()
) -> list[RivalPlan]:
    """The rivals that an experiment could distinguish from ``best``, each with that experiment.

    A rival with more parameters that no variation of a run distinguishes is practically equivalent to ``best``, such as
    creep so slow that it is a spring, and is dropped: the simpler model stands for both.
    """
    plans = [(rival, next_experiment(data, best, rival, files)) for rival in rivals]
    return [(c, plan) for c, plan in plans if not (plan and _is_same_in_practice(best, c, plan))]


def _is_same_in_practice(best: Candidate, rival: Candidate, plan: NextExperiment) -> bool:
    return len(rival.effect_parameters) > len(best.effect_parameters) and not plan.decides


def _varied(data: DataSet) -> list[str]:
    """Parameters that differ between runs: the experimenter can set them."""
    names = dict.fromkeys(name for run in data.runs for name in run.parameters)
    values = {name: {run.parameters.get(name) for run in data.runs} for name in names}
    return [name for name, different in values.items() if len(different) > 1]


def variations(
    data: DataSet,
    runs: Sequence[Run] | None = None,
    factors: Sequence[float] = FACTORS,
) -> Iterator[tuple[Run, str]]:
    """Runs as they are, and with one thing changed that an experimenter sets; what was changed, in words.

    Args:
        data: the measurement: parameters that differ between its runs can be set.
        runs: which to vary; default all.
        factors: on each input and parameter.
    """
    varied = _varied(data)
    for run in data.runs if runs is None else runs:
        yield run, "repeat it as it is"
        for factor in factors:
            yield from _scaled(run, factor, varied)
        if run.inputs and not run.is_static:
            for pace in _PACES:
                time = run.time[0] + (run.time - run.time[0]) * pace
                yield (
                    replace(run, time=time),
                    f"{'slower' if pace > 1 else 'faster'}, all times times {pace:g}",
                )


def _scaled(run: Run, factor: float, parameters: Sequence[str]) -> Iterator[tuple[Run, str]]:
    """A run with one of its inputs, or of these parameters, times a factor."""
    for name, values in run.inputs.items():
        if np.any(values != 0) and name != BRANCH:
            yield (
                replace(run, inputs={**run.inputs, name: values * factor}),
                f"{name} times {factor:g}",
            )
    for name in parameters:
        if name in run.parameters:
            value = run.parameters[name] * factor
            yield (
                replace(run, parameters={**run.parameters, name: value}),
                f"{name} times {factor:g}",
            )


def _combined_changes(scored: Sequence[tuple[float | None, Run, str]]) -> Iterator[tuple[Run, str]]:
    """The two best changes of the best run in one."""
    usable = [(evidence, run, change) for evidence, run, change in scored if evidence is not None]
    if not usable:
        return
    usable.sort(key=lambda entry: -entry[0])
    name = usable[0][1].name
    best = [(run, change) for _, run, change in usable if run.name == name][:_MOST_JOINED]
    original = next(run for _, run, _ in scored if run.name == name)
    for i, (one, change) in enumerate(best):
        for two, other in best[:i]:
            if _changed_thing(change) != _changed_thing(other):
                yield _combined_run(original, one, two), f"{other} and {change}"


def _changed_thing(change: str) -> str:
    """What a change is of: an input, a parameter, or the pace."""
    return change.split(" times ")[0]


def _combined_run(original: Run, one: Run, two: Run) -> Run:
    """Each part from the run in which it was changed."""
    parameters = {
        n: two.parameters[n] if v == original.parameters[n] else v
        for n, v in one.parameters.items()
    }
    inputs = {
        n: two.inputs[n] if np.array_equal(v, original.inputs[n]) else v
        for n, v in one.inputs.items()
    }
    time = two.time if np.array_equal(one.time, original.time) else one.time
    return replace(original, parameters=parameters, inputs=inputs, time=time)


def _table(run: Run) -> dict[str, list[float]]:
    """The inputs where any of them bends, and the ends; of points at rest, all of them, without time."""
    if run.is_static:
        return {name: values.tolist() for name, values in run.inputs.items()}
    if not run.inputs:
        return {"time": [float(run.time[0]), float(run.time[-1])]}
    bends = np.ones(len(run.time), dtype=bool)
    if len(run.time) > 2:
        bends[1:-1] = _bends(run).any(axis=1)
    values = {name: column[bends].tolist() for name, column in run.inputs.items()}
    return {"time": run.time[bends].tolist(), **values}


def _bends(run: Run) -> NDArray[np.bool_]:
    """(n - 2, inputs) whether each input changes its value, or its slope, at each row but the first and the last."""
    columns = np.column_stack(list(run.inputs.values()))
    rise = np.diff(columns, axis=0)
    if run.interpolation == "previous":
        return np.asarray(rise[:-1] != 0)
    step = np.diff(run.time)[:, None]
    slope = np.divide(rise, step, out=np.full_like(rise, np.inf), where=step > 0)
    return np.asarray(~np.isclose(slope[1:], slope[:-1], rtol=1e-6, atol=1e-12))
