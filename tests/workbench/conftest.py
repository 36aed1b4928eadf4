"""A study on data of the independent rig, whose model lacks an effect, and a window that keeps what it is told."""

from __future__ import annotations

import json
import shutil
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import pytest

from pam_cosim.workbench import Session
from rig.named import effect_of
from rig.short import write_light_data
from tests.workbench.frames_read import read_frame

HIDDEN = "elasticity:linear"
PATIENCE = 120.0  # s, on a machine that does other things too


class Window:
    """A page without a browser."""

    def __init__(self, session: Any) -> None:
        self.session, self._told, self._new = session, [], threading.Condition()
        self.end: Callable[[], None] = session.subscribe(self._hear).result(PATIENCE)

    def _hear(self, message: str | bytes) -> None:
        with self._new:
            self._told.append(message)
            self._new.notify_all()

    @property
    def events(self) -> list[dict[str, Any]]:
        return [json.loads(m) for m in list(self._told) if isinstance(m, str)]

    @property
    def frames(self) -> list[tuple[dict[str, Any], dict[Any, Any]]]:
        return [read_frame(m) for m in list(self._told) if isinstance(m, bytes)]

    def of(self, name: str) -> list[dict[str, Any]]:
        return [e for e in self.events if e["event"] == name]

    def last(self, name: str) -> dict[str, Any]:
        return self.of(name)[-1]

    def forget(self) -> None:
        with self._new:
            self._told.clear()

    def do(self, **command: Any) -> dict[str, Any]:
        done: Future[dict[str, Any]] = self.session.do(command)
        return done.result(PATIENCE)

    def in_its_thread(self, act: Callable[[], None]) -> None:
        """Does what no command does where commands are done, one at a time: a simulator is one run's."""
        self.session._thread.submit(act).result(PATIENCE)

    def until(self, name: str, **fields: Any) -> dict[str, Any]:
        """Waits for an event with these fields."""
        deadline, seen = time.monotonic() + PATIENCE, 0
        with self._new:
            while True:
                for message in self._told[seen:]:
                    seen += 1
                    event = json.loads(message) if isinstance(message, str) else {"event": ""}
                    if event["event"] == name and all(event.get(k) == v for k, v in fields.items()):
                        return event
                assert time.monotonic() < deadline, f"no {name} {fields} came"
                self._new.wait(1.0)

    def work(self, **command: Any) -> dict[str, Any]:
        """Does something that takes long, to its end."""
        self.forget()
        self.do(**command)
        return self.until("idle", what=command["do"])


@pytest.fixture(scope="session")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A data set whose hidden effect is a linear bladder; to be copied."""
    return write_light_data(tmp_path_factory.mktemp("rig") / "my-rig", [effect_of(HIDDEN)], 1)


@pytest.fixture
def folder(recorded: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(recorded, tmp_path / "my-rig"))


@pytest.fixture(scope="module")
def shared(recorded: Path) -> Iterator[Session]:
    """A study for the tests of one file that write nothing."""
    with Session(recorded) as session:
        yield session


@pytest.fixture
def window(shared: Session) -> Iterator[Window]:
    """A window of it, as it was opened."""
    window = Window(shared)
    yield window
    put_back(window)


def put_back(window: Window) -> None:
    """Takes everything back that was done."""
    session = window.session
    if session.job is not None:
        window.do(do="discard")
    while session.past:
        window.do(do="undo")
    assert session.state == session.first
    window.end()
