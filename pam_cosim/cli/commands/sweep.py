"""The command ``sweep``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.cli.arguments import (
    parse_named,
    parse_pairs,
    parse_varied,
)
from pam_cosim.cli.commands.common import (
    FilesOption,
    InputOption,
    KeepOption,
    ModelArgument,
    SetOption,
    TimeoutOption,
    WidthOption,
    check_results,
    progress_bar,
    remarks,
    say_written,
)
from pam_cosim.exports import check_table_ending
from pam_cosim.files import check_writable
from pam_cosim.sweeps import DESIGNS, FUNCTIONS, Sweep, partial_of
from pam_cosim.sweeps.patterns import INPUTS
from pam_cosim.wording import look_first

_MOST_FAILURES = 20  # that are reported one by one


def sweep(
    model: ModelArgument,
    vary: Annotated[
        list[str],
        typer.Option(
            "--vary",
            help="NAME=FROM:TO:N or NAME=A,B,C: a parameter, input or start value; FROM:TO for random designs; "
            "inputs=A.csv,B.csv: inputs over time, of files or of formulas as for --input.",
        ),
    ],
    output: Annotated[
        Path,
        typer.Option(
            "--output", "-o", metavar="FILE", help="Write the result: CSV, .nc (NetCDF), .parquet."
        ),
    ],
    settings: SetOption = None,
    inputs: InputOption = None,
    keep: KeepOption = None,
    scalars: Annotated[
        list[str] | None,
        typer.Option(
            "--scalar",
            help=f"FUNCTION(VARIABLE) or NAME=FUNCTION(VARIABLE): {', '.join(FUNCTIONS)}; 'time_to(p, 90 %)'.",
        ),
    ] = None,
    trajectories: Annotated[
        bool | None,
        typer.Option(help="Keep values over time; default: where there are no scalars."),
    ] = None,
    design: Annotated[str, typer.Option(help=", ".join(DESIGNS))] = "grid",
    runs: Annotated[
        int | None, typer.Option(help="How many, of random and latin-hypercube.")
    ] = None,
    seed: Annotated[int, typer.Option(help="Of random and latin-hypercube.")] = 0,
    stop_time: Annotated[
        str | None, typer.Option(help="End of each run, such as 20 or '2 min'; in s.")
    ] = None,
    interval: Annotated[
        str | None, typer.Option(help="Time between two values that are kept, such as '1 ms'.")
    ] = None,
    plot: Annotated[Path | None, typer.Option(help="Draw the scalars over what is varied.")] = None,
    width: WidthOption = None,
    workers: Annotated[
        int | None,
        typer.Option(
            help="Processes; default: as many as it pays to start; 1: this process alone."
        ),
    ] = None,
    dask: Annotated[
        str | None, typer.Option(help="Address of a Dask scheduler that makes the runs.")
    ] = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """Many runs: every combination of what is varied, a list, or random points.

    A sweep that was stopped continues with the same command.
    """
    varied = parse_varied(vary)
    check_results(
        output, pictures=[plot], sources=[model, inputs, *varied.get(INPUTS, [])], files=files
    )
    check_table_ending(output)
    check_writable(partial_of(output))
    remarks.append(lambda: _kept(output))
    with progress_bar("sweep", "MofNComplete", "TimeElapsed", "TimeRemaining") as progress:
        completed_sweep = study.sweep(
            model,
            varied,
            parameters=parse_pairs(settings),
            inputs=inputs,
            outputs=keep or [],
            scalars=parse_named(scalars or []),
            trajectories=trajectories,
            design=design,
            runs=runs,
            seed=seed,
            stop_time=stop_time,
            interval=interval,
            output=output,
            executor=dask,
            workers=workers,
            files=files or [],
            timeout=timeout,
            progress=progress,
        )
    if plot:
        study.draw(completed_sweep, plot, width)
    _tell(completed_sweep)
    say_written(output, plot)
    if len(completed_sweep.failed) == len(completed_sweep):
        raise typer.Exit(1)


def _kept(output: Path) -> str:
    file = partial_of(output)
    return (
        f"the finished runs are kept in {file}: the same command continues" if file.exists() else ""
    )


def _tell(completed_sweep: Sweep) -> None:
    failed = completed_sweep.failed
    for run, reason in list(failed.items())[:_MOST_FAILURES]:
        typer.echo(f"failed at {completed_sweep.design.settings(run)}: {reason}", err=True)
    if len(failed) > _MOST_FAILURES:
        typer.echo(
            f"and {len(failed) - _MOST_FAILURES} more; the result names the reason of each",
            err=True,
        )
    typer.echo(f"{len(completed_sweep) - len(failed)} of {len(completed_sweep)} runs done")
    for line in [*look_first(completed_sweep.warnings), *completed_sweep.summary_lines()]:
        typer.echo(line)
