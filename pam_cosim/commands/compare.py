"""The command ``compare``."""

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
    ReportOption,
    TimeoutOption,
    check_results,
    read_data,
    say_written,
)
from pam_cosim.comparison import Comparison
from pam_cosim.files import write_json
from pam_cosim.fitting import read_parameters
from pam_cosim.reporting import comparison_report, write_report
from pam_cosim.tables import against_lines, read_comparison


def compare(
    data: Data,
    model: ModelOption = None,
    params: Annotated[Path | None, typer.Option(help="Fitted parameters, from 'fit -o'.")] = None,
    against: Annotated[list[Path] | None, typer.Option(help="Earlier 'compare --json' results.")] = None,
    json: JsonOption = None,
    report: ReportOption = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """How far a model is from a measurement, and where."""
    check_results(json, report, sources=[model, params, *(against or []), *(files or [])])
    values = read_parameters(params) if params else {}
    earlier = [(path.stem, read_comparison(path)) for path in against or []]
    read = read_data(data, model, files)
    found: Comparison = study.compare(read, model, values, files=files or [], timeout=timeout)
    typer.echo(str(found))
    for line in against_lines(found, earlier):
        typer.echo(line)
    if json:
        write_json(json, found.as_dict())
    if report:
        write_report(report, comparison_report(found))
    say_written(json)
    say_written(report)
