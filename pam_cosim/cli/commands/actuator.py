"""The command ``actuator``."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.cli.arguments import parse_limits, parse_pairs
from pam_cosim.cli.commands.common import FilesOption, SetOption, check_results, say_written
from pam_cosim.errors import InputError
from pam_cosim.study.fitted_model import FittedModel, read_fitted_model
from pam_cosim.units import UnitError, seconds


def actuator(
    model: Annotated[str, typer.Argument(help="Shows a pull under pressure, at a contraction.")] = (
        "QuasiStaticIsometric"
    ),
    pressure: Annotated[
        str, typer.Option("--pressure", help="Its input and span.")
    ] = "p=0 kPa:300 kPa",
    contraction: Annotated[
        str, typer.Option("--contraction", help="Its input and span.")
    ] = "x=0 mm:50 mm",
    force: Annotated[str, typer.Option("--force", help="Its output: the pull.")] = "F",
    length: Annotated[
        str, typer.Option("--length", help="Its parameter: the length at no contraction.")
    ] = "muscle.L0",
    params: Annotated[
        Path | None, typer.Option("--params", help="Fitted parameters, of 'fit -o'.")
    ] = None,
    data: Annotated[
        Path | None,
        typer.Option("--data", help="The data set of the fit: what it states of the muscle."),
    ] = None,
    settings: SetOption = None,
    time_constant: Annotated[
        str | None,
        typer.Option("--time-constant", help="In which the pressure follows its command: '50 ms'."),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write a scene of MuJoCo (.xml).")
    ] = None,
    files: FilesOption = None,
) -> None:
    """A muscle as an actuator of MuJoCo, with its error against the model."""
    if output is not None and output.suffix != ".xml":
        raise InputError("MuJoCo reads XML: name a file that ends in .xml", output)
    check_results(output, sources=[model, params, *(files or [])])
    spans = parse_limits([pressure, contraction])
    interface = study.describe(model, files or [])
    follows = None if time_constant is None else _time_constant(time_constant)
    stated = study.read(data, files=files or []).parameters if data else {}
    known = {name: value for name, value in stated.items() if name in interface.parameters}
    fitted = read_fitted_model(params) if params else FittedModel("", (), {})
    values: dict[str, float | str] = {
        **known,
        **fitted.constants,
        **fitted.of_the_model,
        **parse_pairs(settings or []),
    }
    (p, pressures), (x, contractions) = spans.items()
    made = study.actuator(
        model,
        values,
        pressures=pressures,
        contractions=contractions,
        length=length,
        names=(p, x, force),
        files=files or [],
    )
    typer.echo(str(made))
    if output:
        made.write(output, follows)
    say_written(output)


def _time_constant(text: str) -> float:
    try:
        value = seconds(text)
    except UnitError as problem:
        raise InputError(f"--time-constant: {problem}") from None
    if not 0 < value < math.inf:
        raise InputError(f"--time-constant must be a finite time above zero, not {text}")
    return value
