"""The command ``linearise``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.analysis import LinearModels
from pam_cosim.cli.arguments import parse_pairs, parse_point
from pam_cosim.cli.commands.common import (
    FilesOption,
    JsonOption,
    ModelArgument,
    SetOption,
    TimeoutOption,
    WidthOption,
    check_results,
    say_written,
    tell_and_write,
)
from pam_cosim.errors import InputError
from pam_cosim.files import write_json
from pam_cosim.study import dynamics
from pam_cosim.study.input_sources import read_inputs


def linearise(
    model: ModelArgument,
    at: Annotated[
        list[str] | None,
        typer.Option(
            help='"rest" (default), a state "p=6 bar, x=20 mm", or times of a run, "time=2 s", several if given again.'
        ),
    ] = None,
    free: Annotated[
        list[str] | None,
        typer.Option(
            help="An input whose value is solved for: --at is then a rest with these values."
        ),
    ] = None,
    settings: SetOption = None,
    input_file: Annotated[
        Path | None, typer.Option("--input", help="CSV with input columns, for a time of a run.")
    ] = None,
    by: Annotated[
        list[str] | None, typer.Option("--by", help="Keep this input; default: all.")
    ] = None,
    of: Annotated[
        list[str] | None, typer.Option("--of", help="An output, or any variable; default: outputs.")
    ] = None,
    states: Annotated[
        list[str] | None,
        typer.Option("--state", help="Keep this state, the others are quasi-static; default: all."),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the matrices as CSV.")
    ] = None,
    json: JsonOption = None,
    plot: Annotated[Path | None, typer.Option(help="Draw gain, phase and steps.")] = None,
    width: WidthOption = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """A, B, C and D of a model about a state, a rest or times of a run."""
    check_results(
        json=json, tables=[output], pictures=[plot], sources=[model, input_file], files=files
    )
    parameters = parse_pairs(settings)
    inputs = (
        read_inputs(input_file, dynamics.exchange(model, files or []).interface)
        if input_file
        else None
    )
    point = parse_point(at or ["rest"])
    if isinstance(point, list) and len(point) > 1:
        if output is not None or by or states:
            raise InputError("-o, --by and --state are for one point; give one --at")
        along = dynamics.linearise_along(
            model, parameters, inputs, times=point, outputs=of, files=files or [], timeout=timeout
        )
        _tell(along, json, plot, width)
    else:
        linear = dynamics.linearise(
            model,
            parameters,
            at=point[0] if isinstance(point, list) else point,
            free=free or [],
            inputs=inputs,
            outputs=of,
            files=files or [],
            timeout=timeout,
        ).select(by, None, states)
        tell_and_write(linear, output, json, plot, width)


def _tell(along: LinearModels, json: Path | None, plot: Path | None, width: str | None) -> None:
    """Prints the models along a run, and writes them as JSON and as a picture where a file is given."""
    typer.echo(str(along))
    if json:
        write_json(json, along.as_dict())
    if plot:
        study.draw(along, plot, width)
    say_written(json, plot)
