"""The command ``bode``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim.cli.arguments import parse_frequencies, parse_pairs, parse_point
from pam_cosim.cli.commands.common import (
    FilesOption,
    JsonOption,
    ModelArgument,
    SetOption,
    TimeoutOption,
    WidthOption,
    check_results,
    progress_bar,
    tell_and_write,
)
from pam_cosim.errors import InputError
from pam_cosim.study import dynamics


def bode(
    model: ModelArgument,
    by: Annotated[str, typer.Option("--by", help="The input that is a sine.")],
    amplitude: Annotated[str, typer.Option(help='Of the input, such as "20 mA".')],
    of: Annotated[
        list[str] | None, typer.Option("--of", help="An output, or any variable; default: outputs.")
    ] = None,
    frequencies: Annotated[
        str, typer.Option(help="FROM:TO:N [Hz], evenly in the logarithm, or A,B,C.")
    ] = "0.1:20:16",
    at: Annotated[
        str,
        typer.Option(
            help='"rest", or values of an equilibrium for which the --free inputs are solved.'
        ),
    ] = "rest",
    free: Annotated[
        list[str] | None, typer.Option(help="An input whose value is solved for with the rest.")
    ] = None,
    settings: SetOption = None,
    most_periods: Annotated[
        int,
        typer.Option(
            help="Maximum number of periods at a frequency, after which it counts as not settled."
        ),
    ] = 200,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the response as CSV.")
    ] = None,
    json: JsonOption = None,
    plot: Annotated[Path | None, typer.Option(help="Draw it over the linear model.")] = None,
    width: WidthOption = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """Frequency response of a model by sines, compared with its linear model."""
    check_results(json=json, tables=[output], pictures=[plot], sources=[model], files=files)
    point = parse_point([at])
    if isinstance(point, list):
        raise InputError("a frequency response is about an equilibrium, not about a time of a run")
    chosen = parse_frequencies(frequencies)
    with progress_bar("sines", "MofNComplete", "TimeElapsed") as progress:
        progress(0, len(chosen))
        response = dynamics.frequency_response(
            model,
            parse_pairs(settings),
            input=by,
            outputs=of,
            amplitude=amplitude,
            frequencies=chosen,
            at=point,
            free=free or [],
            most_periods=most_periods,
            files=files or [],
            timeout=timeout,
            progress=progress,
        )
    tell_and_write(response, output, json, plot, width)
