"""A model against measurements, without fitting anything."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial

from pam_cosim.comparison import Comparison, likely_convention, simulate_runs
from pam_cosim.comparison import compare as _compare
from pam_cosim.fitting import estimated_starts, runs_without_start
from pam_cosim.measurement import DataSet
from pam_cosim.model.references import START_VALUES
from pam_cosim.model.settings import Setting
from pam_cosim.problems import Problem
from pam_cosim.simulation.models import Paths, opened
from pam_cosim.study.problems import as_problem, data_with_starts, few_rows


def compare(
    data: DataSet | Problem,
    model: str | None = None,
    parameters: Mapping[str, Setting] | None = None,
    *,
    files: Paths = (),
    timeout: float | None = None,
) -> Comparison:
    """Simulates every run of ``data`` with ``model`` (default: its bench) and scores the differences.

    Args:
        data: the measurement, or a problem with its model, files and values.
        model: default: the bench of the data set.
        parameters: further values, as ``values`` of ``problem``; they count before those that the data set states.
        files: further Modelica files.
        timeout: as in ``simulate``.

    Raises:
        InputError: as ``problem``.
        SimulationFailure: a run did not reach its end.
    """
    return compared(as_problem(data, model, files, values=parameters), timeout)


def compared(
    problem: Problem, timeout: float | None = None, *, with_conventions: bool = True
) -> Comparison:
    """The comparison of a problem; ``with_conventions``: also with other conventions of its recordings."""
    started = data_with_starts(problem, timeout)
    starts, brief = [START_VALUES] * started.estimates_starts, few_rows(started)
    with opened(problem.model, problem.files, starts, timeout, brief=brief) as simulator:
        open_runs = runs_without_start(started, problem.settings, problem.interface)
        estimated = estimated_starts(simulator, started, open_runs, problem.settings)
        values = problem.settings | {name: e.value for name, e in estimated.items()}
        result = _compare(simulator, started, values)
        if not with_conventions:
            return result

        simulate = partial(simulate_runs, simulator, values=values)
        convention = likely_convention(started, result.units, simulate, result.runs)
        return replace(result, convention=convention.text if convention else "")
