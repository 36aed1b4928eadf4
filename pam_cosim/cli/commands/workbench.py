"""The command ``workbench``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim.cli.commands.common import FilesOption, ModelOption
from pam_cosim.libraries import library


def workbench(
    data: Annotated[
        Path,
        typer.Argument(help="Folder of a data set, or of one to be made by dropping CSV files."),
    ],
    model: ModelOption = None,
    port: Annotated[
        int, typer.Option(help="Of the page; default: a free one.", min=0, max=65535)
    ] = 0,
    browser: Annotated[bool, typer.Option(help="Whether to open the page in the browser.")] = True,
    files: FilesOption = None,
) -> None:
    """Open a study in the browser: drag parameters, fit, diagnose, add, and see the error fall."""
    library("pam_cosim.workbench.server").serve(
        data,
        model=model,
        files=files or [],
        port=port,
        browser=browser,
        tell=lambda line: typer.echo(line, err=True),
    )
