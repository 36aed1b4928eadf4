"""The command ``track``."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Annotated

import typer
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from pam_cosim.cli.arguments import parse_frequencies, parse_pairs
from pam_cosim.cli.commands.common import (
    FilesOption,
    JsonOption,
    TimeoutOption,
    check_results,
    console,
    tell_and_write,
)
from pam_cosim.cosimulation import Controller
from pam_cosim.cosimulation.python_file import controller_from
from pam_cosim.study import tracking


def track(
    plant: Annotated[str, typer.Argument(help="A bench, a Modelica class, a .mo or an .fmu file.")],
    controller: Annotated[str, typer.Option(help="The same, or FILE.py:NAME of a pam.controller.")],
    of: Annotated[str, typer.Option("--of", help="The output that shall follow.")],
    mean: Annotated[str, typer.Option(help='Of the sine, such as "45 mm".')],
    amplitude: Annotated[str, typer.Option(help='Of the sine, such as "5 mm".')],
    frequencies: Annotated[
        str, typer.Option(help="FROM:TO:N [Hz], evenly in the logarithm, or A,B,C.")
    ] = "0.1:2:6",
    rate: Annotated[
        float, typer.Option(help="Samples [Hz] of a controller that is an FMU.", min=0.0)
    ] = 80.0,
    lead: Annotated[
        float, typer.Option(help="Time [s] to come to the mean before the sine begins.")
    ] = 4.0,
    periods: Annotated[int, typer.Option(help="Of the sine; the last one counts.")] = 4,
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", help="plant.NAME=VALUE or control.NAME=VALUE, with a unit."),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the errors as CSV.")
    ] = None,
    json: JsonOption = None,
    plot: Annotated[Path | None, typer.Option(help="Draw errors and courses as PNG.")] = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """How closely a controlled output follows a sine, by its frequency."""
    file, _, name = controller.rpartition(":")
    made: str | Callable[[], Controller] = controller
    if file.endswith(".py"):
        made = partial(controller_from, Path(file), name)
    check_results(
        json=json,
        tables=[output],
        pictures=[plot],
        sources=[plant, file or controller, *(files or [])],
    )
    chosen = parse_frequencies(frequencies)
    columns = (TextColumn("tracking"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console, disable=not console.is_terminal) as progress:
        task = progress.add_task("tracking", total=len(chosen))
        tracked = tracking.track(
            plant,
            made,
            dict(parse_pairs(settings or [])),
            output=of,
            mean=mean,
            amplitude=amplitude,
            rate=rate,
            frequencies=chosen,
            lead=lead,
            periods=periods,
            files=files or [],
            timeout=timeout,
            progress=lambda done, total: progress.update(task, completed=done, total=total),
        )
    tell_and_write(tracked, output, json, plot)
