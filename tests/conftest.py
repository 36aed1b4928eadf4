"""The two tiers, FMUs of the benches (the cache keeps them), and how many processes a diagnosis may use here."""

from __future__ import annotations

import gc
import os
import zlib
from collections.abc import Callable, Generator
from pathlib import Path

import pytest

from pam_cosim import study


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--full", action="store_true", help="also run the tests marked 'full'")
    parser.addoption(
        "--tenth",
        type=int,
        choices=range(10),
        help="run this tenth of the tests marked 'full' alone",
    )


def pytest_configure(config: pytest.Config) -> None:
    config.option.full |= config.option.tenth is not None


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
    tenth = config.getoption("--tenth")
    if config.getoption("--full") and tenth is None:
        return
    left_out = [item for item in items if _tenth(item) != tenth]
    items[:] = [item for item in items if _tenth(item) == tenth]
    config.hook.pytest_deselected(items=left_out)


def _tenth(item: pytest.Item) -> int | None:
    """Of the full tests, by the group whose tests share what they keep; none for a quick test."""
    slow = item.get_closest_marker("full")
    return zlib.crc32(_group(item).encode()) % 10 if slow else None


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
