"""Results as tables: the next run, comparisons next to earlier ones."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pam_cosim.comparison import Comparison
from pam_cosim.diagnosis import NextExperiment
from pam_cosim.diagnosis.planning import PlannedRun, RunPlan
from pam_cosim.errors import InputError
from pam_cosim.exports import table_text
from pam_cosim.files import check_writable, read_json, write_text
from pam_cosim.measurement import RigColumn
from pam_cosim.units import format_quantity, readable_factor, readable_unit
from pam_cosim.wording import shown

_MOST_ROWS = 30  # of a planned run that are printed


def write_next_run(path: Path, plan: NextExperiment) -> None:
    """Writes the inputs of a next experiment as a run's CSV.

    Args:
        path: the file.
        plan: ``Diagnosis.next_experiment``.

    Raises:
        InputError: the file cannot be written.
    """
    write_text(path, next_run_text(plan))


def next_run_text(plan: NextExperiment) -> str:
    """The inputs of a next experiment as a run's CSV; what else to set stands in comments above.

    Where inputs are held between the points, a step is two rows at one time, so that the file means the same whether
    it is read as straight lines or as steps.
    """
    rows = list(zip(*plan.table.values(), strict=True))
    if plan.interpolation == "previous":
        rows = _with_steps(rows)
    remarks = [
        f"run {_line(plan.run)}, {_line(plan.change)}",
        *_settings(plan.parameters, plan.units),
    ]
    return _text_of_run(remarks, list(plan.table), rows, plan.units)


def write_planned_runs(
    path: Path, plan: RunPlan, columns: Mapping[str, RigColumn] | None = None
) -> list[Path]:
    """Writes the inputs of planned runs as CSV, the second one with "-2" after the name; the files.

    What each is expected to decide and what else to set stands in comments above.

    Args:
        path: the file of the first run.
        plan: the runs.
        columns: as ``rig_columns`` gives them: what the rig's logger calls the inputs, and in which units; default:
            as the model does.

    Raises:
        InputError: a file cannot be written.
    """
    files = planned_files(path, len(plan.runs))
    for file in files:
        check_writable(file)
    for file, run in zip(files, plan.runs, strict=True):
        remarks = [plan.expectation, *_settings(run.parameters, plan.units)]
        heads, cells = rig_table(run, plan.units, columns or {})
        comments = "".join(f"# {_line(line)}\n" for line in remarks)
        write_text(file, comments + table_text((heads, cells)))
    return files


def rig_table(
    run: PlannedRun, units: Mapping[str, str], columns: Mapping[str, RigColumn]
) -> tuple[list[str], list[list[str]]]:
    """Headings and rows of what to drive, by the columns and in the units of the rig where they are known."""
    heads, values = [], []
    for name, series in run.table.items():
        unit = "s" if name == "time" else units[name]
        column = columns.get(name)
        if column is None:
            heads.append(f"{name} [{_file_unit(unit) or '1'}]")
            values.append([_cell(value, unit) for value in series])
        else:
            heads.append(f"{column.name} [{column.unit}]" if column.unit else column.name)
            numbers = column.numbers(np.array(series)).round(9)
            values.append([f"{number:.9g}" for number in numbers + 0.0])
    return heads, [list(row) for row in zip(*values, strict=True)]


def rig_lines(plan: RunPlan, columns: Mapping[str, RigColumn]) -> list[str]:
    """What to drive in each run, as lines of a table."""
    lines = []
    for number, run in enumerate(plan.runs, 1):
        heads, cells = rig_table(run, plan.units, columns)
        printed_rows = [
            heads,
            *([f"{float(cell):.4g}" for cell in row] for row in cells[:_MOST_ROWS]),
        ]
        widths = [max(len(row[i]) for row in printed_rows) for i in range(len(heads))]
        lines.append(f"run {number}, to drive (lines join the rows):")
        lines += ["  " + "  ".join(map(str.rjust, row, widths)) for row in printed_rows]
        if len(cells) > _MOST_ROWS:
            lines.append(f"  and {len(cells) - _MOST_ROWS} more rows, which -o FILE.csv writes")
    return lines


def planned_files(path: Path, count: int) -> list[Path]:
    """The files of a number of planned runs."""
    return [path, *(path.with_stem(f"{path.stem}-{number}") for number in range(2, count + 1))]


def _settings(parameters: Mapping[str, float], units: Mapping[str, str]) -> list[str]:
    return [
        f"set {name} = {_cell(v, units[name])} {_file_unit(units[name])}"
        for name, v in parameters.items()
    ]


def _text_of_run(
    comments: Sequence[str],
    names: Sequence[str],
    rows: Sequence[tuple[float, ...]],
    units: Mapping[str, str],
) -> str:
    """Comments, and the inputs of a run as a table with units."""
    units = {"time": "s", **units}
    remarks = "".join(f"# {_line(line)}\n" for line in comments)
    heads = [f"{n} [{_file_unit(units[n]) or '1'}]" for n in names]
    cells = ([_cell(v, units[n]) for n, v in zip(names, row, strict=True)] for row in rows)
    return remarks + table_text((heads, cells))


def _with_steps(rows: Sequence[tuple[float, ...]]) -> list[tuple[float, ...]]:
    stepped = [*rows[:1]]
    for before, row in zip(rows[:-1], rows[1:], strict=True):
        if row[1:] != before[1:] and row[0] > before[0]:
            stepped.append((row[0], *before[1:]))
        stepped.append(row)
    return stepped


def _file_unit(unit: str) -> str:
    """The readable unit where it can be typed, the SI unit otherwise."""
    unit_text = readable_unit(unit)
    return unit_text if unit_text.isascii() else unit


def _cell(value: float, unit: str) -> str:
    factor = readable_factor(unit) if readable_unit(unit).isascii() else 1.0
    return f"{value * factor:.9g}"


def _line(text: object) -> str:
    return " ".join(str(text).split())


def read_comparison(path: Path) -> dict[str, Any]:
    """Reads what ``compare --json`` wrote.

    Raises:
        InputError: the file is missing or is not such a file.
    """
    content = read_json(path)
    signals = content.get("signals") if isinstance(content, dict) else None
    if not isinstance(signals, dict) or not all(isinstance(s, dict) for s in signals.values()):
        raise InputError("is not a result of 'pam-cosim compare --json'", path)
    for name, scores in signals.items():
        rmse = scores.get("rmse")
        if isinstance(rmse, bool) or not isinstance(rmse, (int, float)) or not 0 <= rmse < math.inf:
            raise InputError(f"signals.{name}.rmse is {shown(rmse)}, no error", path)
    comparison: dict[str, Any] = content
    return comparison


def against_lines(
    comparison: Comparison, earlier: Sequence[tuple[str, dict[str, Any]]]
) -> list[str]:
    """One line for each signal and earlier result: by how much the error changed."""
    lines = []
    for name, content in earlier:
        for signal, score in comparison.scores["all"].items():
            before = content["signals"].get(signal, {}).get("rmse", 0.0)
            if before > 0:
                unit = comparison.data.signals[signal].unit
                change = 100 * (score.rmse / before - 1)
                lines.append(
                    f"  against {name}: {signal} rms error {format_quantity(before, unit)} -> "
                    f"{format_quantity(score.rmse, unit)} ({change:+.0f} %)"
                )
    return lines
