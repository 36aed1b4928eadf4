"""The command ``build``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.cli.arguments import fmu_files
from pam_cosim.cli.commands.common import (
    FilesOption,
    check_results,
)
from pam_cosim.errors import InputError


def build(
    models: Annotated[
        list[str] | None, typer.Argument(help="Models to build; default: every bench.")
    ] = None,
    files: FilesOption = None,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder for the FMUs, or NAME.fmu for one.")
    ] = Path("fmu/build"),
    platforms: Annotated[
        list[str] | None, typer.Option("--platform", help="native, all, or x86_64-windows ...")
    ] = None,
    fmi: Annotated[
        str, typer.Option("--fmi", help="Version of the interface: 2.0 or 3.0.")
    ] = "2.0",
    sensitivities: Annotated[
        list[str] | None,
        typer.Option(
            "--sensitivity", help="A parameter; the outputs' derivatives by it become outputs too."
        ),
    ] = None,
    with_data: Annotated[
        Path | None,
        typer.Option(
            "--with-data", help="A data set that goes into the FMU, and that it is judged by."
        ),
    ] = None,
    fit: Annotated[
        Path | None, typer.Option("--fit", help="With --with-data: fitted values, of 'fit -o'.")
    ] = None,
    diagnosis: Annotated[
        Path | None,
        typer.Option(
            "--diagnosis", help="With --with-data: effects and verdict, of 'diagnose --save'."
        ),
    ] = None,
) -> None:
    """Modelica to FMU."""
    if with_data is not None:
        return _with_data(
            with_data, models or [], output, fit, diagnosis, files or [], platforms, fmi
        )
    if fit or diagnosis:
        raise InputError(
            "--fit and --diagnosis go into an FMU together with the recordings: name them by --with-data"
        )
    targets = fmu_files(models or study.benches(), output)
    check_results(
        *(target for _, target in targets),
        sources=[*(models or []), *(files or [])],
        new_folder=True,
    )
    for model, target in targets:
        made = study.build(
            model,
            target,
            files=files or [],
            platforms=platforms or ["native"],
            fmi=fmi,
            sensitivities=sensitivities or [],
        )
        typer.echo(made)


def _with_data(
    data: Path,
    models: Sequence[str],
    output: Path,
    fit: Path | None,
    diagnosis: Path | None,
    files: Sequence[Path],
    platforms: Sequence[str] | None,
    fmi: str,
) -> None:
    """One FMU with the recordings that it was judged by."""
    if len(models) > 1 or output.suffix.lower() != ".fmu":
        raise InputError(
            "recordings go into one FMU: name it with -o NAME.fmu, and one model at most"
        )
    check_results(
        output, sources=[data, *models, *files, *filter(None, (fit, diagnosis))], new_folder=True
    )
    made = study.build_with_data(
        data,
        output,
        model=models[0] if models else None,
        fit=fit,
        diagnosis=diagnosis,
        files=files,
        platforms=platforms or ["native"],
        fmi=fmi,
    )
    typer.echo(made)
