"""The page's server before windows that never read and files that are broken, endless or never end."""

from __future__ import annotations

import asyncio
import socket
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from threading import Thread
from typing import Any
from urllib.parse import urlsplit

import httpx
import pytest

pytest.importorskip("starlette", reason="the extra 'workbench' is not installed")

from starlette.testclient import TestClient

from pam_cosim.errors import InputError
from pam_cosim.workbench import Workbench, server
from pam_cosim.workbench.server import application

TOKEN = "a-token-of-a-test"
HOME = "http://127.0.0.1:8123"
PATIENCE = 60.0  # s for an answer


@pytest.fixture
def workbench(tmp_path: Path) -> Iterator[Workbench]:
    with Workbench(tmp_path / "rig") as made:
        yield made


@pytest.fixture
def client(workbench: Workbench) -> Iterator[TestClient]:
    with TestClient(
        application(workbench, TOKEN), base_url=HOME, headers={"Origin": HOME}
    ) as client:
        assert client.get(f"/?token={TOKEN}").status_code == 200
        yield client


class Deaf:
    """A socket of a window that never reads: nothing that is sent arrives, and nothing comes."""

    def __init__(self) -> None:
        self.closed: list[int] = []

    async def send_text(self, text: str) -> None:
        await asyncio.Event().wait()

    async def receive(self) -> Any:
        await asyncio.Event().wait()

    async def close(self, code: int, reason: str) -> None:
        self.closed.append(code)
        await asyncio.Event().wait()


@pytest.mark.parametrize(
    ("size", "most"), [pytest.param(10, 30_000, marks=pytest.mark.full), (1_000_000, 200)]
)
def test_a_window_that_never_reads_is_given_up(workbench: Workbench, size: int, most: int) -> None:
    async def told() -> tuple[int, int]:
        socket = Deaf()
        window = server.Window(socket, asyncio.get_running_loop())  # type: ignore[arg-type]
        serving = asyncio.create_task(window.serve(workbench))
        longest = 0
        for _ in range(most):
            window.tell("x" * size)
            await asyncio.sleep(0)
            longest = max(longest, window.waiting.qsize())
        await asyncio.wait_for(serving, PATIENCE)
        assert socket.closed == [1013] and window.waiting.empty()
        return longest, longest * size

    count, letters = asyncio.run(told())
    assert count <= server.MOST_WAITING and letters <= server.MOST_WAITING_LETTERS


def test_stalled_uploads_and_connections_are_given_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """More connections that ask for nothing than a process may have files, and uploads that never end."""
    monkeypatch.setattr(server, "STALLED", 2.0)
    told: list[str] = []
    serving = Thread(
        target=lambda: server.serve(tmp_path / "rig", browser=False, tell=told.append), daemon=True
    )
    serving.start()
    end = time.monotonic() + PATIENCE
    while len(told) < 2 and time.monotonic() < end:
        time.sleep(0.05)
    address = told[0].split()[-1]
    place = urlsplit(address)
    assert place.port
    with ExitStack() as opened:
        page = opened.enter_context(httpx.Client(follow_redirects=True, timeout=PATIENCE))
        assert page.get(address).status_code == 200
        (cookie,) = [f"{n}={v}" for n, v in page.cookies.items()]
        head = f"POST /drop?name=a.csv HTTP/1.1\r\nHost: {place.netloc}\r\nOrigin: http://{place.netloc}\r\n"
        head += f"Cookie: {cookie}\r\nContent-Length: 100\r\n\r\ntime"
        for text in [head] * 3 + ["", "GET / HT"] * 20:
            one = opened.enter_context(socket.create_connection(("127.0.0.1", place.port)))
            one.sendall(text.encode())
            last = one
        assert page.get(f"http://{place.netloc}/").status_code == 200
        sent = page.post(
            f"http://{place.netloc}/drop?name=b.csv", content=b"time [s],p [kPa]\n0,1\n",
            headers={"Origin": f"http://{place.netloc}"},
        )  # fmt: skip
        assert sent.status_code == 200 and sent.json() == {"files": ["b.csv"]}
        last.settimeout(PATIENCE)
        assert last.recv(100) == b""


def test_files_that_are_too_large(
    client: TestClient, workbench: Workbench, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer = client.post("/drop?name=a.csv", content=b"x", headers={"Content-Length": str(10**18)})
    assert answer.status_code == 409 and "200 MB" in answer.json()["failed"]["text"]
    monkeypatch.setattr(server, "MOST_BYTES", 100_000)
    sent = 0

    def endless() -> Iterator[bytes]:
        nonlocal sent
        for _ in range(1000):
            sent += 1
            yield b"x" * 1000

    assert client.post("/drop?name=a.csv", content=endless()).status_code == 409
    monkeypatch.setattr("pam_cosim.workbench.drop.MOST_TOGETHER", 100)
    with pytest.raises(InputError, match="together"):
        workbench.put("b.csv", b"x" * 101).result(PATIENCE)
    assert workbench.drop is not None and list(workbench.drop.place.iterdir()) == []
