"""The command ``fit``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import reporting, study
from pam_cosim.cli.commands.common import (
    PARAMETERS,
    PROGRESS,
    BeginOption,
    CutOption,
    Data,
    FilesOption,
    FreeOption,
    JsonOption,
    ModelOption,
    ParamsOption,
    RoleOption,
    SetOption,
    StartOption,
    TimeoutOption,
    ValuesOption,
    WidthOption,
    check_results,
    console,
    problem_of,
    read_data,
    say_written,
)
from pam_cosim.files import check_ending, write_json
from pam_cosim.fitting import METHODS, FitOptions, check_parameter_file, summary, write_parameters


def fit(
    data: Data,
    model: ModelOption = None,
    method: Annotated[
        str,
        typer.Option(
            help="How to search. " + "; ".join(f"{name}: {summary(name)}" for name in METHODS) + "."
        ),
    ] = FitOptions.method,
    starts: Annotated[
        int,
        typer.Option(
            help="Points spread over the bounds for multi-start, each followed to its end."
        ),
    ] = 0,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the parameters (.json, .ssv).")
    ] = None,
    json: JsonOption = None,
    plot: Annotated[
        Path | None,
        typer.Option(help="Draw how the fit came down, where descents ended, and correlations."),
    ] = None,
    width: WidthOption = None,
    profile: Annotated[
        Path | None,
        typer.Option(help="Find how well each parameter is determined, and draw the profiles."),
    ] = None,
    resume: Annotated[
        Path | None,
        typer.Option(
            help="Keep every simulation in this file; the same command continues an interrupted fit."
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
    timeout: TimeoutOption = None,
) -> None:
    """Fit the parameters that the data set leaves free."""
    if output:
        check_parameter_file(output)
        check_ending(output, "parameters are written as JSON or SSV", PARAMETERS)
    if resume:
        check_ending(resume, "the simulations are kept in a format of their own", PROGRESS)
    check_results(output, resume, json=json, pictures=[plot, profile], sources=[model], files=files)
    read = read_data(data, model, files, roles, cuts, begins)
    problem = problem_of(read, model, files, settings, free, start, params, values)
    with console().status("fitting") as status:
        fitted = study.fit(
            problem,
            method=method,
            starts=starts,
            timeout=timeout,
            progress=lambda standing: status.update(f"fitting: {standing}"),
            resume=resume,
        )
        profiles = None
        if profile:
            profiles = study.profile(
                problem,
                fitted,
                timeout=timeout,
                progress=lambda standing: status.update(
                    f"profiles: {standing.evaluations} simulations"
                ),
            )
    typer.echo(str(fitted))
    if profiles:
        typer.echo(f"How well these data determine each parameter:\n{profiles}")
    if output:
        write_parameters(output, fitted)
    if json:
        write_json(json, fitted.as_dict() | ({"profiles": profiles.as_dict()} if profiles else {}))
    if plot:
        reporting.plot_fit(fitted, plot, width)
    if profile and profiles:
        study.draw(profiles, profile, width)
    say_written(output, json, plot, profile, resume)
