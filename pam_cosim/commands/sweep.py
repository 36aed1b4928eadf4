"""The command ``sweep``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from pam_cosim import study
from pam_cosim.arguments import parse_settings, parse_variations, read_inputs
from pam_cosim.commands.common import (
    FilesOption,
    SetOption,
    TimeoutOption,
    check_results,
    console,
    say_written,
)
from pam_cosim.tables import write_sweep


def sweep(
    model: Annotated[str, typer.Argument(help="A bench, a Modelica class, a .mo or an .fmu file.")],
    vary: Annotated[list[str], typer.Option("--vary", help="NAME=FROM:TO:N or NAME=A,B,C: a parameter, or an input.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="Write all trajectories as one CSV.")],
    settings: SetOption = None,
    inputs: Annotated[Path | None, typer.Option("--input", help="CSV with input columns: name [unit].")] = None,
    stop_time: Annotated[float | None, typer.Option(help="End of each run [s].")] = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """Every combination of varied parameters and inputs."""
    check_results(output, sources=[model, inputs, *(files or [])])
    interface = study.describe(model, files or [])
    variations = parse_variations(vary, interface)
    parameters = parse_settings(settings or [], interface)
    course = read_inputs(inputs, interface) if inputs else None
    columns = (TextColumn("sweep"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console, disable=not console.is_terminal) as progress:
        task = progress.add_task("sweep", total=None)
        points = study.sweep(
            model,
            variations,
            parameters=parameters,
            inputs=course,
            stop_time=stop_time,
            files=files or [],
            timeout=timeout,
            progress=lambda done, total: progress.update(task, completed=done, total=total),
        )
    write_sweep(output, points, interface)
    failed = [p for p in points if p.failure]
    for p in failed:
        console.print(f"failed at {p.parameters}: {p.failure}", markup=False, soft_wrap=True)
    typer.echo(f"{len(points) - len(failed)} of {len(points)} runs done")
    say_written(output)
