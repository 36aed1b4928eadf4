"""The command ``compare``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from shlex import quote
from typing import Annotated

import typer

from pam_cosim import reporting, study
from pam_cosim.cli.arguments import parse_pairs
from pam_cosim.cli.commands.common import (
    BeginOption,
    CutOption,
    Data,
    FilesOption,
    JsonOption,
    ModelOption,
    ReportOption,
    RoleOption,
    SetOption,
    TimeoutOption,
    check_results,
    console,
    read_data,
    say_written,
)
from pam_cosim.comparison import Comparison, ConditionTable, check_conditions, write_tables
from pam_cosim.compiler import names
from pam_cosim.errors import InputError
from pam_cosim.files import write_json
from pam_cosim.measurement import DataSet, Run
from pam_cosim.study.fitted_model import FittedModel, check_fitted, read_fitted_model
from pam_cosim.study.tables import against_lines, read_comparison
from pam_cosim.wording import listed


def compare(
    data: Data,
    model: ModelOption = None,
    params: Annotated[
        Path | None,
        typer.Option(help="Fitted parameters: of 'fit -o', 'diagnose --json', or a saved product."),
    ] = None,
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
    table_plot: Annotated[Path | None, typer.Option(help="Draw that table as PNG.")] = None,
    json: JsonOption = None,
    report: ReportOption = None,
    settings: SetOption = None,
    roles: RoleOption = None,
    cuts: CutOption = None,
    begins: BeginOption = None,
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
    fitted = _fitted(params, model) if params else FittedModel("", (), {})
    chosen = parse_pairs(settings or [])
    earlier = [(path.stem, read_comparison(path)) for path in against]
    read = read_data(data, model, files, roles, cuts, begins)
    if params:
        _check_fitted(fitted, params, read, model, files)
    comparison = _compared(read, model, fitted.values, chosen, table, files, timeout)
    for line in against_lines(comparison, earlier):
        typer.echo(line)
    tables = _tables(comparison, table) if table else []
    _write(comparison, tables, json, report)
    _write_tables(tables, table_csv, table_plot)


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
        further = {"tables": [one.as_dict() for one in tables]} if tables else {}
        write_json(json, comparison.as_dict() | further)
    if report:
        reporting.write_report(report, reporting.comparison_report(comparison))
    say_written(json)
    say_written(report)


def _write_tables(tables: Sequence[ConditionTable], csv: Path | None, picture: Path | None) -> None:
    if csv:
        write_tables(csv, tables)
    if picture:
        reporting.plot_tables(tables, picture)
    say_written(csv)
    say_written(picture)


def _compared(
    data: DataSet,
    model: str | None,
    fitted: Mapping[str, float],
    chosen: Mapping[str, str],
    table: tuple[str, str] | None,
    files: Sequence[Path],
    timeout: float | None,
) -> Comparison:
    """The comparison, printed with what a reader should know of how the files were read."""
    values = _together(data, fitted, chosen)
    if table:
        check_conditions(data.runs, *table, values)
    comparison = study.compare(data, model, values, files=files, timeout=timeout)
    typer.echo(str(comparison))
    for note in _notes(data.runs):
        typer.echo(f"  note: {note}")
    return comparison


def _notes(runs: Sequence[Run]) -> list[str]:
    """What is to be known of how files were read, each once, with the runs that it is of."""
    of: dict[str, list[str]] = {}
    for run in runs:
        for note in run.notes:
            of.setdefault(note, []).append(run.name)
    return [f"{listed(dict.fromkeys(names))}: {note}" for note, names in of.items()]


def _together(
    data: DataSet, fitted: Mapping[str, float], chosen: Mapping[str, str]
) -> dict[str, float | str]:
    """Values of a file, but for what a run states, and those that are set."""
    stated = {name for run in data.runs for name in run.parameters}
    return {**{name: value for name, value in fitted.items() if name not in stated}, **chosen}


def _check_fitted(
    fitted: FittedModel, params: Path, data: DataSet, model: str | None, files: Sequence[Path]
) -> None:
    """Values in a file are of the model, in its units and ranges; says which of them give way to those of runs."""
    interface = study.describe(data.model_for(model), files)
    own = {"", data.model, data.bench, data.unmapped, names.last(interface.model)}
    if model is None and not own & {fitted.model, names.last(fitted.model)}:
        raise InputError(
            f"these values are of {fitted.model}, and the data set is of {interface.model}: "
            "name the model that they are for with --model",
            params,
        )
    check_fitted(fitted, interface, params)
    stated = listed({n: 0 for run in data.runs for n in run.parameters if n in fitted.values})
    if stated != "none":
        note = f"{params}: {stated}: the runs state values of their own, which count"
        console.print(note, markup=False, soft_wrap=True)


def _fitted(params: Path, model: str | None) -> FittedModel:
    """What a file holds; values of a model with effects are of no model without them."""
    fitted = read_fitted_model(params)
    if fitted.effects and model is None:
        made = f"pam-cosim add --from {quote(str(params))} -o Better.mo"
        raise InputError(
            f"these values are of {fitted.model} with {', '.join(fitted.effects)}: name that model with --model; "
            f"'{made}' writes it",
            params,
        )
    return fitted
