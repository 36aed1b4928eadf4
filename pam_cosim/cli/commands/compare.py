"""The command ``compare``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import reporting, study
from pam_cosim.cli.commands.common import (
    BeginOption,
    CutOption,
    Data,
    FilesOption,
    JsonOption,
    ModelOption,
    ParamsOption,
    ReportOption,
    RoleOption,
    SetOption,
    TimeoutOption,
    ValuesOption,
    WidthOption,
    check_results,
    problem_of,
    read_data,
    say_written,
)
from pam_cosim.comparison import Comparison, ConditionTable, check_conditions, write_tables
from pam_cosim.errors import InputError
from pam_cosim.files import write_json
from pam_cosim.measurement import Run
from pam_cosim.problems import Problem
from pam_cosim.study.tables import against_lines, read_comparison
from pam_cosim.wording import listed


def compare(
    data: Data,
    model: ModelOption = None,
    params: ParamsOption = None,
    against: Annotated[
        list[Path] | None, typer.Option(help="Earlier 'compare --json' results.")
    ] = None,
    table: Annotated[
        tuple[str, str] | None,
        typer.Option(
            help="Scores by two parameters of the runs, such as load.m frequency.",
            metavar="ROWS COLUMNS",
        ),
    ] = None,
    table_csv: Annotated[
        Path | None, typer.Option(help="Write that table as CSV, SI units.")
    ] = None,
    table_plot: Annotated[Path | None, typer.Option(help="Draw that table.")] = None,
    width: WidthOption = None,
    json: JsonOption = None,
    report: ReportOption = None,
    settings: SetOption = None,
    roles: RoleOption = None,
    cuts: CutOption = None,
    begins: BeginOption = None,
    values: ValuesOption = False,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """How far a model is from a measurement, and where."""
    if table is None and (table_csv or table_plot):
        raise InputError(
            "--table-csv and --table-plot need --table ROWS COLUMNS, two parameters of the runs"
        )
    files, against = files or [], against or []
    sources = [data, model, params, *against, *files]
    check_results(
        json=json, report=report, tables=[table_csv], pictures=[table_plot], sources=sources
    )
    earlier = [(path.stem, read_comparison(path)) for path in against]
    read = read_data(data, model, files, roles, cuts, begins)
    problem = problem_of(read, model, files, settings, params=params, values=values)
    comparison = _compared(problem, table, timeout, _notes(read.runs))
    for line in against_lines(comparison, earlier):
        typer.echo(line)
    tables = _tables(comparison, table) if table else []
    _write(comparison, tables, json, report)
    _write_tables(tables, table_csv, table_plot, width)


def _tables(comparison: Comparison, parameters: tuple[str, str]) -> list[ConditionTable]:
    """The scores of every signal by two parameters of the runs, printed."""
    tables = [comparison.table(*parameters, signal) for signal in comparison.scores["all"]]
    for table in tables:
        typer.echo(f"\n{table}")
    return tables


def _write(
    comparison: Comparison, tables: Sequence[ConditionTable], json: Path | None, report: Path | None
) -> None:
    if json:
        extra_content = {"tables": [table.as_dict() for table in tables]} if tables else {}
        write_json(json, comparison.as_dict() | extra_content)
    if report:
        reporting.write_report(report, reporting.comparison_report(comparison))
    say_written(json, report)


def _write_tables(
    tables: Sequence[ConditionTable], csv: Path | None, picture: Path | None, width: str | None
) -> None:
    if csv:
        write_tables(csv, tables)
    if picture:
        reporting.plot_tables(tables, picture, width)
    say_written(csv, picture)


def _compared(
    problem: Problem,
    table: tuple[str, str] | None,
    timeout: float | None,
    notes: Sequence[str],
) -> Comparison:
    """The comparison, printed with what a reader should know of how the files were read."""
    if table:
        check_conditions(problem.data.runs, *table, problem.settings)
    comparison = study.compare(problem, timeout=timeout)
    typer.echo(str(comparison))
    for note in notes:
        typer.echo(f"  note: {note}")
    return comparison


def _notes(runs: Sequence[Run]) -> list[str]:
    """What is to be known of how files were read, each once, with the runs that it is of."""
    of: dict[str, list[str]] = {}
    for run in runs:
        for note in run.notes:
            of.setdefault(note, []).append(run.name)
    return [f"{listed(dict.fromkeys(names))}: {note}" for note, names in of.items()]
