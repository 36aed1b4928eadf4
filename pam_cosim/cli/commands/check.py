"""The command ``check``."""

from __future__ import annotations

import typer

from pam_cosim import study
from pam_cosim.cli.commands.common import (
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
from pam_cosim.files import write_json


def check(
    data: Data,
    model: ModelOption = None,
    json: JsonOption = None,
    settings: SetOption = None,
    params: ParamsOption = None,
    free: FreeOption = None,
    roles: RoleOption = None,
    cuts: CutOption = None,
    begins: BeginOption = None,
    values: ValuesOption = False,
    files: FilesOption = None,
    workers: WorkersOption = None,
) -> None:
    """What a measurement can and cannot determine, before any fit, and what to measure next."""
    check_results(json=json, sources=[model], files=files)
    read = read_data(data, model, files, roles, cuts, begins)
    problem = problem_of(read, model, files, settings, free, None, params, values)
    with console().status("simulating what could be measured") as status:
        checked = study.check(
            problem, say=teller(status), progress=follower(status), workers=workers
        )
    typer.echo(str(checked))
    if json:
        write_json(json, checked.as_dict())
    say_written(json)
