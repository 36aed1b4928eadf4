"""The command ``fit``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.commands.common import (
    Data,
    FilesOption,
    JsonOption,
    ModelOption,
    TimeoutOption,
    check_results,
    console,
    read_data,
    say_written,
)
from pam_cosim.files import write_json
from pam_cosim.fitting import METHODS, FitOptions, summary, write_parameters


def fit(
    data: Data,
    model: ModelOption = None,
    method: Annotated[
        str, typer.Option(help="How to search. " + "; ".join(f"{name}: {summary(name)}" for name in METHODS) + ".")
    ] = FitOptions.method,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the parameters (.json, .ssv).")] = None,
    json: JsonOption = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """Fit the parameters that the data set leaves free."""
    check_results(output, json, sources=[model, *(files or [])])
    read = read_data(data, model, files)
    with console.status("fitting") as status:
        found = study.fit(
            read,
            model,
            method=method,
            files=files or [],
            timeout=timeout,
            progress=lambda n, chi2: status.update(f"fitting: {n} simulations, chi2 {chi2:.4g}"),
        )
    typer.echo(str(found))
    if output:
        write_parameters(output, found)
    if json:
        write_json(json, found.as_dict())
    say_written(output)
    say_written(json)
