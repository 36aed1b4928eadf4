"""The process behind ``IsolatedSimulator`` in which the FMU runs: requests in, progress and answers out."""

from __future__ import annotations

import os
import pickle
import sys
import tempfile
import threading
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any, BinaryIO

from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.processes.memory import limit_memory
from pam_cosim.processes.watchdog import ANSWER, PROGRESS, read_frame, write_frame
from pam_cosim.simulation.driver import RunProgress
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.simulator import Simulator
from pam_cosim.simulation.stepper import Stepper


def private_output() -> BinaryIO:
    """Standard output for the answers alone; what the FMU prints goes to standard error."""
    channel = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    return channel


def private_input() -> BinaryIO:
    """Standard input for the requests alone; an FMU that reads from it finds nothing."""
    channel = os.fdopen(os.dup(0), "rb")
    with open(os.devnull, "rb") as nothing:
        os.dup2(nothing.fileno(), 0)
    return channel


class _Worker:
    """Answers requests, and reports the progress of the present one from time to time.

    Args:
        path: the FMU.
        tick: seconds between two looks at the progress.
        make: what runs it, with a ``progress`` and ``close``.
    """

    def __init__(self, path: Path, tick: float, make: Callable[[Path], Any]) -> None:
        self._path, self._tick, self._make = path, tick, make
        self._requests, self._channel = private_input(), private_output()
        self._lock = threading.Lock()
        self._told: RunProgress | None = None
        self.simulator: Any = None
        self._stepper: Stepper | None = None
        threading.Thread(target=self._watch, daemon=True).start()

    def _watch(self) -> None:
        pause = threading.Event()
        while not pause.wait(self._tick):
            progress = self.simulator.progress if self.simulator is not None else None
            if progress is not None and progress != self._told:
                self._told = progress
                self._send(PROGRESS, progress)

    def _send(self, kind: bytes, content: object) -> None:
        with self._lock:
            write_frame(self._channel, kind, pickle.dumps(content))

    def _answer(self, request: dict[str, Any]) -> tuple[str, Any]:
        try:
            if self.simulator is None:
                self._send(
                    PROGRESS, None
                )  # before the FMU is loaded: nothing in this process can speak meanwhile
                self.simulator = self._make(self._path)
            return "result", self._do(self.simulator, **request)
        except (InputError, SimulationFailure) as error:
            return "error", error

    def _do(self, simulator: Any, call: Any, arguments: dict[str, Any]) -> Any:
        """One function of the simulator, or of a run step by step, which its ``begin`` starts; or work on a model."""
        if callable(call):
            return call(simulator, *arguments["positional"])
        if call == "run":
            return simulator.run(**arguments)
        if call == "equilibria":
            return simulator.equilibria(**arguments)
        if call == "settles":
            return simulator.settles
        if call == "begin":
            self._stepper = simulator.stepper()
        if self._stepper is None:
            raise RunFailure(f"the run of {self._path.name} has ended")
        return getattr(self._stepper, call)(*arguments.pop("positional", ()), **arguments)

    def serve(self) -> None:
        """Answers requests until the input ends."""
        while True:
            try:
                _, content = read_frame(self._requests)
            except EOFError:
                return
            self._told = None
            self._send(ANSWER, self._answer(pickle.loads(content)))


def unlimited(path: Path) -> Simulator:
    """An FMU whose steps are its own affair: who waits for it looks at its progress."""
    simulator = Simulator(path)
    simulator.limit = None
    return simulator


def main(path: Path, tick: float, make: Callable[[Path], Any], folder: str) -> None:
    """Serves one FMU, with ``folder`` for all temporary files: who ends this process removes it."""
    tempfile.tempdir = folder
    limit_memory()
    worker = _Worker(path, tick, make)
    worker.serve()
    if worker.simulator is not None:
        worker.simulator.close()


if __name__ == "__main__":
    module, function = sys.argv[3].split(":")
    main(
        Path(sys.argv[1]),
        float(sys.argv[2]),
        getattr(import_module(module), function),
        sys.argv[4],
    )
