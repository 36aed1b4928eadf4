"""The command ``new``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from pam_cosim import study
from pam_cosim.cli.arguments import parse_pairs
from pam_cosim.cli.commands.common import FilesOption, ModelOption, RoleOption, say_written
from pam_cosim.drafting import NewDataSet


def new(
    folder: Annotated[Path, typer.Argument(help="The new data set's folder, missing or empty.")],
    recordings: Annotated[
        list[Path],
        typer.Argument(help="Recordings: CSV, MATLAB, HDF5, TDMS, Parquet; one run each."),
    ],
    title: Annotated[
        str | None, typer.Option("--title", help="Default: the folder's name.")
    ] = None,
    model: ModelOption = None,
    muscle: Annotated[
        str | None,
        typer.Option("--muscle", help="The muscle, as 'pam-cosim bench --list' names it."),
    ] = None,
    valve: Annotated[
        str | None,
        typer.Option(
            "--valve", help="Its data sheet, as '0.8 mm2 at 250 mA' or '120 l/min at 5 V'."
        ),
    ] = None,
    columns: Annotated[
        list[str] | None,
        typer.Option(
            "--column", help="NAME=COLUMN or NAME=FORMULA: what an input, an output or time is."
        ),
    ] = None,
    parameters: Annotated[
        list[str] | None,
        typer.Option("--parameter", help='NAME=VALUE, as "load.m=2.27 kg": known of all runs.'),
    ] = None,
    recording: Annotated[
        list[str] | None,
        typer.Option(
            "--recording", help='KEY=VALUE of [recording], as "decimal=," or "interval=1 ms".'
        ),
    ] = None,
    roles: RoleOption = None,
    files: FilesOption = None,
) -> None:
    """Write a data set from recordings: columns, bench, roles and noise are recognised, and guesses marked."""
    new_data_set = study.new(
        folder,
        recordings,
        title=title,
        model=model,
        muscle=muscle,
        valve=valve,
        columns=parse_pairs(columns),
        parameters=parse_pairs(parameters),
        recording=parse_pairs(recording, ("names", "ignore", "missing")),
        roles=parse_pairs(roles),
        files=files or [],
    )
    _tell(new_data_set)
    say_written(folder)


def _tell(new_data_set: NewDataSet) -> None:
    typer.echo(new_data_set.headline)
    table = Table("in the files", "taken as", "why", show_lines=False)
    for guess in new_data_set.guesses:
        table.add_row(*map(escape, (guess.what, guess.taken_as, guess.why)))
    Console(width=None if sys.stdout.isatty() else 120).print(table)
    typer.echo("to check, and to state in experiment.toml:")
    for line in new_data_set.to_check:
        typer.echo(f"- {line}")
    typer.echo("next:")
    for line in new_data_set.next_commands:
        typer.echo(f"  {line}")
