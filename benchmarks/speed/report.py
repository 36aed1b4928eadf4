"""What every benchmark shares in speaking: progress, tables, the machine, JSON."""

from __future__ import annotations

import argparse
import json
import os
import platform
from collections.abc import Iterable, Iterator, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any, TypeVar

from rich.console import Console
from rich.progress import track
from rich.table import Table

Item = TypeVar("Item")
_progress = Console(stderr=True)
# Tables keep their columns in a file or a pipe too.
_console = Console(highlight=False, width=None if Console().is_terminal else 150)


def steps_of(items: Sequence[Item] | range, what: str) -> Iterator[Any]:
    """The items, with a bar on a terminal."""
    yield from track(
        items, what, console=_progress, transient=True, disable=not _progress.is_terminal
    )


def parser(text: str | None) -> argparse.ArgumentParser:
    """Arguments that every benchmark takes."""
    made = argparse.ArgumentParser(
        description=text, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    made.add_argument("--json", type=Path, default=None, metavar="FILE", help="write the figures")
    return made


def show(title: str, columns: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Prints a table: words left, numbers right."""
    table = Table(title=title, title_justify="left", title_style="bold")
    for i, column in enumerate(columns):
        table.add_column(column, justify="left" if i == 0 else "right", overflow="fold")
    for row in rows:
        table.add_row(*row)
    _console.print(table)


def say(text: str) -> None:
    """Prints a line."""
    _console.print(text)


def machine() -> dict[str, str]:
    """What the figures were measured on."""
    packages = ("numpy", "scipy", "casadi", "fmpy", "ziglang")
    return {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        **{name: version(name) for name in packages},
    }


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor() or "unknown"
    return next(
        (line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")),
        "unknown",
    )


def write(path: Path | None, figures: dict[str, Any]) -> None:
    """Writes the figures and the machine as JSON where a file was asked for."""
    if path is not None:
        path.write_text(
            json.dumps({"machine": machine(), **figures}, indent=2) + "\n", encoding="utf-8"
        )


def milliseconds(seconds: float | None) -> str:
    """A time, or a dash."""
    return "-" if seconds is None else f"{seconds * 1e3:.3g}"
