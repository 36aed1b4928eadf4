"""Runs in a process of their own: an FMU that crashes or never returns takes nothing else down."""

from __future__ import annotations

import contextlib
import math
import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

from numpy.typing import ArrayLike

from pam_cosim.counts import checked_time
from pam_cosim.fmu.read import read_interface
from pam_cosim.interface import Interface
from pam_cosim.simulation import keeper
from pam_cosim.simulation.driver import Progress, Settle, prepare_driver
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.inputs import Inputs
from pam_cosim.simulation.memory import MOST_MEMORY
from pam_cosim.simulation.stepper import Abilities
from pam_cosim.simulation.trajectory import Trajectory

TIME_LIMIT = 60.0  # [s] without progress: loading and each call of an FMU take milliseconds as a rule
_TICKS = 4  # looks at the progress within the limit, at least
_LONGEST_TICK = 1.0  # [s]


class IsolatedSimulator:
    """As ``Simulator``, for FMUs that are not trusted: one that crashes or hangs ends one run only.

    Between this process and the FMU's stands a third one, which ends the latter when it makes no progress or when this
    process ends, however it does (``keeper``). One that hangs while it is loaded is not loaded again.

    Args:
        path: an FMI 2.0 or 3.0 co-simulation FMU.
        timeout: [s] without progress, after which the FMU is ended: to load it, or in any one call such as a step.
            A run that goes on may last as long as it likes. None: ``TIME_LIMIT``; infinite: no limit.

    Raises:
        InputError: not such an FMU, or no such limit.
    """

    def __init__(self, path: Path, timeout: float | None = None) -> None:
        self.path, self.timeout = Path(path), checked_time(TIME_LIMIT if timeout is None else timeout)
        self.interface: Interface = read_interface(self.path)
        self._settles: bool | None = None
        self._process: subprocess.Popen[bytes] | None = None
        self._never_loaded = False

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
        """Frees the FMU and ends its process, also where it does not want to; the next run would start another."""
        if self._process is not None and self._process.stdin is not None:
            with contextlib.suppress(OSError):
                keeper.write_frame(self._process.stdin, keeper.CLOSE)
        self._end()

    def _end(self) -> None:
        """Ends the process; at once, where it was not told before to close."""
        process, self._process = self._process, None
        if process is None:
            return
        assert process.stdin is not None and process.stdout is not None
        with contextlib.suppress(OSError):
            process.stdin.close()
        process.stdout.close()
        process.wait()

    def run(
        self,
        times: ArrayLike,
        *,
        parameters: Mapping[str, float] | None = None,
        inputs: Inputs | None = None,
        outputs: Sequence[str] | None = None,
        tolerance: float | None = None,
        start_time: float | None = None,
        settle: Settle = "none",
    ) -> Trajectory:
        """As ``Simulator.run``; a crash of the FMU, or a call that does not return, is a ``RunFailure`` as well."""
        request = {
            "times": times,
            "parameters": parameters,
            "inputs": inputs,
            "outputs": outputs,
            "tolerance": tolerance,
            "start_time": start_time,
            "settle": settle,
        }
        answer = self._answer("run", request)
        assert isinstance(answer, Trajectory)
        return answer

    def equilibria(
        self,
        inputs: Mapping[str, ArrayLike],
        *,
        parameters: Mapping[str, float] | None = None,
        outputs: Sequence[str] | None = None,
    ) -> Trajectory:
        """As ``Simulator.equilibria``; likewise."""
        answer = self._answer("equilibria", {"inputs": inputs, "parameters": parameters, "outputs": outputs})
        assert isinstance(answer, Trajectory)
        return answer

    @property
    def settles(self) -> bool:
        """As ``Simulator.settles``."""
        if self._settles is None:
            self._settles = bool(self._answer("settles", {}))
        return self._settles

    def stepper(self) -> RemoteStepper:
        """A new run, step by step, in the FMU's process; it ends when another run begins, and with that process."""
        return RemoteStepper(self._answer)

    def _answer(self, call: str, arguments: dict[str, Any], alone: bool = True) -> Any:
        """What the FMU's process makes of a call; where not ``alone``, it goes on with what came before."""
        if not alone and (self._process is None or self._process.poll() is not None):
            raise RunFailure(f"the run of {self.path.name} has ended with its process")
        kind, answer = self._ask({"call": call, "arguments": arguments})
        if kind == "error":
            raise answer
        return answer

    def _ask(self, request: dict[str, Any]) -> tuple[str, Any]:
        if self._never_loaded:
            raise self._late(None, request)
        if self._process is not None and self._process.poll() is not None:
            self._end()
        process = self._process = self._process or start_kept(self.path, self.timeout)
        assert process.stdin is not None and process.stdout is not None
        try:
            with contextlib.suppress(OSError):  # it has ended: the answer says why
                keeper.write_frame(process.stdin, keeper.REQUEST, pickle.dumps(request))
            kind, content = keeper.read_frame(process.stdout)
        except EOFError:
            self._end()
            raise RunFailure(f"the process that watches {self.path.name} has ended") from None
        except BaseException:
            self._end()
            raise
        if kind == keeper.ANSWER:
            return self._unpacked(content)
        self._end()
        if kind == keeper.LATE:
            progress = pickle.loads(content) if content else None
            self._never_loaded = bool(content) and progress is None
            raise self._late(progress, request)
        raise RunFailure(f"{self.path.name} crashed its process ({cause_of_end(int(content))}){_memory(content)}")

    def _unpacked(self, content: bytes) -> tuple[str, Any]:
        """An answer as the FMU's process packed it, unless the FMU wrote into it."""
        try:
            kind, answer = pickle.loads(content)
        except Exception:
            self._end()
            raise RunFailure(f"{self.path.name} has written into the files of its process") from None
        return kind, answer

    def _late(self, progress: Progress | None, request: dict[str, Any]) -> RunFailure:
        place = (
            progress.function if progress else "while it was loaded" if self._never_loaded else "while it was made anew"
        )
        reason = (
            f"{self.path.name} was ended: no progress for {self.timeout:g} s, {place}; "
            "a longer time limit (--timeout) may help"
        )
        return RunFailure(reason, progress.time if progress else None, request["arguments"].get("parameters"))


class RemoteStepper:
    """A run of an FMU in a process of its own; as ``AnyStepper``.

    Args:
        answer: what that process makes of a call.
    """

    def __init__(self, answer: Callable[[str, dict[str, Any], bool], Any]) -> None:
        self._answer = answer

    def abilities(self) -> Abilities:
        """As ``AnyStepper``."""
        abilities: Abilities = self._answer("abilities", {}, False)
        return abilities

    def begin(self, values: Mapping[str, float], start_time: float = 0.0, tolerance: float | None = None) -> None:
        """As ``AnyStepper``."""
        self._answer("begin", {"values": values, "start_time": start_time, "tolerance": tolerance}, True)

    def initialised(self) -> None:
        """As ``AnyStepper``."""
        self._answer("initialised", {}, False)

    def read(self, names: Sequence[str], inputs: Mapping[str, float] | None = None) -> list[float]:
        """As ``AnyStepper``."""
        values: list[float] = self._answer("read", {"names": names, "inputs": inputs}, False)
        return values

    def advance(
        self,
        duration: float,
        inputs: Mapping[str, float] | None = None,
        slopes: Mapping[str, float] | None = None,
        names: Sequence[str] = (),
        can_go_back: bool = False,
    ) -> list[float]:
        """As ``AnyStepper``."""
        arguments = {
            "duration": duration, "inputs": inputs, "slopes": slopes, "names": names, "can_go_back": can_go_back
        }  # fmt: skip
        values: list[float] = self._answer("advance", arguments, False)
        return values

    def save(self) -> int:
        """As ``AnyStepper``."""
        return int(self._answer("save", {}, False))

    def restore(self, number: int) -> None:
        """As ``AnyStepper``."""
        self._answer("restore", {"number": number}, False)

    def forget(self, number: int) -> None:
        """As ``AnyStepper``."""
        self._answer("forget", {"number": number}, False)

    def freeze(self, number: int) -> bytes:
        """As ``AnyStepper``."""
        return bytes(self._answer("freeze", {"number": number}, False))

    def thaw(self, state: bytes, time: float) -> int:
        """As ``AnyStepper``."""
        return int(self._answer("thaw", {"state": state, "time": time}, False))

    def take_messages(self) -> list[str]:
        """As ``AnyStepper``."""
        return list(self._answer("take_messages", {}, False))


def start_kept(path: Path, timeout: float, worker: str = "pam_cosim.simulation.worker") -> subprocess.Popen[bytes]:
    """The keeper of a process that answers requests: the module ``worker`` with an FMU's path."""
    prepare_driver()  # not within the time limit
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    limit = timeout if math.isfinite(timeout) else 0.0
    tick = min(_LONGEST_TICK, timeout / _TICKS)
    answering = [sys.executable, "-m", worker, str(path), str(tick)]
    command = [sys.executable, "-I", "-S", str(Path(keeper.__file__)), str(limit), *answering]
    # a session of its own: an interrupt from the terminal is this process's alone, which then ends the others
    return subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment, start_new_session=True
    )


def cause_of_end(code: int) -> str:
    """Of a process, by its exit status."""
    if code >= 0:
        return f"exit status {code}"
    try:
        return f"signal {signal.Signals(-code).name}"
    except ValueError:
        return f"signal {-code}"


def _memory(content: bytes) -> str:
    """A hint where the end may come of too little memory."""
    return f"; it may use {MOST_MEMORY / 1e9:g} GB of memory at most" if int(content) in (-6, -11, 134, 139) else ""
