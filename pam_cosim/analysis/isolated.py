"""Work on an FMU for model exchange: in this process, or in one of its own where the FMU is not trusted."""

from __future__ import annotations

import contextlib
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any, Concatenate, ParamSpec, TypeVar

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.errors import InputError
from pam_cosim.processes import watchdog
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.fmu_process import cause_of_end, start_watched
from pam_cosim.simulation.isolated import TIME_LIMIT

P = ParamSpec("P")
R = TypeVar("R")


def work_on(
    path: Path,
    trusted: bool,
    timeout: float | None,
    job: Callable[Concatenate[ExchangeModel, P], R],
    *arguments: P.args,
    **named: P.kwargs,
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
    limit = TIME_LIMIT if timeout is None else timeout
    if not limit > 0:
        raise InputError(f"a time limit must be larger than zero, not {limit:g} s")
    if trusted:
        with ExchangeModel(path) as model:
            return job(model, *arguments, **named)
    kind, content = _asked(path, limit, pickle.dumps((job, arguments, named)))
    if kind == watchdog.LATE:
        raise RunFailure(
            f"{path.name} was ended: no progress for {limit:g} s; a longer time limit may help"
        )
    if kind == watchdog.CRASHED:
        raise RunFailure(f"{path.name} crashed its process ({cause_of_end(int(content))})")
    done, answer = pickle.loads(content)
    if not done:
        raise answer
    result: R = answer
    return result


def _asked(path: Path, limit: float, request: bytes) -> tuple[bytes, Any]:
    process = start_watched(path, limit, "pam_cosim.analysis.worker")
    assert process.stdin is not None and process.stdout is not None
    try:
        with contextlib.suppress(OSError):  # it has ended: the answer says why
            watchdog.write_frame(process.stdin, watchdog.REQUEST, request)
        answer = watchdog.read_frame(process.stdout)
        with contextlib.suppress(OSError):
            watchdog.write_frame(process.stdin, watchdog.CLOSE)
        return answer
    except EOFError:
        raise RunFailure(f"the process that watches {path.name} has ended") from None
    finally:
        with contextlib.suppress(OSError):
            process.stdin.close()
        process.stdout.close()
        process.wait()
