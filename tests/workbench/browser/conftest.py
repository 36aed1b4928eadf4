"""The real command with its server, and a real browser in front of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

from rig.named import effect_of
from rig.short import write_light_data
from scripts.browser import MISSING, chromium
from scripts.browser import serving as served

sync_api = pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")
Browser, BrowserContext, Page = sync_api.Browser, sync_api.BrowserContext, sync_api.Page

PATIENCE = 120_000  # ms, on a machine that does other things too


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """A skip that nobody overlooks."""
    if chromium() is None:
        terminalreporter.section("browser", sep="!", red=True)
        terminalreporter.line(MISSING)


@contextmanager
def serving(folder: Path) -> Iterator[str]:
    """The address of ``pam-cosim workbench`` on a folder, for as long as it runs."""
    with served(folder) as (address, _):
        yield address


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """A Chromium that is installed; none is downloaded.

    It ends with the module: as long as Playwright is there, no other test could run an event loop of its own.
    """
    program = chromium()
    if program is None:
        pytest.skip(MISSING)
    with sync_api.sync_playwright() as playwright:
        running = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield running
        running.close()


@pytest.fixture(scope="session")
def muscle(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two short runs of the independent rig, one held out; its bladder is elastic, that of the model is not."""
    folder: Path = tmp_path_factory.mktemp("data") / "muscle"
    return write_light_data(folder, [effect_of("elasticity:linear")], seed=1)


@pytest.fixture
def opened(browser: Browser) -> Iterator[Callable[..., Page]]:
    """Opens addresses in windows; at the end none of them may have failed, or have asked for anything from outside."""
    context: BrowserContext = browser.new_context(
        viewport={"width": 1280, "height": 800}, accept_downloads=True
    )
    context.set_default_timeout(PATIENCE)
    wrong: list[str] = []

    def outside(address: str) -> None:
        if urlsplit(address).hostname != "127.0.0.1" and urlsplit(address).scheme not in (
            "data",
            "blob",
        ):
            wrong.append(f"asked for {address}")

    def open_page(
        address: str,
        wait: str = "#ladder .fit:not(:empty)",
        socket: Callable[[Any], None] | None = None,
    ) -> Page:
        page = context.new_page()
        if socket is not None:
            page.route_web_socket("**/socket", socket)
        page.on("request", lambda request: outside(request.url))
        page.on("websocket", lambda socket: outside(socket.url))
        page.on("pageerror", lambda error: wrong.append(f"script: {error}"))
        page.on(
            "console",
            lambda line: wrong.append(f"console: {line.text}") if line.type == "error" else None,
        )
        page.goto(address)
        page.wait_for_selector(wait)
        return page

    yield open_page
    context.close()
    assert wrong == []
