"""The command ``bench``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from pam_cosim import study
from pam_cosim.catalogue import BenchPart
from pam_cosim.cli.commands.common import FilesOption, check_results, say_used_with, say_written
from pam_cosim.errors import InputError
from pam_cosim.files import check_model_file


def bench(
    pneumatics: Annotated[
        str | None, typer.Option("--pneumatics", help="What feeds the muscle.")
    ] = None,
    mechanics: Annotated[
        str | None, typer.Option("--mechanics", help="What holds its load end.")
    ] = None,
    muscle: Annotated[
        str | None, typer.Option("--muscle", help="The muscle; default: the usual one.")
    ] = None,
    measure: Annotated[
        str | None,
        typer.Option(
            "--measure", help='Signals that are read: "p,x,F"; default: what such a rig reads.'
        ),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="The Modelica file to write.")
    ] = None,
    static: Annotated[
        bool, typer.Option("--static", help="For points at rest and their branches.")
    ] = False,
    listing: Annotated[bool, typer.Option("--list", help="List the parts.")] = False,
    files: FilesOption = None,
) -> None:
    """Write the bench of a rig, put together from parts, as readable Modelica."""
    if listing:
        if static or any(
            option is not None for option in (pneumatics, mechanics, muscle, measure, output)
        ):
            raise InputError(
                "--list prints the parts and writes no bench: leave out the other options"
            )
        return _list(study.rig_parts(files or []))
    if pneumatics is None or mechanics is None or output is None:
        needed = {"--pneumatics": pneumatics, "--mechanics": mechanics, "-o FILE.mo": output}
        missing = " and ".join(name for name, value in needed.items() if value is None)
        raise InputError(f"a bench needs {missing}; 'pam-cosim bench --list' lists the parts")
    check_model_file(output)
    check_results(output, sources=files or [])
    typer.echo(
        study.bench(
            pneumatics, mechanics, muscle, measure, output, static=static, files=files or []
        ),
        nl=False,
    )
    say_written(output)
    say_used_with(files or [])
    return None


def _list(parts: list[BenchPart]) -> None:
    for role in dict.fromkeys(part.role for part in parts):
        table = Table(role, "inputs", "signals", "parameters", "what it is")
        for part in parts:
            if part.role == role:
                name = f"{part.name} (usual)" if part.usual else part.name
                cells = (
                    name,
                    ", ".join(part.inputs),
                    ", ".join(part.signals),
                    ", ".join(part.parameters),
                )
                table.add_row(*map(escape, cells), escape(part.description))
        Console(width=None if sys.stdout.isatty() else 160).print(table)
