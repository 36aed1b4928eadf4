"""The command ``simulate``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.arguments import parse_settings, read_inputs
from pam_cosim.commands.common import (
    FilesOption,
    SetOption,
    TimeoutOption,
    check_results,
    say_written,
)
from pam_cosim.reporting import plot_trajectory
from pam_cosim.units import format_quantity


def simulate(
    model: Annotated[str, typer.Argument(help="A bench, a Modelica class, a .mo or an .fmu file.")],
    settings: SetOption = None,
    inputs: Annotated[Path | None, typer.Option("--input", help="CSV with input columns: name [unit].")] = None,
    stop_time: Annotated[float | None, typer.Option(help="End of the run [s].")] = None,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the trajectory as CSV.")] = None,
    plot: Annotated[Path | None, typer.Option(help="Draw the outputs as PNG.")] = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """One run of a model."""
    check_results(output, plot, sources=[model, inputs, *(files or [])])
    interface = study.describe(model, files or [])
    parameters = parse_settings(settings or [], interface)
    course = read_inputs(inputs, interface) if inputs else None
    trajectory = study.simulate(model, parameters, course, stop_time=stop_time, files=files or [], timeout=timeout)
    for warning in trajectory.warnings:
        typer.echo(f"pam-cosim: {warning}", err=True)
    if output:
        trajectory.to_csv(output)
    if plot:
        plot_trajectory(trajectory, plot)
    for name, values in trajectory.values.items():
        unit = trajectory.units[name]
        low, high, last = (format_quantity(float(v), unit) for v in (values.min(), values.max(), values[-1]))
        typer.echo(f"{name}: from {low} to {high}, at the end {last}")
    say_written(output)
    say_written(plot)
