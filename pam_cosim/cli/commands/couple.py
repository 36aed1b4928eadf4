"""The command ``couple``."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Annotated, Any, TypeVar

import typer

from pam_cosim import reporting
from pam_cosim.cli.arguments import parse_pairs
from pam_cosim.cli.commands.common import (
    FilesOption,
    KeepOption,
    SetOption,
    TimeoutOption,
    WidthOption,
    check_results,
    progress_bar,
    say_written,
)
from pam_cosim.cosimulation import Controller, ControllerError, CoupledRun, CouplingFailure
from pam_cosim.cosimulation.python_file import controller_from
from pam_cosim.errors import InputError
from pam_cosim.study import coupling
from pam_cosim.study.input_sources import read_inputs
from pam_cosim.units import format_quantity
from pam_cosim.wording import look_first

Value = TypeVar("Value")
_ADAPTIVE = 1e-3  # relative error of a step, unless another is stated


def couple(
    system: Annotated[
        Path,
        typer.Argument(help="SYSTEM.toml as a person writes it, or SYSTEM.ssp of SSP 1.0 or 2.0."),
    ],
    method: Annotated[str, typer.Option(help="jacobi or gauss-seidel.")] = "gauss-seidel",
    step: Annotated[
        str | None, typer.Option(help='Between communication points, such as "1 ms".')
    ] = None,
    adaptive: Annotated[
        bool, typer.Option("--adaptive", help="Choose steps by their error.")
    ] = False,
    tolerance: Annotated[
        float | None, typer.Option(help="Relative error of a step; means --adaptive.")
    ] = None,
    extrapolation: Annotated[
        str, typer.Option(help="Of an output over a step: constant or linear.")
    ] = "linear",
    loops: Annotated[
        str, typer.Option(help="Algebraic loops: refuse, iterate, or delay.")
    ] = "refuse",
    stop_time: Annotated[str | None, typer.Option(help='End of the run, such as "2 s".')] = None,
    settings: SetOption = None,
    inputs: Annotated[
        Path | None, typer.Option("--input", help="CSV with columns: component.input [unit].")
    ] = None,
    controllers: Annotated[
        list[str] | None,
        typer.Option(
            "--controller", help="NAME=FILE.py:FUNCTION: a pam.controller as a component."
        ),
    ] = None,
    samples: Annotated[
        list[str] | None,
        typer.Option(
            "--sample", help='NAME="10 ms": an FMU that acts at samples, as a controller.'
        ),
    ] = None,
    keep: KeepOption = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the trajectory as CSV.")
    ] = None,
    plot: Annotated[Path | None, typer.Option(help="Draw the trajectory.")] = None,
    width: WidthOption = None,
    ssp: Annotated[Path | None, typer.Option(help="Write the system as an SSP archive.")] = None,
    ssp_version: Annotated[
        str | None,
        typer.Option("--ssp-version", help="Of that archive: 1.0 (the default) or 2.0."),
    ] = None,
    no_connectors: Annotated[
        bool,
        typer.Option(
            "--no-ssp-connectors",
            help="That system has no connectors, as libcosim and ecos need it.",
        ),
    ] = False,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """Several FMUs, coupled."""
    if ssp_version is not None and ssp is None:
        raise InputError("--ssp-version needs --ssp FILE")
    files, controllers = files or [], controllers or []
    check_results(
        ssp,
        tables=[output],
        pictures=[plot],
        sources=[system, inputs, *files, *_files_of(controllers)],
    )
    controllers_by_name = _by_name("--controller", map(_controller, controllers))
    acting = _by_name("--sample", map(_sample, samples or []))
    read = coupling.read_system(system, controllers_by_name, files=files, timeout=timeout)
    read = read.having(parse_pairs(settings)).sampling(acting)
    input_series = read_inputs(inputs, read.interface) if inputs else None
    options: dict[str, Any] = {"method": method, "extrapolation": extrapolation, "loops": loops}
    if ssp:
        coupling.write_system(read, ssp, ssp=ssp_version or "1.0", connectors=not no_connectors)
        say_written(ssp)
    with progress_bar("coupling", "TimeElapsed", "TimeRemaining") as progress:
        try:
            run = read.simulate(
                stop_time,
                step=step,
                tolerance=_ADAPTIVE if adaptive and tolerance is None else tolerance,
                inputs=input_series,
                outputs=keep or [],
                progress=progress,
                **options,
            )
        except (CouplingFailure, ControllerError) as error:
            if error.run is not None:
                _write(error.run, output, plot, width)
            raise
    _write(run, output, plot, width)
    _tell(run)


def _tell(run: CoupledRun) -> None:
    """A line for each variable: between which values it lies, and where it ends."""
    for line in look_first(run.trajectory.warnings):
        typer.echo(line.strip())
    for name, values in run.trajectory.values.items():
        unit = run.trajectory.units[name]
        low, high, last = (
            format_quantity(float(v), unit) for v in (values.min(), values.max(), values[-1])
        )
        typer.echo(f"{name}: from {low} to {high}, at the end {last}")
    typer.echo(str(run))


def _write(run: CoupledRun, output: Path | None, plot: Path | None, width: str | None) -> None:
    """What was reached, also where it is not the end."""
    if output:
        run.trajectory.to_csv(output)
    if plot and run.trajectory.time.size > 1:
        reporting.draw(run.trajectory, plot, width)
    say_written(output, plot)


def _by_name(option: str, pairs: Iterable[tuple[str, Value]]) -> dict[str, Value]:
    named: dict[str, Value] = {}
    for name, value in pairs:
        if name in named:
            raise InputError(f"{option}: '{name}' is given twice")
        named[name] = value
    return named


def _sample(word: str) -> tuple[str, str]:
    name, equals, interval = word.partition("=")
    if not name or not equals or not interval:
        raise InputError(f"'{word}': write NAME=TIME, such as NAME='10 ms'")
    return name, interval


def _controller(word: str) -> tuple[str, Controller]:
    name, file, function = _split(word)
    return name, controller_from(Path(file), function)


def _split(word: str) -> tuple[str, str, str]:
    name, _, place = word.partition("=")
    file, _, function = place.rpartition(":")
    if not name or not file or not function:
        raise InputError(f"'{word}': write NAME=FILE.py:FUNCTION")
    return name, file, function


def _files_of(words: list[str]) -> list[Path]:
    return [Path(_split(word)[1]) for word in words]
