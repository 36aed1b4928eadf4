"""The command ``describe``."""

from __future__ import annotations

from typing import Annotated

import typer

from pam_cosim.cli.commands.common import FilesOption, ModelArgument
from pam_cosim.simulation import models


def describe(
    model: ModelArgument,
    files: FilesOption = None,
    show_all: Annotated[
        bool, typer.Option("--all", help="Also every variable inside, which --keep can keep.")
    ] = False,
) -> None:
    """Inputs, outputs and parameters of a model, with units, defaults and ranges."""
    interface = models.describe(model, files or [])
    typer.echo(str(interface))
    if show_all:
        typer.echo("variables inside:")
        for variable in interface.locals.values():
            typer.echo(
                f"  {variable.name} [{variable.unit or '1'}] {variable.description}".rstrip()
            )
