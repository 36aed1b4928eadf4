"""Which further run would tell rivals apart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.comparison import simulate_run
from pam_cosim.diagnosis.candidate import Candidate
from pam_cosim.diagnosis.evidence import SIGNIFICANT
from pam_cosim.errors import SimulationFailure
from pam_cosim.fmu import build_source
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import Simulator

Plan = tuple[Candidate, dict[str, object] | None]

_FACTORS = (0.5, 0.75, 1.25, 1.5)


def next_experiment(
    data: DataSet, a: Candidate, b: Candidate, files: Sequence[object] = ()
) -> dict[str, object] | None:
    """Searches variations of the runs at hand for the one in which two fitted rivals differ most.

    Each input of each run, and each parameter that differs between runs, is scaled by a few factors. The rivals
    keep their fitted parameters, so the separation is an upper estimate of what a refit would leave.

    Returns:
        ``run`` to repeat, the ``change`` to make, the expected ``separation`` in noise standard deviations (root
        mean square over all samples) and the ``evidence``, the sum of its squares; None when no variation can be
        simulated.
    """
    assert a.fit is not None and b.fit is not None
    fmus = [build_source(c.equations.split()[1], c.equations, tuple(files)) for c in (a, b)]  # type: ignore[arg-type]
    best: dict[str, object] | None = None
    most = -1.0
    with Simulator(fmus[0]) as first, Simulator(fmus[1]) as second:
        for run, change in _variations(data):
            try:
                one = simulate_run(first, data, run, a.fit.values)
                two = simulate_run(second, data, run, b.fit.values)
            except SimulationFailure:
                continue
            squares = [
                ((one.model[s] - two.model[s]) / signal.sigma) ** 2
                for s, signal in data.signals.items()
                if signal.fitted and signal.sigma
            ]
            separation = float(np.sqrt(np.mean(squares)))
            if separation > most:
                most = separation
                best = {"run": run.name, "change": change, "separation": separation, "evidence": float(np.sum(squares))}
    return None if best is None else {**best, "between": [a.family, b.family]}


def told_apart(data: DataSet, best: Candidate, rivals: Sequence[Candidate], files: Sequence[object] = ()) -> list[Plan]:
    """The rivals that mean something else than ``best``, each with the experiment that would decide.

    A rival with more parameters that predicts the same in every experiment at hand is ``best`` in another dress,
    such as creep so slow that it is a spring: the simpler one stands for both.
    """
    plans = [(rival, next_experiment(data, best, rival, files)) for rival in rivals]
    return [(c, plan) for c, plan in plans if not (plan and _same(best, c, plan))]


def _same(best: Candidate, rival: Candidate, plan: dict[str, object]) -> bool:
    richer = len(rival.own_parameters) > len(best.own_parameters)
    evidence = plan["evidence"]
    return richer and isinstance(evidence, float) and evidence < SIGNIFICANT


def _variations(data: DataSet) -> list[tuple[Run, str]]:
    found = []
    varied = [n for n in data.runs[0].parameters if len({r.parameters.get(n) for r in data.runs}) > 1]
    for run in data.runs:
        found.append((run, "repeat it as it is"))
        for factor in _FACTORS:
            for name, values in run.inputs.items():
                if np.any(values != 0):
                    changed = replace(run, inputs={**run.inputs, name: values * factor})
                    found.append((changed, f"{name} times {factor:g}"))
            for name in varied:
                if name in run.parameters:
                    changed = replace(run, parameters={**run.parameters, name: run.parameters[name] * factor})
                    found.append((changed, f"{name} times {factor:g}"))
    return found
