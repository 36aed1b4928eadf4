"""The command ``observe``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim.cli.arguments import parse_pairs, parse_point
from pam_cosim.cli.commands.common import (
    FilesOption,
    JsonOption,
    ModelArgument,
    SetOption,
    TimeoutOption,
    WidthOption,
    check_results,
    tell_and_write,
)
from pam_cosim.errors import InputError
from pam_cosim.study import observing


def observe(
    model: ModelArgument,
    recording: Annotated[
        Path, typer.Argument(help="CSV with input and measured columns: name [unit].")
    ],
    noise: Annotated[
        list[str],
        typer.Option(
            help='Standard deviation of a signal that is taken as measured, such as "p=0.5 kPa".'
        ),
    ],
    of: Annotated[
        list[str] | None, typer.Option("--of", help="Wanted, any variable; default: outputs.")
    ] = None,
    unknown: Annotated[
        list[str] | None,
        typer.Option(
            help='An unmeasured input, "F=5 N,20 N": its standard deviation at first, and of its change in 1 s.'
        ),
    ] = None,
    drift: Annotated[
        list[str] | None,
        typer.Option(
            help='Model error of a state, as a standard deviation in 1 s: "muscle.gas.p=0.1 kPa".'
        ),
    ] = None,
    spread: Annotated[
        list[str] | None, typer.Option(help="How uncertain a state is at first.")
    ] = None,
    start: Annotated[
        str | None, typer.Option(help='Values at the start, such as "p=1 bar, x=20 mm".')
    ] = None,
    held: Annotated[
        bool, typer.Option("--held", help="Inputs are held between rows, not joined by lines.")
    ] = False,
    settings: SetOption = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the estimates as CSV.")
    ] = None,
    json: JsonOption = None,
    plot: Annotated[Path | None, typer.Option(help="Draw the estimates.")] = None,
    width: WidthOption = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """What is not measured, estimated from what is, with its uncertainty (extended Kalman filter)."""
    check_results(
        json=json, tables=[output], pictures=[plot], sources=[model, recording], files=files
    )
    point = {} if start is None else parse_point([start])
    if not isinstance(point, dict):
        raise InputError("--start: give values by name, such as 'p=1 bar'")
    observation = observing.observe(
        model,
        recording,
        parse_pairs(settings),
        noise=parse_pairs(noise),
        outputs=of,
        unknown={name: _two(name, text) for name, text in parse_pairs(unknown).items()},
        drift=parse_pairs(drift),
        spread=parse_pairs(spread),
        start=point,
        interpolation="previous" if held else "linear",
        files=files or [],
        timeout=timeout,
    )
    tell_and_write(observation, output, json, plot, width)


def _two(name: str, text: str) -> tuple[str, str]:
    parts = [part.strip() for part in text.split(",")]
    if len(parts) != 2 or not all(parts):
        raise InputError(
            f"'{name}={text}': write its initial standard deviation and its change in 1 s: '5 N,20 N'"
        )
    return parts[0], parts[1]
