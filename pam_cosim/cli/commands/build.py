"""The command ``build``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.cli.arguments import fmu_files
from pam_cosim.cli.commands.common import FilesOption, check_results


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
) -> None:
    """Modelica to FMU."""
    targets = fmu_files(models or study.benches(), output)
    check_results(
        *(target for _, target in targets),
        sources=models or [],
        files=files,
        new_folder=True,
    )
    for model, target in targets:
        fmu = study.build(
            model,
            target,
            files=files or [],
            platforms=platforms or ["native"],
            fmi=fmi,
            sensitivities=sensitivities or [],
        )
        typer.echo(fmu)
