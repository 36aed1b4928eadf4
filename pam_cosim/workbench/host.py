"""What a server is of: a study, or files that are to become one."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any

from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.files import is_vacant
from pam_cosim.wording import shown
from pam_cosim.workbench.drop import Drop
from pam_cosim.workbench.job_process import Worker
from pam_cosim.workbench.protocol import Json, event
from pam_cosim.workbench.session import Session
from pam_cosim.workbench.windows import Listener, Windows


class Workbench:
    """A study in its folder, or the place where recordings are dropped until there is one.

    Args:
        folder: of the data set; where it is missing or empty, recordings are dropped.
        model: default: the bench of the data set.
        files: further Modelica files.
        worker: the process in which a study fits, if there is one already.

    Raises:
        InputError: the data set cannot be read.
    """

    def __init__(
        self,
        folder: Path,
        *,
        model: str | None = None,
        files: Sequence[Path] = (),
        worker: Worker | None = None,
    ) -> None:
        self.folder = Path(folder)
        self.windows, self.worker = Windows(), worker or Worker()
        self._session = partial(
            Session, self.folder, model=model, files=files, windows=self.windows, worker=self.worker
        )
        self.session: Session | None = None
        self.drop: Drop | None = None
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="drop")
        if is_vacant(self.folder):
            self.drop = Drop(self.folder, tuple(files))
            name = self.folder.resolve().name
            self.windows.tell(event("study", title=name, folder=name, state="drop"))
            self.windows.tell(self.drop.dropped())
        else:
            self.session = self._session()

    def wake(self) -> None:
        """Starts, and lets build, what will be needed for the first fit, while the person looks at the page."""
        if self.session is not None:
            self.session.submit(self.session.prepare)

    def close(self) -> None:
        """Ends everything."""
        self._thread.shutdown(wait=True, cancel_futures=True)
        if self.session is not None:
            self.session.close()
        self.worker.end()
        if self.drop is not None:
            self.drop.close()

    def __enter__(self) -> Workbench:
        return self

    def __exit__(self, *problem: object) -> None:
        self.close()

    def subscribe(self, listener: Listener) -> Future[Callable[[], None]]:
        """As ``Session.subscribe``."""
        if self.session is not None:
            return self.session.subscribe(listener)
        return self._thread.submit(self.windows.subscribe, listener)

    def do(self, command: Mapping[str, Any]) -> Future[Json]:
        """As ``Session.do``; with "draft", "create" and "remove" where there is no data set yet."""
        if self.session is not None:
            return self.session.do(command)
        return self._thread.submit(self._do, dict(command))

    def put(self, name: str, content: bytes | bytearray) -> Future[Json]:
        """Takes a recording that was dropped."""
        return self._thread.submit(self._put, name, content)

    def _put(self, name: str, content: bytes | bytearray) -> Json:
        dropped = self._dropping().put(name, content)
        self.windows.tell(dropped)
        return {"files": [file["name"] for file in dropped["files"]]}

    def _dropping(self) -> Drop:
        if self.drop is None:
            raise InputError(
                "there is a data set already: begin another with pam-cosim workbench NEW-FOLDER"
            )
        return self.drop

    def _do(self, command: Json) -> Json:
        drop, name = self._dropping(), command.get("do")
        if name not in ("draft", "create", "remove"):
            raise InputError(f"{shown(name)} needs a data set: drop recordings first")
        wishes = command.get("wishes") or {}
        if not isinstance(wishes, Mapping):
            raise InputError("wishes must map names to texts")
        if name == "remove":
            self.windows.tell(drop.remove(command.get("names") or []))
        elif name == "draft":
            self.windows.tell(drop.draft(wishes))
        else:
            self._open(drop, wishes)
        return {}

    def _open(self, drop: Drop, wishes: Mapping[str, Any]) -> None:
        """Makes the data set and opens it, or leaves nothing of it.

        Raises:
            InputError: what cannot be used, or simulated; the page gets it too, with the fields that answer it.
        """
        drop.create(wishes)
        try:
            self.session, self.drop = self._session(complete=True), None
        except (InputError, SimulationFailure) as problem:
            shutil.rmtree(self.folder)
            self.windows.tell(drop.failed(wishes, problem))
            raise
        self.windows.forget("dropped", "draft")
        drop.close()
        self.wake()
