"""Free parameters fitted to measurements, and how well these determine them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from pam_cosim.counts import checked_starts
from pam_cosim.errors import InputError
from pam_cosim.fitting import Fit, FitOptions, Profiles, Progress
from pam_cosim.fitting import fit as _fit
from pam_cosim.fitting import profile as _profile
from pam_cosim.measurement import DataSet
from pam_cosim.model.settings import Setting
from pam_cosim.problems import Problem
from pam_cosim.simulation.models import Paths, opened
from pam_cosim.study.problems import as_problem, data_with_starts
from pam_cosim.wording import listed


def fit(
    data: DataSet | Problem,
    model: str | None = None,
    *,
    method: str = "least-squares",
    starts: int = 0,
    free: Sequence[str] | None = None,
    start: Mapping[str, Setting] | None = None,
    parameters: Mapping[str, Setting] | None = None,
    files: Paths = (),
    progress: Progress | None = None,
    timeout: float | None = None,
    resume: Path | str | None = None,
) -> Fit:
    """Fits what the data set leaves free.

    Args:
        data: the measurement, or a problem with its model, files, values and free parameters.
        model: default: the bench of the data set.
        method: "least-squares" from the start values; "multi-start": also from points spread over the bounds;
            "differential-evolution": from the best point of that search; "particle-swarm": from the best particle of a
            swarm over the bounds (Dzahir and Yamamoto 2019). ``Fit.search`` keeps what such a search found by itself.
        starts: points spread over the bounds that "multi-start" follows, each to its end; default: a few of 16.
        free: names of what is fitted, as for ``problem``.
        start: initial guesses, as for ``problem``.
        parameters: further values, as ``values`` of ``problem``; they count before those that the data set states.
        files: further Modelica files.
        progress: called after each simulation with the ``FitProgress``, which prints itself: ``print`` will do.
        timeout: as in ``simulate``.
        resume: a file that keeps every simulation. The same call continues where the last one was interrupted
            and ends as it would have; the file is made where it is not there.

    Raises:
        InputError: unknown model, parameter or method; nothing to fit; ``resume`` is of another model.
        SimulationFailure: no start value can be simulated.
    """
    if starts and method != "multi-start":
        raise InputError(f"starts are for the method multi-start, not for {method}")
    checked_starts(starts)
    problem = as_problem(data, model, files, values=parameters, free=free, start=start)
    started = data_with_starts(problem, timeout)
    if not problem.free:
        advice = (
            f"the caller states {listed(problem.stated)}; leave a free parameter out of that"
            if problem.stated
            else "name the free parameters under [fit], or by --free"
        )
        raise InputError(f"nothing to fit: {advice}", started.folder / "experiment.toml")
    options = FitOptions(method, starts=starts)
    names = started.differentiated
    with opened(problem.model, problem.files, names, timeout) as simulator:
        return _fit(
            simulator,
            started,
            fixed=problem.settings,
            options=options,
            progress=progress,
            resume=Path(resume) if resume is not None else None,
        )


def profile(
    data: DataSet | Problem,
    fit: Fit,
    model: str | None = None,
    *,
    files: Paths = (),
    progress: Progress | None = None,
    timeout: float | None = None,
) -> Profiles:
    """How well the data determine each parameter of a fit: its profile likelihood, with a sentence for each.

    Args:
        data: what was fitted to; what the fit freed, held and began with counts.
        fit: what ``fit`` returned.
        model: as for ``fit``.
        files: as for ``fit``.
        progress: as for ``fit``.
        timeout: as for ``fit``.

    Raises:
        InputError: as ``fit``.
    """
    problem = as_problem(data, model, files)
    fitted = fit.comparison.data
    pairs = zip(problem.data.runs, fitted.runs, strict=False)
    differs = any(run_a.parameters != run_b.parameters for run_a, run_b in pairs)
    if isinstance(data, Problem) and (differs or {*problem.data.fit} != {*fit.parameters}):
        raise InputError("the fit is of another problem: fit this one by pam.fit(problem)")
    names = fitted.differentiated
    with opened(problem.model, problem.files, names, timeout) as simulator:
        return _profile(simulator, fitted, fit, fixed=fit.comparison.parameters, progress=progress)
