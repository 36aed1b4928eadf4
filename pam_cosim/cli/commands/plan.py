"""The command ``plan``."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.cli.arguments import parse_limits
from pam_cosim.cli.commands.common import (
    FilesOption,
    JsonOption,
    ModelOption,
    WidthOption,
    check_results,
    console,
    follower,
    read_data,
    say_written,
    teller,
)
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.files import write_json
from pam_cosim.measurement import DataSet, rig_columns
from pam_cosim.study.plans import run_limits
from pam_cosim.study.tables import planned_files, rig_lines, write_planned_runs


def plan(
    source: Annotated[
        Path,
        typer.Argument(
            metavar="DIAGNOSIS",
            help="What 'diagnose --save' wrote, or a data set to diagnose first.",
        ),
    ],
    limits: Annotated[
        list[str] | None,
        typer.Option(
            "--limit",
            help="NAME=FROM:TO with units, such as u_in='0 A:0.35 A': an input, a known parameter, or a signal that "
            "must stay within; default: what the recordings span. May be repeated.",
        ),
    ] = None,
    hold: Annotated[
        list[str] | None,
        typer.Option(
            help="An input that keeps one value through a run, such as a supply. May be repeated."
        ),
    ] = None,
    seconds: Annotated[
        str | None, typer.Option(help="Length of a run, such as '10 s'; default: as recorded.")
    ] = None,
    runs: Annotated[
        int, typer.Option(help="How many runs to design, one after another.", min=1)
    ] = 1,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", help="Write the inputs as CSV; of a second run to FILE-2.csv."
        ),
    ] = None,
    plot: Annotated[
        Path | None, typer.Option(help="Draw inputs and what each model predicts.")
    ] = None,
    width: WidthOption = None,
    json: JsonOption = None,
    seed: Annotated[int, typer.Option(help="Of the search.", min=0)] = 0,
    model: ModelOption = None,
    files: FilesOption = None,
    workers: Annotated[
        int | None,
        typer.Option(
            help="Processes of the diagnosis; default: all processors; 0: this process alone."
        ),
    ] = None,
) -> None:
    """Design the run that decides between the models which a diagnosis leaves, or tests its verdict."""
    written = planned_files(output, runs) if output else []
    check_results(json=json, tables=written, pictures=[plot], sources=[source, model], files=files)
    ranges = parse_limits(limits or [])
    diagnosis = _diagnosis(
        source,
        model,
        files,
        workers,
        lambda data: run_limits(data, ranges, seconds, files or [], hold or []),
    )
    with console().status("designing the run") as status:
        planned = study.plan(
            diagnosis,
            limits=ranges,
            seconds=seconds,
            hold=hold or [],
            runs=runs,
            files=files or [],
            seed=seed,
            say=teller(status),
        )
    interface = study.describe(diagnosis.model, files or [])
    columns = rig_columns(diagnosis.data.folder, interface, [*planned.runs[0].table])
    typer.echo("\n".join([str(planned), *rig_lines(planned, columns)]))
    if output:
        write_planned_runs(output, planned, columns)
    if plot:
        study.draw(planned, plot, width)
    if json:
        write_json(json, planned.as_dict())
    say_written(*written, plot, json)


def _diagnosis(
    source: Path,
    model: str | None,
    files: list[Path] | None,
    workers: int | None,
    check: Callable[[DataSet], object],
) -> Diagnosis:
    """The saved diagnosis, or that of a data set, which takes its time: what is wrong is found before."""
    if source.suffix.lower() == ".npz":
        loaded = study.load(source)
        if not isinstance(loaded, Diagnosis):
            raise InputError(
                f"a {type(loaded).__name__} has no competing models: name a file of 'diagnose --save'",
                source,
            )
        return loaded
    data = read_data(source, model, files)
    check(data)
    with console().status("refitting the base model") as status:
        return study.diagnose(
            data,
            model,
            files=files or [],
            say=teller(status),
            progress=follower(status),
            workers=workers,
            explain=False,
        )
