"""The process in which a session fits and diagnoses: requests in; what happens, and an answer, out.

It is apart so that it can be stopped at any moment and leaves nothing behind, and so that the page stays quick.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import signal
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

from pam_cosim import study
from pam_cosim.diagnosis import Event
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fitting import FitProgress
from pam_cosim.processes.watchdog import ANSWER, PROGRESS, read_frame, write_frame
from pam_cosim.processes.workers import stop_workers
from pam_cosim.simulation import models
from pam_cosim.simulation.worker import private_input, private_output

_LOOK = 0.5  # [s] between two looks whether the server is still there
_PACE = 0.05  # [s] between two standings of a fit that are reported

Tell = Callable[[object], None]


def fit(tell: Tell, data: Any, model: str, options: dict[str, Any]) -> Any:
    """``study.fit``, telling each ``FitProgress`` but for those that come too fast to be seen, and the last."""
    sent_at, last = 0.0, None

    def progress(standing: FitProgress) -> None:
        nonlocal sent_at, last
        last = standing
        if time.monotonic() - sent_at >= _PACE:
            sent_at, last = time.monotonic(), None
            tell(standing)

    fitted = study.fit(data, model, progress=progress, **options)
    if last is not None:
        tell(last)
    return fitted


def diagnose(tell: Tell, data: Any, model: str, options: dict[str, Any]) -> Any:
    """``study.diagnose``, telling each line, and each event that no line is about."""
    return study.diagnose(data, model, say=tell, progress=_unsaid(tell), **options)


def check(tell: Tell, data: Any, model: str, options: dict[str, Any]) -> Any:
    """``study.check``, likewise."""
    return study.check(data, model, say=tell, progress=_unsaid(tell), **options)


def _unsaid(tell: Tell) -> Callable[[Event], object]:
    """Tells events that no line is about."""
    return lambda event: None if str(event) else tell(event)


def prepare(tell: Tell, data: Any, model: str, options: dict[str, Any]) -> None:
    """Builds what a fit of these data needs, and loads it once, while the person looks at the page."""
    models.opened(data.model_for(model), options["files"], data.differentiated).close()


JOBS = {"fit": fit, "diagnose": diagnose, "check": check, "prepare": prepare}


def main() -> None:
    """Serves one request after another until there are no more requests."""
    requests, channel = private_input(), private_output()
    threading.Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()

    def tell(event: object) -> None:
        write_frame(channel, PROGRESS, pickle.dumps(event))

    while True:
        try:
            _, content = read_frame(requests)
        except EOFError:
            break
        job, data, model, options = pickle.loads(content)
        answer: tuple[bool, Any]
        try:
            answer = True, JOBS[job](tell, data, model, options)
        except (InputError, SimulationFailure) as problem:
            answer = False, problem
        except Exception as defect:  # it is reported, and the process continues
            answer = False, SimulationFailure(f"{type(defect).__name__}: {defect}")
        write_frame(channel, ANSWER, pickle.dumps(answer))
    stop_workers()


def _end_with(parent: int) -> None:
    """Ends this process and all that it started when the server is gone."""
    while os.getppid() == parent:
        time.sleep(_LOOK)
    with contextlib.suppress(OSError, AttributeError):
        os.killpg(0, signal.SIGKILL)
    os._exit(1)


if __name__ == "__main__":
    with contextlib.suppress(BrokenPipeError, KeyboardInterrupt):
        main()
    sys.exit(0)
