"""What a model lacks, what data could show, and pictures of what came of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from pam_cosim.counts import checked_simulations, checked_workers
from pam_cosim.diagnosis import Check, Diagnosis, Listener, Message
from pam_cosim.diagnosis import check as _check
from pam_cosim.diagnosis import diagnose as _diagnose
from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet
from pam_cosim.model.settings import Setting
from pam_cosim.problems import Problem
from pam_cosim.processes.workers import working_on
from pam_cosim.simulation.models import Paths
from pam_cosim.study.problems import as_problem
from pam_cosim.study.products import Product
from pam_cosim.study.runs import _seconds
from pam_cosim.sweeps import Sweep


def diagnose(
    data: DataSet | Problem,
    model: str | None = None,
    *,
    files: Paths = (),
    say: Callable[[Message], None] = lambda message: None,
    progress: Listener | None = None,
    workers: int | None = None,
    executor: Any = None,
    explain: bool = True,
    time_limit: Setting | None = None,
    simulation_limit: int | None = None,
    exclude: Sequence[str] = (),
    expect: Sequence[str] = (),
    free: Sequence[str] | None = None,
    start: Mapping[str, Setting] | None = None,
    parameters: Mapping[str, Setting] | None = None,
) -> Diagnosis:
    """Finds the effect that a model lacks.

    Args:
        data: the measurement, or a problem, as for ``fit``.
        model: default: the bench of the data set.
        files: further Modelica files.
        say: called with each step and each result as a line of text that has its kind; ``print`` will do.
        progress: called with the same steps as data, and with the verdict and the ledger: ``diagnosis.Event`` objects.
        workers: number of processes; 0: this process alone; default: by the number of cores.
        executor: fits the models elsewhere, as for ``sweep``. A process of it needs this package, the files at the
            same paths, and one thread.
        explain: whether the ledger, and a formula for an unexplained residual, are computed as well.
        time_limit: [s], or with a unit. Ends the search with the best verdict so far, which lists what was not tried.
        simulation_limit: number of simulated runs, which ends the search with the same verdict on every machine.
        exclude: families or effects that are known not to be missing, in addition to those of the data set.
        expect: families or effects that are likely to be missing, in addition to those of the data set.
        free: names of what is fitted, as for ``fit``.
        start: initial guesses, as for ``fit``.
        parameters: further values, as for ``fit``.

    Raises:
        InputError: an unknown model, parameter, family or effect; a limit that is not above zero.
        SimulationFailure: the base model, or every model with an effect, cannot be simulated.
    """
    limit = _seconds(time_limit, "time limit")
    if limit is not None and not limit > 0:
        raise InputError(f"the time limit must be above zero: {time_limit}")
    problem = as_problem(data, model, files, values=parameters, free=free, start=start)
    with working_on(executor):
        return _diagnose(
            problem.data,
            problem.model,
            files=problem.files,
            say=say,
            progress=progress,
            workers=checked_workers(workers),
            explain=explain,
            time_limit=limit,
            simulation_limit=checked_simulations(simulation_limit),
            exclude=tuple(exclude),
            expect=tuple(expect),
        )


def check(
    data: DataSet | Problem,
    model: str | None = None,
    *,
    parameters: Mapping[str, Setting] | None = None,
    free: Sequence[str] | None = None,
    files: Paths = (),
    say: Callable[[Message], None] = lambda message: None,
    progress: Listener | None = None,
    workers: int | None = None,
) -> Check:
    """Predicts before any fit what a measurement determines of a model.

    The result has the deviations of the free parameters, the families of effects that are detectable and their
    smallest strength, the families that cannot be separated, and the further signal or run that would help most.

    Args:
        data: the measurement, or a problem, as for ``fit``.
        model: default: the bench of the data set.
        parameters: further values, as for ``fit``.
        free: names of what is fitted, as for ``fit``.
        files: further Modelica files.
        say: called with each step as a line of text.
        progress: called with the same steps as data.
        workers: number of processes; 0: this process alone; default: by the number of cores.

    Raises:
        InputError: an unknown model or parameter.
        SimulationFailure: the model cannot be simulated at its start values.
    """
    problem = as_problem(data, model, files, values=parameters, free=free)
    return _check(
        problem.data,
        problem.model,
        files=problem.files,
        say=say,
        progress=progress,
        workers=checked_workers(workers),
    )


def draw(product: Product | Sweep, path: Path | str, width: str | float | None = None) -> None:
    """Draws a product of a study: its signals over time, its ledger, or the error coming down.

    Args:
        product: of a study.
        path: ends in .png, .svg or .pdf.
        width: of the picture, such as "88 mm", the column of a journal [m]; default: that of a page.

    Raises:
        InputError: there is nothing to draw, no such width, or the file cannot be written.
    """
    from pam_cosim.reporting import (
        draw as _draw,
    )  # half a second for matplotlib, which no worker needs

    _draw(product, path, width)


def live() -> Callable[[Any], None]:
    """A receiver of progress: ``pam.fit(data, progress=pam.live())``, and so for ``diagnose``.

    In a notebook it draws how things stand: the errors of a fit, the ranking and the verdict of a diagnosis. Elsewhere
    it prints every line.
    """
    from pam_cosim.reporting import Live

    return Live()
