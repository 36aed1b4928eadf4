"""The command ``add``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.cli.arguments import parse_pairs
from pam_cosim.cli.commands.common import (
    FilesOption,
    SetOption,
    check_results,
    say_used_with,
    say_written,
)
from pam_cosim.errors import InputError
from pam_cosim.files import check_model_file
from pam_cosim.study.fitted_model import read_fitted_model
from pam_cosim.wording import listed


def add(
    output: Annotated[Path, typer.Option("--output", "-o", help="The Modelica file to write.")],
    effects: Annotated[
        list[str] | None, typer.Argument(help="Effects, by the names in 'pam-cosim effects'.")
    ] = None,
    to: Annotated[
        str | None,
        typer.Option(
            "--to",
            help="The model: a bench, a Modelica class or a .mo file; default: that of --from.",
        ),
    ] = None,
    origin: Annotated[
        Path | None,
        typer.Option(
            "--from",
            help="Effects and values from a result: of 'diagnose --json', 'fit -o' or a saved product (.npz).",
        ),
    ] = None,
    learned: Annotated[
        bool,
        typer.Option(
            "--learned", help="The model with the learned term of a saved diagnosis (--from .npz)."
        ),
    ] = False,
    settings: SetOption = None,
    files: FilesOption = None,
) -> None:
    """Write a readable Modelica model that extends another with effects, and with fitted values."""
    if bool(effects) == bool(origin):
        raise InputError("name effects, or a result with --from FILE; one of the two")
    if learned and (origin is None or origin.suffix != ".npz"):
        raise InputError("--learned needs a saved diagnosis: name it with --from FILE.npz")
    if origin is None and to is None:
        raise InputError("name the model that the effects are added to: --to MODEL")
    check_model_file(output)
    check_results(output, sources=[to, origin], files=files)
    values = parse_pairs(settings)
    text = study.add(
        origin or effects or [], to, output, values=values, files=files or [], learned=learned
    )
    typer.echo(text, nl=False)
    if origin is not None:
        _say_left_out(origin)
    say_written(output)
    say_used_with(files or [])


def _say_left_out(origin: Path) -> None:
    """Reports values that are factors on stated values of a data set which the file does not name."""
    values_left_out = read_fitted_model(origin).left_out
    if values_left_out:
        note = f"{origin}: {listed(values_left_out)}: of the data and not of the model, which is written without"
        typer.echo(note, err=True)
