"""Work on an FMU for model exchange: in this process, or in one of its own where the FMU is not trusted."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import TypeVar, TypeVarTuple

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.counts import checked_time
from pam_cosim.simulation.fmu_process import FmuProcess
from pam_cosim.simulation.isolated import TIME_LIMIT

R = TypeVar("R")
Arguments = TypeVarTuple("Arguments")


def work_on(
    path: Path,
    trusted: bool,
    timeout: float | None,
    job: Callable[[ExchangeModel, *Arguments], R],
    *arguments: *Arguments,
) -> R:
    """What ``job`` returns for the FMU.

    Args:
        path: an FMU with model exchange.
        trusted: whether it may run in this process; else it gets one of its own, which it may crash.
        timeout: [s] without a call of the FMU that returns, after which that process is ended; None: ``TIME_LIMIT``.
        job: a function of a module, which takes the model and these arguments.

    Raises:
        InputError: not such an FMU, no such limit, and what the job raises.
        SimulationFailure: the FMU crashed or hung, and what the job raises.
    """
    limit = checked_time(TIME_LIMIT if timeout is None else timeout)
    if trusted:
        with ExchangeModel(path) as model:
            return job(model, *arguments)
    with closing(FmuProcess(path, limit, "pam_cosim.analysis.exchange:ExchangeModel")) as process:
        result: R = process.answer(job, {"positional": arguments})
    return result
