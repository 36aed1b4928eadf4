"""The command ``effects``."""

from __future__ import annotations

import sys
from collections.abc import Iterator

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from pam_cosim import study
from pam_cosim.catalogue import EffectClass
from pam_cosim.cli.commands.common import (
    FilesOption,
)

_PARAMETERS = "parameters, with what is typical [SI]"


def effects(files: FilesOption = None) -> None:
    """The catalogue of effects."""
    listed = study.effects(files or [])
    for library in dict.fromkeys(e.library for e in listed):
        table = Table(
            "family", "effect", "balance", _PARAMETERS, "what it is", title=escape(library)
        )
        for e in listed:
            if e.library == library:
                cells = (e.family, e.name, e.balance, ", ".join(_parameters(e)), e.description)
                table.add_row(*map(escape, cells))
        Console(width=None if sys.stdout.isatty() else 160).print(table)


def _parameters(effect: EffectClass) -> Iterator[str]:
    for name in effect.parameters:
        interval = effect.typical.get(name)
        yield f"{name} ({interval[0]:g} to {interval[1]:g})" if interval else name
