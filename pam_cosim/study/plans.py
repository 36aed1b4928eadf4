"""The runs that would decide between the models that a diagnosis leaves."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence

from pam_cosim.counts import checked_seed
from pam_cosim.diagnosis import Diagnosis, Message
from pam_cosim.diagnosis.planning import Limits, Range, RunPlan, limits_of
from pam_cosim.diagnosis.planning import plan as _plan
from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet
from pam_cosim.model.references import sources_of
from pam_cosim.model.settings import Setting, value_of
from pam_cosim.problems import Problem
from pam_cosim.simulation.models import Paths, as_paths, describe
from pam_cosim.study.diagnoses import diagnose
from pam_cosim.study.problems import check_kind
from pam_cosim.study.runs import _seconds
from pam_cosim.wording import did_you_mean


def plan(
    diagnosis: Diagnosis | Problem,
    *,
    limits: Mapping[str, Sequence[Setting]] | None = None,
    seconds: Setting | None = None,
    hold: Collection[str] = (),
    runs: int = 1,
    files: Paths = (),
    seed: int = 0,
    say: Callable[[Message], None] = lambda message: None,
) -> RunPlan:
    """Designs the run that separates the models which a verdict leaves, or that tests the verdict.

    Args:
        diagnosis: or a problem, which is diagnosed first.
        limits: the lowest and the highest value, numbers in SI or texts with a unit, by name of an input, of a
            parameter that is known before the run (a load), or of a fitted signal; the predicted signals must lie
            within the limits. Inputs without limits stay within the recorded range, and an input that is constant in
            all recordings varies only within stated limits.
        seconds: duration of a run [s], or with a unit; default: the usual duration of the recordings.
        hold: inputs that are constant during a run.
        runs: number of runs, which are designed one after another.
        files: further Modelica files.
        seed: of the random numbers.
        say: called with each step as a line of text.

    Raises:
        InputError: no other model is known; limits of something unknown or with another unit; nothing to choose.
        SimulationFailure: no run could be simulated.
    """
    if isinstance(diagnosis, Problem):
        files = (*as_paths(files), *diagnosis.files)
        run_limits(diagnosis.data, limits, seconds, files, hold)
        diagnosis = diagnose(diagnosis, say=say, explain=False)
    check_kind(diagnosis, Diagnosis, "a diagnosis is needed", "load it by pam.load(FILE.npz)")
    within = run_limits(diagnosis.data, limits, seconds, files, hold)
    sources = sources_of(as_paths(files), diagnosis.model)
    return _plan(diagnosis, within, runs=runs, files=sources, seed=checked_seed(seed), say=say)


def run_limits(
    data: DataSet,
    limits: Mapping[str, Sequence[Setting]] | None = None,
    seconds: Setting | None = None,
    files: Paths = (),
    hold: Collection[str] = (),
) -> Limits:
    """What a planned run may be made of, as ``plan`` takes it.

    Raises:
        InputError: as for ``plan``.
    """
    ranges = _ranges(data, limits or {}, as_paths(files))
    return limits_of(data, ranges, _seconds(seconds, "length of the run"), hold)


def _ranges(
    data: DataSet, limits: Mapping[str, Sequence[Setting]], files: Paths
) -> dict[str, Range]:
    if not limits:
        return {}
    interface = describe(data.model, files)
    variables = {**interface.parameters, **interface.inputs, **interface.outputs}
    ranges = {}
    for name, ends in limits.items():
        if name not in variables:
            raise InputError(
                f"{interface.model} has no '{name}' to limit; {did_you_mean(name, variables)}"
            )
        if isinstance(ends, str) or len(ends) != 2:
            raise InputError(f"'{name}': limits are two values, the lowest and the highest")
        ranges[name] = (value_of(ends[0], variables[name]), value_of(ends[1], variables[name]))
    return ranges
