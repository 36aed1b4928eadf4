"""One study that a person works on: its commands are done one at a time. There is no web in it."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from concurrent.futures import Future
from typing import Any

from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.workbench.checks import one_of
from pam_cosim.workbench.commands import COMMANDS
from pam_cosim.workbench.commands.files import load_at_first
from pam_cosim.workbench.job_queue import StudyWithJobs
from pam_cosim.workbench.protocol import Json
from pam_cosim.workbench.windows import Listener


class Session(StudyWithJobs):
    """A study with its windows and commands.

    Every command runs in one thread, in the order in which they came; values that are set while others are being drawn
    wait as one, so that dragging a slider never makes a queue. What takes long runs in a process of its own.
    The arguments are those of ``StudyWithJobs``.
    """

    def _begin(self, model: str | None) -> None:
        super()._begin(model)
        try:
            load_at_first(self, model_is_stated=model is not None)
        except (InputError, SimulationFailure) as problem:
            self.tell_failure(problem, "load", line=True)

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *problem: object) -> None:
        self.close()

    def subscribe(self, listener: Listener) -> Future[Callable[[], None]]:
        """Adds a window, which is sent everything there is; the result of the future removes it.

        The listener is called from other threads and must not wait.
        """

        def begin() -> Callable[[], None]:
            self.windows.tell(self.shown_study())
            return self.windows.subscribe(listener)

        return self._thread.submit(begin)

    def do(self, command: Mapping[str, Any]) -> Future[Json]:
        """Takes a command of a page; the future holds the answer.

        Its exceptions are ``InputError`` and ``SimulationFailure``.
        """
        arguments = {str(key): value for key, value in command.items() if key not in ("do", "id")}
        try:
            name = one_of(command.get("do"), COMMANDS, "command")
            inspect.signature(COMMANDS[name]).bind(self, **arguments)
            values = arguments.get("values", {})
            if not isinstance(values, Mapping):
                raise InputError("set needs values by name")
            if name != "set" or not arguments.get("dragged"):
                return self._thread.submit(self._done_as, name, arguments)
        except (TypeError, InputError) as problem:
            refused: Future[Json] = Future()
            if isinstance(problem, TypeError):
                problem = InputError(f"the command {name} cannot be used: {problem}")
            refused.set_exception(problem)
            return refused
        with self._lock:
            self._waiting |= {str(number): value for number, value in values.items()}
        return self._thread.submit(self._set_waiting)

    def _set_waiting(self) -> Json:
        with self._lock:
            values, self._waiting = self._waiting, {}
        if not values:
            return {"version": self.version}
        return self._done_as("set", {"values": values, "dragged": True})

    def _done_as(self, name: str, arguments: Json) -> Json:
        result = COMMANDS[name](self, **arguments)
        return {"version": self.version, **(result or {})}

    def wait(self) -> None:
        """Returns when all commands are done, but for what takes long."""
        self._thread.submit(lambda: None).result()
