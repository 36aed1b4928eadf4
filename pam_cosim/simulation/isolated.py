"""Runs in a process of their own: an FMU that crashes takes nothing else down."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

from numpy.typing import ArrayLike

from pam_cosim.fmu.read import read_interface
from pam_cosim.interface import Interface
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.inputs import Inputs
from pam_cosim.simulation.trajectory import Trajectory


class IsolatedSimulator:
    """As ``Simulator``, for FMUs that are not trusted: each crash ends one run only.

    Args:
        path: an FMI 2.0 co-simulation FMU.
        timeout: of a run [s]; an FMU that takes longer is ended. None: no limit.

    Raises:
        InputError: not such an FMU.
    """

    def __init__(self, path: Path, timeout: float | None = None) -> None:
        self.path, self.timeout = Path(path), timeout
        self.interface: Interface = read_interface(self.path)
        self._process: subprocess.Popen[bytes] | None = None

    def __enter__(self) -> IsolatedSimulator:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def __del__(self) -> None:
        if hasattr(self, "_process"):
            self.close()

    def close(self) -> None:
        """Ends the process; the next run would start another."""
        process, self._process = self._process, None
        if process is None:
            return
        assert process.stdin is not None and process.stdout is not None
        try:
            process.stdin.close()
            process.wait(timeout=5.0)
        except (OSError, subprocess.TimeoutExpired):
            process.kill()
            process.wait()
        process.stdout.close()

    def run(
        self,
        times: ArrayLike,
        *,
        parameters: Mapping[str, float] | None = None,
        inputs: Inputs | None = None,
        outputs: Sequence[str] | None = None,
        tolerance: float | None = None,
        start_time: float | None = None,
    ) -> Trajectory:
        """As ``Simulator.run``; a crash of the FMU is a ``RunFailure`` as well."""
        request = {
            "times": times,
            "parameters": parameters,
            "inputs": inputs,
            "outputs": outputs,
            "tolerance": tolerance,
            "start_time": start_time,
        }
        kind, answer = self._ask(request)
        if kind == "error":
            raise answer
        assert isinstance(answer, Trajectory)
        return answer

    def _ask(self, request: dict[str, Any]) -> tuple[str, Any]:
        process = self._process = self._process or _start(self.path)
        assert process.stdin is not None and process.stdout is not None
        late = threading.Event()

        def end() -> None:
            late.set()
            process.kill()

        timer = threading.Timer(self.timeout or threading.TIMEOUT_MAX, end)
        timer.daemon = True
        if self.timeout is not None:
            timer.start()
        try:
            pickle.dump(request, process.stdin)
            process.stdin.flush()
            answer: tuple[str, Any] = pickle.load(process.stdout)
            return answer
        except (EOFError, OSError, pickle.UnpicklingError):
            code = process.wait()
            self.close()
            if late.is_set():
                raise RunFailure(f"{self.path.name} was ended: it took longer than {self.timeout:g} s") from None
            raise RunFailure(f"{self.path.name} crashed its process ({_cause(code)})") from None
        finally:
            timer.cancel()


def _start(path: Path) -> subprocess.Popen[bytes]:
    """A process that answers requests on its standard input (``worker.py``)."""
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    command = [sys.executable, "-m", "pam_cosim.simulation.worker", str(path)]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment)


def _cause(code: int) -> str:
    if code >= 0:
        return f"exit status {code}"
    try:
        return f"signal {signal.Signals(-code).name}"
    except ValueError:
        return f"signal {-code}"


def run_isolated(
    path: Path,
    times: ArrayLike,
    *,
    parameters: Mapping[str, float] | None = None,
    inputs: Inputs | None = None,
    outputs: Sequence[str] | None = None,
    tolerance: float | None = None,
    start_time: float | None = None,
    timeout: float | None = None,
) -> Trajectory:
    """One run of ``IsolatedSimulator``."""
    with IsolatedSimulator(path, timeout) as simulator:
        return simulator.run(
            times,
            parameters=parameters,
            inputs=inputs,
            outputs=outputs,
            tolerance=tolerance,
            start_time=start_time,
        )
