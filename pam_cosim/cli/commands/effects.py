"""The command ``effects``."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from pam_cosim import study
from pam_cosim.catalogue import EffectClass
from pam_cosim.cli.commands.common import (
    FilesOption,
    JsonOption,
    check_results,
    say_written,
)
from pam_cosim.files import write_json
from pam_cosim.study.library import effect_sheets

_PARAMETERS = "parameters, with what is typical [SI]"


def effects(
    name: Annotated[
        str | None, typer.Argument(help="An effect, shown in full, or a family; default: all.")
    ] = None,
    files: FilesOption = None,
    json: JsonOption = None,
) -> None:
    """List the catalogue of effects, the effects of a family, or show one effect with its equations."""
    check_results(json=json, files=files)
    sheets = effect_sheets(name, files or []) if name or json else []
    listed = [sheet.effect for sheet in sheets] if name else study.effects(files or [])
    if len(sheets) == 1 and name != listed[0].family:
        typer.echo(str(sheets[0]))
    else:
        _tell(listed)
    if json:
        write_json(json, {"effects": [sheet.as_dict() for sheet in sheets]})
    say_written(json)


def _tell(listed: list[EffectClass]) -> None:
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
