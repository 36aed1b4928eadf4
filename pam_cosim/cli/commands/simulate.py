"""The command ``simulate``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.cli.arguments import parse_pairs
from pam_cosim.cli.commands.common import (
    FilesOption,
    InputOption,
    KeepOption,
    ModelArgument,
    SetOption,
    TimeoutOption,
    WidthOption,
    check_results,
    say_written,
)
from pam_cosim.exports import check_table_ending
from pam_cosim.wording import look_first


def simulate(
    model: ModelArgument,
    settings: SetOption = None,
    inputs: InputOption = None,
    stop_time: Annotated[
        str | None, typer.Option(help="End of the run, such as 20 or '2 min'; in s.")
    ] = None,
    interval: Annotated[
        str | None, typer.Option(help="Time between two rows of the result, such as '1 ms'.")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="Write the trajectory: CSV, .nc (NetCDF), .parquet.",
        ),
    ] = None,
    keep: KeepOption = None,
    plot: Annotated[Path | None, typer.Option(help="Draw the outputs.")] = None,
    width: WidthOption = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """One run of a model."""
    check_results(output, pictures=[plot], sources=[model, inputs], files=files)
    if output:
        check_table_ending(output)
    trajectory = study.simulate(
        model,
        parse_pairs(settings),
        inputs,
        outputs=keep or [],
        stop_time=stop_time,
        interval=interval,
        files=files or [],
        timeout=timeout,
    )
    if trajectory.solver:
        typer.echo(f"pam-cosim: {trajectory.solver}", err=True)
    if output:
        trajectory.save(output)
    if plot:
        study.draw(trajectory, plot, width)
    for line in [*look_first(trajectory.warnings), *str(trajectory).splitlines()[1:]]:
        typer.echo(line.strip())
    say_written(output, plot)
