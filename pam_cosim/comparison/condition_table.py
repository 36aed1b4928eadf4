"""How well a model does condition by condition: a table over two parameters of the runs, as Dzahir and Yamamoto's.

Dzahir and Yamamoto (2019), Table 3, give the correlation of measured and modelled contraction by load and frequency,
with mean and standard deviation of each column. Their standard deviations are those of the cells themselves (divided
by their number); so are these.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.comparison.scores import score_signal
from pam_cosim.errors import InputError
from pam_cosim.exports import Columns, Tabular, write_table
from pam_cosim.files import plain
from pam_cosim.measurement import Run, Signal
from pam_cosim.units import format_quantity, readable_factor, readable_unit
from pam_cosim.wording import Printed, did_you_mean, listed

Statistic = Literal["correlation", "rmse", "chi2_reduced"]
STATISTICS: tuple[Statistic, ...] = get_args(Statistic)
TITLES: dict[Statistic, str] = {
    "correlation": "correlation of measured and modelled",
    "rmse": "rms error of",
    "chi2_reduced": "reduced chi-square of",
}
_SAME = 12  # digits in which two values of a parameter agree that are the same condition


@dataclass(frozen=True)
class Condition:
    """A parameter of the runs that spans one side of a table: its name, SI unit and values [unit], increasing."""

    name: str
    unit: str
    values: tuple[float, ...]

    @property
    def labels(self) -> list[str]:
        """The values with their unit, as a person would write them."""
        return [format_quantity(v, self.unit, 6) for v in self.values]


@dataclass(frozen=True)
class ConditionTable(Printed, Tabular):
    """Scores of one signal by two parameters of the runs; NaN in a cell without samples.

    Attributes:
        model: name of the model.
        signal, unit: the signal and its SI unit.
        rows, columns: the conditions, m and n of them.
        correlation: (m, n) Pearson's, measured against modelled.
        rmse: (m, n) [unit] of measured minus modelled.
        chi2_reduced: (m, n) mean square of that in noise standard deviations.
        samples: (m, n) how many were compared.
    """

    json_keys = "signal unit rows columns"

    model: str
    signal: str
    unit: str
    rows: Condition
    columns: Condition
    correlation: Array
    rmse: Array
    chi2_reduced: Array
    samples: Array

    def values(self, statistic: Statistic) -> Array:
        """(m, n) of one statistic."""
        chosen: Array = getattr(self, statistic)
        return chosen

    def by_row(self, statistic: Statistic) -> tuple[Array, Array]:
        """Mean and standard deviation of each row, (m,) both, over the cells that have samples."""
        return _moments(self.values(statistic))

    def by_column(self, statistic: Statistic) -> tuple[Array, Array]:
        """Mean and standard deviation of each column, (n,) both, over the cells that have samples."""
        return _moments(self.values(statistic).T)

    def frame_columns(self) -> Columns:
        """A row for each cell."""
        rows, columns = self.rows, self.columns
        units: dict[Statistic, str] = {"correlation": "", "rmse": self.unit, "chi2_reduced": ""}
        return {
            rows.name: (np.repeat(rows.values, len(columns.values)), rows.unit),
            columns.name: (np.tile(columns.values, len(rows.values)), columns.unit),
            **{name: (self.values(name).ravel(), unit) for name, unit in units.items()},
            "samples": (self.samples.ravel(), ""),
        }

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON, SI units; None where there is no sample."""
        statistics = {statistic: self._statistic_as_dict(statistic) for statistic in STATISTICS}
        return super().as_dict() | dict(plain({"samples": self.samples.astype(int), **statistics}))

    def _statistic_as_dict(self, statistic: Statistic) -> dict[str, object]:
        rows, columns = self.by_row(statistic), self.by_column(statistic)
        return {
            "values": self.values(statistic),
            "by_row": {"mean": rows[0], "sd": rows[1]},
            "by_column": {"mean": columns[0], "sd": columns[1]},
        }

    def texts(self, statistic: Statistic) -> list[list[str]]:
        """The table as cells of text: a heading, a row for each condition, mean and standard deviation around them."""
        head = [f"{self.rows.name} \\ {self.columns.name}", *self.columns.labels, "mean ± sd"]
        body = [
            [
                label,
                *(self._text(v, statistic) for v in row),
                self._spread_text(mean, sd, statistic),
            ]
            for label, row, mean, sd in zip(
                self.rows.labels, self.values(statistic), *self.by_row(statistic), strict=True
            )
        ]
        columns = zip(*self.by_column(statistic), strict=True)
        return [
            head,
            *body,
            ["mean ± sd", *(self._spread_text(m, s, statistic) for m, s in columns), ""],
        ]

    def title(self, statistic: Statistic) -> str:
        """What the numbers are, with their unit."""
        unit = readable_unit(self.unit) if statistic == "rmse" else ""
        return f"{TITLES[statistic]} {self.signal}" + (f" [{unit}]" if unit else "")

    def _text(self, value: float, statistic: Statistic) -> str:
        if not np.isfinite(value):
            return "-"
        return (
            f"{value:.4f}"
            if statistic == "correlation"
            else f"{value * self._factor(statistic):.4g}"
        )

    def _spread_text(self, mean: float, deviation: float, statistic: Statistic) -> str:
        return (
            "-"
            if not np.isfinite(mean)
            else f"{self._text(mean, statistic)} ± {self._text(deviation, statistic)}"
        )

    def _factor(self, statistic: Statistic) -> float:
        return readable_factor(self.unit) if statistic == "rmse" else 1.0

    def __str__(self) -> str:
        return "\n\n".join(
            f"{self.title(s)}, {self.model}\n{_aligned(self.texts(s))}" for s in STATISTICS
        )

    def csv_rows(self) -> list[list[str]]:
        """Cells of a CSV file, SI units: a row for each statistic and condition, then mean and standard deviation."""
        units = {"correlation": "1", "rmse": self.unit or "1", "chi2_reduced": "1"}
        listed = []
        for statistic in STATISTICS:
            heading = [self.signal, f"{statistic} [{units[statistic]}]"]
            row_mean, row_sd = self.by_row(statistic)
            for value, row, mean, sd in zip(
                self.rows.values, self.values(statistic), row_mean, row_sd, strict=True
            ):
                listed.append([*heading, repr(value), *map(_cell, [*row, mean, sd])])
            for name, numbers in zip(("mean", "sd"), self.by_column(statistic), strict=True):
                listed.append([*heading, name, *map(_cell, numbers), "", ""])
        return listed

    def csv_head(self) -> list[str]:
        """The heading above ``csv_rows``."""
        rows = f"{self.rows.name} [{self.rows.unit or '1'}]"
        columns = [
            f"{self.columns.name} = {v!r} {self.columns.unit}".rstrip() for v in self.columns.values
        ]
        return ["signal", "statistic [unit]", rows, *columns, "mean", "sd"]

    def to_csv(self, path: Path | str) -> None:
        """Writes the table, SI units.

        Raises:
            InputError: the file cannot be written.
        """
        write_tables(Path(path), [self])


def condition_table(
    model: str,
    runs: Sequence[RunComparison],
    signal: Signal,
    rows: str,
    columns: str,
    units: dict[str, str],
    fitted: dict[str, float],
) -> ConditionTable:
    """Scores of a signal by two parameters; the runs of one condition are taken together.

    Args:
        model: name of the model.
        runs: the simulated runs with their measurements.
        signal: what is scored.
        rows: name of a parameter that every run has.
        columns: of another one.
        units: SI units of parameters, by name.
        fitted: values with which all runs without a value of their own were simulated [SI].

    Raises:
        InputError: a parameter that some run does not have; the same one twice.
    """
    check_conditions([r.run for r in runs], rows, columns, fitted)
    at = {name: [_value(r.run, name, fitted) for r in runs] for name in (rows, columns)}
    down, across = (
        Condition(name, units.get(name, ""), tuple(sorted(set(at[name]))))
        for name in (rows, columns)
    )
    shape = len(down.values), len(across.values)
    cells: dict[Statistic, Array] = {s: np.full(shape, np.nan) for s in STATISTICS}
    samples = np.zeros(shape)
    conditions = list(zip(at[rows], at[columns], strict=True))
    for i, row in enumerate(down.values):
        for j, column in enumerate(across.values):
            scored = score_signal(
                [r for r, c in zip(runs, conditions, strict=True) if c == (row, column)], signal
            )
            if scored is not None:
                samples[i, j] = scored.samples
                for s in STATISTICS:
                    cells[s][i, j] = getattr(scored, s)
    correlation, rmse, chi2 = (cells[s] for s in STATISTICS)
    return ConditionTable(
        model, signal.name, signal.unit, down, across, correlation, rmse, chi2, samples
    )


def write_tables(path: Path, tables: Sequence[ConditionTable]) -> None:
    """Writes tables over the same conditions, one for each signal, below each other as CSV, SI units.

    Raises:
        InputError: the file cannot be written.
    """
    write_table(path, (tables[0].csv_head(), [row for table in tables for row in table.csv_rows()]))


def check_conditions(
    runs: Sequence[Run], rows: str, columns: str, fitted: Collection[str] = ()
) -> None:
    """Finds out, before anything is simulated, whether a table by two parameters can be made.

    Args:
        runs: the measurement.
        rows: name of a parameter that every run has.
        columns: of another one.
        fitted: names of the other values with which all runs are simulated.

    Raises:
        InputError: a parameter that some run does not have; the same one twice.
    """
    if rows == columns:
        raise InputError(f"the table has '{rows}' on both sides; name two parameters of the runs")
    everywhere = [
        name
        for name in dict.fromkeys([*fitted, *(n for run in runs for n in run.parameters)])
        if name in fitted or all(name in run.parameters for run in runs)
    ]
    for name in (rows, columns):
        for run in runs:
            if name not in fitted and name not in run.parameters:
                raise InputError(_not_of(run, name, everywhere), run.file)


def _not_of(run: Run, name: str, everywhere: Sequence[str]) -> str:
    """Why a table cannot be by ``name``, and by what it can."""
    if name in run.inputs:
        usable = f"parameters that every run has: {listed(everywhere)}"
        return (
            f"'{name}' is an input, which moves during the run {run.name}: a table is by {usable}"
        )
    hint = did_you_mean(name, everywhere)
    return f"the run {run.name} has no parameter '{name}' to make a table by; {hint}"


def _value(run: Run, name: str, fitted: Mapping[str, float]) -> float:
    """A value of a condition, rounded to the digits by which conditions are distinguished."""
    value = run.parameters.get(name, fitted.get(name, np.nan))
    return float(f"{value:.{_SAME}g}")


def _moments(cells: Array) -> tuple[Array, Array]:
    """Mean and standard deviation of each row; NaN where it has no number."""
    finite_cells = [row[np.isfinite(row)] for row in cells]
    mean = np.array([row.mean() if row.size else np.nan for row in finite_cells])
    return mean, np.array([row.std() if row.size else np.nan for row in finite_cells])


def _cell(value: float) -> str:
    return repr(float(value)) if np.isfinite(value) else ""


def _aligned(texts: list[list[str]]) -> str:
    widths = [max(len(row[j]) for row in texts) for j in range(len(texts[0]))]
    lines = []
    for row in texts:
        cells = [
            row[0].ljust(widths[0]),
            *(text.rjust(w) for text, w in zip(row[1:], widths[1:], strict=True)),
        ]
        lines.append(("  " + "  ".join(cells)).rstrip())
    return "\n".join(lines)
