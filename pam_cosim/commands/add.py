"""The command ``add``."""

from __future__ import annotations

from pathlib import Path
from shlex import quote
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.commands.common import (
    FilesOption,
    check_results,
    console,
    say_written,
)
from pam_cosim.errors import InputError
from pam_cosim.names import is_modelica


def add(
    effects: Annotated[list[str], typer.Argument(help="Effects, by the names in 'pam-cosim effects'.")],
    to: Annotated[str, typer.Option("--to", help="The model: a bench, a Modelica class or a .mo file.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="The Modelica file to write.")],
    files: FilesOption = None,
) -> None:
    """Write a readable Modelica model that extends another with effects."""
    check_results(output, sources=[to, *(files or [])])
    if output.suffix != ".mo":
        raise InputError("the model is written as Modelica: name a file that ends in .mo", output)
    typer.echo(study.add(effects, to, output, files=files or []), nl=False)
    say_written(output)
    own = [str(file) for file in files or []] + ([to] if is_modelica(to) else [])
    if own:
        words = " ".join(f"--file {quote(file)}" for file in own)
        console.print(f"it is used together with what it is made from: {words}", markup=False, soft_wrap=True)
