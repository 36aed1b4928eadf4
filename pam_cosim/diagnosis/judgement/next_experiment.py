"""Which further run would tell rivals apart."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

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


class Variation(NamedTuple):
    """A recorded run with changes that an experimenter can make.

    Attributes:
        original: the run.
        factors: on inputs and parameters, by name, and on all times (``PACE``).
    """

    original: Run
    factors: Mapping[str, float]

    @property
    def run(self) -> Run:
        """The changed run."""
        run, factors = self.original, self.factors
        time = run.time
        if PACE in factors:
            time = time[0] + (time - time[0]) * factors[PACE]
        inputs = {n: v * factors.get(n, 1.0) for n, v in run.inputs.items()}
        parameters = {n: v * factors.get(n, 1.0) for n, v in run.parameters.items()}
        return replace(run, time=time, inputs=inputs, parameters=parameters)

    @property
    def change(self) -> str:
        """The changes in words."""
        pace = "slower" if self.factors.get(PACE, 0.0) > 1 else "faster"
        changes = [
            f"{pace}: all times multiplied by {factor:g}"
            if name == PACE
            else f"{name} times {factor:g}"
            for name, factor in self.factors.items()
        ]
        return " and ".join(changes) or "repeat it as it is"


PACE = ""
"""The name of the factor on all times."""


def variations(
    data: DataSet,
    runs: Sequence[Run] | None = None,
    factors: Sequence[float] = FACTORS,
) -> Iterator[Variation]:
    """Runs as they are, and with one thing changed that an experimenter sets.

    Args:
        data: the measurement: parameters that differ between its runs can be set.
        runs: which to vary; default all.
        factors: on each input and parameter.
    """
    for run in data.runs if runs is None else runs:
        names = [n for n, values in run.inputs.items() if np.any(values != 0) and n != BRANCH]
        names += [name for name in _varied(data) if name in run.parameters]
        yield Variation(run, {})
        yield from (Variation(run, {name: factor}) for factor in factors for name in names)
        if run.inputs and not run.is_static:
            yield from (Variation(run, {PACE: pace}) for pace in _PACES)


def _varied(data: DataSet) -> list[str]:
    """Parameters that differ between runs: the experimenter can set them."""
    names = dict.fromkeys(name for run in data.runs for name in run.parameters)
    return [n for n in names if len({run.parameters.get(n) for run in data.runs}) > 1]


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
        scored = _scored(first, second, variations(data))
        scored += _scored(first, second, _combined(scored))
        if not scored:
            return None
        evidence, best = max(scored, key=lambda entry: entry[0])
        samples = len(first.sigma) * len(best.original.time)
        variables = first.interface.inputs | first.interface.parameters
    run, varied = best.run, _varied(data)
    return NextExperiment(
        run=run.name,
        change=best.change,
        separation=float(np.sqrt(evidence / samples)),
        evidence=evidence,
        between=(a.family, b.family),
        parameters={name: run.parameters[name] for name in varied if name in run.parameters},
        interpolation=run.interpolation,
        table=_table(run),
        units={name: variables[name].unit for name in (*run.inputs, *varied)},
    )


def _scored(
    a: Hypothesis, b: Hypothesis, variations: Iterable[Variation]
) -> list[tuple[float, Variation]]:
    """Variations that both models can simulate, with the evidence that either would give."""
    scored = []
    for variation in variations:
        with suppress(SimulationFailure):
            prediction_of_a, prediction_of_b = (model.predict(variation.run) for model in (a, b))
            evidence = min(
                b.refitted_miss(prediction_of_a, prediction_of_b),
                a.refitted_miss(prediction_of_b, prediction_of_a),
            )
            scored.append((evidence, variation))
    return scored


def _combined(scored: Sequence[tuple[float, Variation]]) -> list[Variation]:
    """The two best changes of the best run in one."""
    ordered = [v for _, v in sorted(scored, key=lambda entry: -entry[0])]
    best = [v for v in ordered if v.original is ordered[0].original]
    return [
        Variation(variation.original, {**other_variation.factors, **variation.factors})
        for i, variation in enumerate(best[:_MOST_JOINED])
        for other_variation in best[:i]
        if variation.factors
        and other_variation.factors
        and not variation.factors.keys() & other_variation.factors.keys()
    ]


def distinguishable_rivals(
    data: DataSet, best: Candidate, rivals: Sequence[Candidate], files: Sequence[Path] = ()
) -> list[RivalPlan]:
    """The rivals that an experiment could distinguish from ``best``, each with that experiment.

    A rival with more parameters that no variation of a run distinguishes is practically equivalent to ``best``, such as
    creep so slow that it is a spring, and is dropped: the simpler model represents both.
    """
    plans = [(rival, next_experiment(data, best, rival, files)) for rival in rivals]
    parameters = len(best.effect_parameters)
    return [
        (c, plan)
        for c, plan in plans
        if plan is None or plan.decides or len(c.effect_parameters) <= parameters
    ]


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
