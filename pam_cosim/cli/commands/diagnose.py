"""The command ``diagnose``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from shlex import quote
from typing import Annotated

import typer

from pam_cosim import reporting, study
from pam_cosim.cli.commands.common import (
    BeginOption,
    CutOption,
    Data,
    FilesOption,
    FreeOption,
    JsonOption,
    ModelOption,
    ParamsOption,
    ReportOption,
    RoleOption,
    SetOption,
    StartOption,
    ValuesOption,
    WorkersOption,
    check_results,
    console,
    follower,
    problem_of,
    read_data,
    say_written,
    teller,
)
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.files import check_model_file, write_json, write_text
from pam_cosim.study import products
from pam_cosim.study.tables import write_next_run, write_planned_runs


def diagnose(
    data: Data,
    model: ModelOption = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            help="Write the model with its effects and fitted values as Modelica (.mo).",
        ),
    ] = None,
    save: Annotated[
        Path | None,
        typer.Option(help="Save the diagnosis with its samples (.npz); pam.load reads the file."),
    ] = None,
    json: JsonOption = None,
    report: ReportOption = None,
    following: Annotated[
        Path | None,
        typer.Option(
            "--next", help="Write the next experiment's inputs as CSV, if there is one to make."
        ),
    ] = None,
    learned: Annotated[
        Path | None,
        typer.Option(
            "--learned", help="Write the formula for the unexplained residual as Modelica."
        ),
    ] = None,
    settings: SetOption = None,
    params: ParamsOption = None,
    free: FreeOption = None,
    start: StartOption = None,
    roles: RoleOption = None,
    cuts: CutOption = None,
    begins: BeginOption = None,
    values: ValuesOption = False,
    files: FilesOption = None,
    workers: WorkersOption = None,
    dask: Annotated[
        str | None, typer.Option(help="Address of a Dask scheduler that fits the models.")
    ] = None,
    time_limit: Annotated[
        str | None,
        typer.Option(help="End the search after so long ('30 s') with the best verdict so far."),
    ] = None,
    simulation_limit: Annotated[
        int | None,
        typer.Option(help="The same after so many simulated runs: equal on every machine."),
    ] = None,
    exclude: Annotated[
        list[str] | None,
        typer.Option(
            help="A family or an effect that is known not to be missing; may be repeated."
        ),
    ] = None,
    expect: Annotated[
        list[str] | None, typer.Option(help="One that is likely to be missing; may be repeated.")
    ] = None,
) -> None:
    """Find the physical effect that the model lacks."""
    files = files or []
    _check_endings(output, learned, save)
    check_results(
        output,
        save,
        learned,
        json=json,
        report=report,
        tables=[following],
        sources=[model, *files],
    )
    read = read_data(data, model, files, roles, cuts, begins)
    problem = problem_of(read, model, files, settings, free, start, params, values)
    with console().status("refitting the base model") as status:
        say = teller(status)
        diagnosis = study.diagnose(
            problem,
            say=say,
            progress=follower(status),
            workers=workers,
            executor=dask,
            time_limit=time_limit,
            simulation_limit=simulation_limit,
            exclude=exclude or [],
            expect=expect or [],
        )
    typer.echo(reporting.diagnosis_text(diagnosis))
    if output:
        study.add(diagnosis, output=output, files=files)
    if save:
        products.save(diagnosis, save)
    if json:
        write_json(json, diagnosis.as_dict())
    if report:
        reporting.write_report(report, reporting.diagnosis_report(diagnosis))
    if output:
        _say_model(diagnosis, data, save, output, files)
    say_written(save, json, report)
    _write_next(diagnosis, following, files)
    _write_learned(diagnosis, learned)


def _check_endings(output: Path | None, learned: Path | None, save: Path | None) -> None:
    """Models are written as Modelica, and a diagnosis is saved as arrays."""
    for path in (output, learned):
        if path is not None:
            check_model_file(path)
    if save is not None and save.suffix != ".npz":
        raise InputError("a diagnosis is saved as .npz: name a file that ends so", save)


def _say_model(
    diagnosis: Diagnosis, data: Path, save: Path | None, output: Path, files: Sequence[Path]
) -> None:
    """Names the model that was written, and the command that shows its errors."""
    say_written(output)
    changes = diagnosis.changes_of_data
    if changes and save is not None:
        data, changes = save, ()
    file_options = "".join(f" --file {quote(str(file))}" for file in files)
    lines = [
        f"compare it: pam-cosim compare {quote(str(data))} --model {quote(str(output))}{file_options}",
        *(f"  the verdict's numbers differ: {change}" for change in changes),
    ]
    if changes:
        lines.append("  --save FILE.npz keeps these samples, and compare reads that file")
    typer.echo("\n".join(lines))


def _write_next(diagnosis: Diagnosis, following: Path | None, files: Sequence[Path]) -> None:
    """The run that decides between the models that are left, as a file, where there is one to make."""
    if following is None:
        return
    why = f"the verdict is {diagnosis.verdict.kind}"
    over_time = not any(run.is_static for run in diagnosis.data.runs)
    leaves_rivals = len(diagnosis.rival_models) > 1
    if over_time and (leaves_rivals or diagnosis.verdict.kind in ("identified", "none_missing")):
        try:
            planned = study.plan(diagnosis, files=files)
        except (InputError, SimulationFailure) as error:
            if leaves_rivals:
                raise
            why = str(error)
        else:
            typer.echo(str(planned))
            write_planned_runs(following, planned)
            say_written(following)
            return
    elif diagnosis.next_experiment is not None:
        write_next_run(following, diagnosis.next_experiment)
        say_written(following)
        return
    typer.echo(f"no next experiment: {why}; {following} is not written")


def _write_learned(diagnosis: Diagnosis, learned: Path | None) -> None:
    """The formula for what no effect explains, as a file, where there is one."""
    if learned is None:
        return
    if diagnosis.learned is None:
        typer.echo(
            f"no term was learned: the verdict is {diagnosis.verdict.kind}; {learned} is not written"
        )
    else:
        write_text(learned, diagnosis.learned.term.modelica_source)
        say_written(learned)
