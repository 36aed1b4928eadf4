"""The process behind ``isolated`` in which a foreign FMU runs: a request in, progress and an answer out."""

from __future__ import annotations

import pickle
import sys
import tempfile
import threading
from pathlib import Path
from typing import Any

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.processes.watchdog import ANSWER, PROGRESS, read_frame, write_frame
from pam_cosim.simulation.worker import private_input, private_output


def main(path: Path, tick: float, folder: str) -> None:
    """Serves one request, with ``folder`` for all temporary files: who ends this process removes it."""
    tempfile.tempdir = folder
    requests, channel = private_input(), private_output()
    lock, over = threading.Lock(), threading.Event()
    models: list[ExchangeModel] = []

    def send(kind: bytes, content: object) -> None:
        with lock:
            write_frame(channel, kind, pickle.dumps(content))

    def watch() -> None:
        told = 0
        while not over.wait(tick):
            calls = models[0].calls if models else 0
            if calls != told:
                told = calls
                send(PROGRESS, calls)

    threading.Thread(target=watch, daemon=True).start()
    try:
        _, content = read_frame(requests)
    except EOFError:
        return
    send(PROGRESS, 0)  # before the FMU is loaded: nothing in this process can speak meanwhile
    answer = _answer(path, content, models)
    over.set()
    send(ANSWER, answer)


def _answer(path: Path, content: bytes, models: list[ExchangeModel]) -> tuple[bool, Any]:
    job, arguments, named = pickle.loads(content)
    try:
        with ExchangeModel(path) as model:
            models.append(model)
            return True, job(model, *arguments, **named)
    except (InputError, SimulationFailure) as error:
        return False, error


if __name__ == "__main__":
    main(Path(sys.argv[1]), float(sys.argv[2]), sys.argv[3])
