"""The two tiers, FMUs of the benches (the cache keeps them), and how many processes a diagnosis may use here."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Generator
from pathlib import Path

import pytest

from pam_cosim import study


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--full", action="store_true", help="also run the tests marked 'full'")


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """What is loaded here stays to the end: to look through it for waste takes as long as to load it."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    for item in items:  # before xdist looks for the groups
        item.add_marker(pytest.mark.xdist_group(_group(item)))
    if config.getoption("--full"):
        return
    slow = [item for item in items if item.get_closest_marker("full")]
    items[:] = [item for item in items if not item.get_closest_marker("full")]
    config.hook.pytest_deselected(items=slow)


def _group(item: pytest.Item) -> str:
    """Tests that share a process, with what they keep in memory: those of a file; of every effect, those of one."""
    effect = getattr(getattr(item, "callspec", None), "params", {}).get("effect")
    return str(item.path.relative_to(item.config.rootpath)) + (
        f":{effect.name}" if hasattr(effect, "name") else ""
    )


@pytest.fixture(scope="session")
def bench() -> Callable[[str], Path]:
    """The FMU of a bench by its name."""
    return study.build


@pytest.fixture(scope="session")
def workers() -> int | None:
    """No further process for a diagnosis where the tests themselves run side by side."""
    return 0 if "PYTEST_XDIST_WORKER" in os.environ else None
