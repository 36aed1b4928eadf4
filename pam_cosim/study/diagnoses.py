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
    """Finds the effect that ``model`` (default: the bench of the data set) lacks; see ``diagnosis.diagnose``.

    ``say`` is told each step and each result as a line of text (``print`` will do) that knows which of them it is;
    ``progress`` is told the same as data, and the verdict and the ledger as they come: a ``diagnosis.Event`` each.
    ``time_limit`` ([s], or with a unit) ends the search with the best verdict so far, which says what was not tried;
    so does ``simulation_limit``, a number of simulated runs, with the same verdict however quick the machine is.
    ``exclude`` and ``expect`` name families or effects that are known not to be missing, or that are likely, with those
    of the data set. ``executor`` fits the models elsewhere, as that of ``sweep`` makes runs; a process of it needs this
    package, the files at the same paths, and one thread. ``data``, ``free``, ``start`` and ``parameters`` are as for
    ``fit``.
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
    """What ``data`` can and cannot tell about ``model`` (default: its bench) before any fit; see ``diagnosis.check``.

    How exactly the free parameters will be known, which families of effects would show and from which strength on,
    which of them would not be told apart, and which further signal or run would help most. ``parameters`` and ``free``
    are as for ``fit``.
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
    """Something to be told what goes on: ``pam.fit(data, progress=pam.live())``, and so for ``diagnose``.

    In a notebook it draws how things stand: the errors of a fit, the ranking and the verdict of a diagnosis. Elsewhere
    it prints every line.
    """
    from pam_cosim.reporting import Live

    return Live()
