"""The cells of a text table as numbers, with one message that names line and column."""

from __future__ import annotations

import csv
import json
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pam_cosim.errors import InputError
from pam_cosim.measurement.cell_kinds import (
    date_time,
    grouping_sign,
    is_date,
    seconds_between,
    unit_behind,
)
from pam_cosim.measurement.text_layout import WORDS, TextLayout
from pam_cosim.measurement.text_rows import Line, split_cells
from pam_cosim.model.interface import SWITCH_WORDS
from pam_cosim.wording import shown

_BLOCK = 20_000  # Lines that are turned into numbers at once.
_LONGEST = 1000  # letters of a cell that is looked at as a number
_NUMBER = re.compile(r"[+-]?(\d+(?:\.\d*)?|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_NO_NUMBER = re.compile(r"[^0-9eE+\-.]")
_GROUPED = re.compile(r"[+-]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?", re.ASCII)
_DAY = 86_400.0  # s
_NOT_FINITE = ("nan", "inf", "infinity")


class _GroupedColumn(Exception):  # noqa: N818 -- it requests another reading
    """The numbers of a column are grouped by thousands, with that sign."""

    def __init__(self, column: int, sign: str) -> None:
        super().__init__(column)
        self.column, self.sign = column, sign


class Reader:
    """Rows of text to columns of numbers: quickly where they are plain, else cell by cell."""

    def __init__(
        self, layout: TextLayout, names: list[str], keep: list[int], file: Path, decimal: str
    ) -> None:
        self.separator, self.names, self.keep, self.file = layout.separator, names, keep, file
        self.decimal = decimal
        self.words: list[Mapping[str, float]] = [{} for _ in names]
        self.missing: frozenset[str] = frozenset()
        self.clock: frozenset[int] | None = None  # places of columns of times; None: not known
        self.dates: dict[int, str] = {}  # places of columns of dates with times of day: the first
        self.units: dict[int, str] = {}  # by place, behind the number in every cell
        self.grouped: dict[int, str] = {}  # by place, the sign between thousands
        self.met: dict[str, None] = {}
        self._lines: list[Line] = []

    def cells(self, lines: list[Line]) -> Iterator[Line]:
        """Line and text of every cell that holds a sign for decimals."""
        for number, line in lines:
            if "." in line or "," in line:
                cells = self._split(number, line)
                for i in (i for i in self.keep if i not in self.dates):
                    yield number, self._bare(cells[i], i) if i < len(cells) else ""

    def columns(self, lines: list[Line]) -> list[NDArray[np.float64]]:
        """(n,) of each column that is kept; NaN where a cell is empty."""
        self._lines = lines
        try:
            blocks = [self._block(lines[at : at + _BLOCK]) for at in range(0, len(lines), _BLOCK)]
        except _GroupedColumn as found:
            self.grouped[found.column] = found.sign
            return self.columns(lines)
        columns_read = [
            np.concatenate([block[k] for block in blocks]) for k in range(len(self.keep))
        ]
        for k, place in enumerate(self.keep):
            if place in self.dates and self.dates[place][2:3] == ":":  # without a day
                midnights = np.cumsum(np.diff(columns_read[k], prepend=0.0) < -_DAY / 2)
                columns_read[k] = columns_read[k] + _DAY * midnights
        return [
            values if self._is_clock(place, values) else self._without_missing(values)
            for place, values in zip(self.keep, columns_read, strict=True)
        ]

    def _is_clock(self, place: int, values: NDArray[np.float64]) -> bool:
        """Whether a column is of times; where that is not known, one that never falls is."""
        if self.clock is not None:
            return place in self.clock
        return bool((np.diff(values) >= 0.0).all())

    def _without_missing(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """NaN where a number stands that is stated to mean a missing sample, however written."""
        for word in sorted(self.missing):
            number = self._with_point(word)
            is_missing = values == float(number) if _NUMBER.fullmatch(number) else np.array(False)
            if is_missing.any():
                self.met[word] = None
                values = np.where(is_missing, np.nan, values)
        return values

    def _bare(self, cell: str, column: int) -> str:
        """A cell without the unit that is behind the numbers of its column, and without signs between thousands."""
        unit = self.units.get(column, "")
        cell = cell.removesuffix(unit).rstrip() if unit else cell
        return cell.replace(self.grouped[column], "") if column in self.grouped else cell

    def _with_point(self, cell: str) -> str:
        """A number as this text writes it, with a decimal point."""
        return cell.replace(",", ".") if self.decimal == "," else cell

    def _block(self, lines: list[Line]) -> list[NDArray[np.float64]]:
        plain = self._plain(lines)
        if plain is not None:
            return plain
        rows = [(number, self._row(number, line)) for number, line in lines]
        return [
            np.array([self._number(number, cells[i], i) for number, cells in rows])
            for i in self.keep
        ]

    def _plain(self, lines: list[Line]) -> list[NDArray[np.float64]] | None:
        """The block, when every row has as many cells and every cell is a number or empty."""
        texts = [line for _, line in lines]
        count, ends = len(self.names), len(self.names) - 1
        if self.separator == " ":
            split = [line.split() for line in texts]
            if any(len(cells) != count for cells in split):
                return None
            cells = list(chain.from_iterable(split))
        else:
            if any(line.count(self.separator) != ends for line in texts):
                return None
            joined = self.separator.join(texts)
            if '"' in joined:
                return None
            cells = joined.split(self.separator)
        columns = [self._plain_column(i, cells[i::count]) for i in self.keep]
        numbers = [column for column in columns if column is not None]
        return numbers if len(numbers) == len(columns) else None

    def _plain_column(self, column: int, cells: list[str]) -> NDArray[np.float64] | None:
        """(n,) the cells of a column; None where one is not plainly what the others are."""
        if column in self.dates:
            return self._seconds(cells, self.dates[column])
        words = self.words[column]
        if words:
            small = [cell.strip().casefold() for cell in cells]
            if all(cell in words for cell in small):
                return np.array([words[cell] for cell in small])
        if words is SWITCH_WORDS:
            return None
        if column in self.units or column in self.grouped:
            cells = [self._bare(cell.strip(), column) for cell in cells]
        return _floats(cells, self.decimal)

    def _seconds(self, cells: Sequence[str], date: str) -> NDArray[np.float64] | None:
        """(n,) seconds since the first date; None where one is not plainly a date."""
        begin = date_time(date)
        moments = [date_time(cell.strip()) for cell in cells]
        dates = [moment for moment in moments if moment is not None]
        if begin is None or len(dates) < len(moments):
            return None
        seconds = [seconds_between(begin, moment) for moment in dates]
        return None if None in seconds else np.array(seconds, dtype=np.float64)

    def _split(self, number: int, line: str) -> list[str]:
        try:
            return split_cells(line, self.separator)
        except csv.Error as error:
            message = f"this line is not text separated by {WORDS[self.separator]}: {error}"
            raise InputError(message, self.file, number) from None

    def _row(self, number: int, line: str) -> list[str]:
        cells = self._split(number, line)
        count = len(self.names)
        if len(cells) >= count and not any(cells[count:]):
            return cells[:count]
        hint = "; write decimal points, not commas" if len(cells) == 2 * len(self.names) else ""
        raise InputError(
            f"this row has {len(cells)} cells, the header has {len(self.names)}{hint}",
            self.file,
            number,
        )

    def _number(self, line: int, cell: str, column: int) -> float:
        if not cell:
            return math.nan
        if len(cell) > _LONGEST:
            raise self._error(
                f"{shown(cell)} has {len(cell)} letters: that is no number", line, column
            )
        if cell.casefold() in self.missing and not _NUMBER.fullmatch(self._with_point(cell)):
            self.met[cell] = None
            return math.nan
        if column in self.dates:
            return self._second(line, cell, column)
        words = self.words[column]
        if cell.casefold() in words:
            return words[cell.casefold()]
        written, cell = cell, self._bare(cell, column)
        number = cell.replace(",", ".") if self.decimal == "," and "." not in cell else cell
        is_number = _NUMBER.fullmatch(number) and not (self.decimal == "," and "." in cell)
        if not words and not is_number and column not in self.grouped:
            sign = grouping_sign(self._cells_of(column))
            if sign:
                raise _GroupedColumn(column, sign)
        if words is SWITCH_WORDS or not is_number:
            wrong = (
                f"{shown(cell)} is none of {', '.join(words)}"
                if words
                else self._not_a_number(written, column)
            )
            raise self._error(wrong, line, column)
        value = float(number)
        if math.isinf(value):
            raise self._error(f"{shown(cell)} is too large", line, column)
        return value

    def _error(self, message: str, line: int, column: int) -> InputError:
        """An error about a cell."""
        return InputError(message, self.file, line, self.names[column])

    def _second(self, line: int, cell: str, column: int) -> float:
        """Seconds since the first date of a column."""
        seconds = self._seconds([cell], self.dates[column])
        if seconds is None:
            first_date = shown(self.dates[column])
            message = f"{shown(cell)} is no date and time as the first one, {first_date}"
            raise self._error(f"{message}; correct it in the file", line, column)
        return float(seconds[0])

    def _cells_of(self, column: int) -> list[str]:
        """The cells of a column."""
        return [
            cell for n, line in self._lines for cell in self._split(n, line)[column : column + 1]
        ]

    def _may_be_grouped(self, column: int) -> bool:
        """Whether three digits stand behind every comma of a column."""
        with_comma = [cell for cell in self._cells_of(column) if "," in cell]
        return bool(with_comma) and all(map(_GROUPED.fullmatch, with_comma))

    def _not_a_number(self, cell: str, column: int) -> str:
        if column in self.units and unit_behind(cell):
            return (
                f"{shown(cell)} has another unit than the first cell, {shown(self.units[column])}"
            )
        if cell.lower().lstrip("+-") in _NOT_FINITE:
            hint = (
                f', or state the word under [recording]: missing = ["{cell}"]'
                if "nan" in cell.lower()
                else ""
            )
            return f"{shown(cell)} is not a finite number; leave the cell empty where a sample is missing{hint}"
        if re.fullmatch(r"[+-]?\d+[.,]\d+", cell, re.ASCII):
            if self.decimal == "." and "," in cell and self._may_be_grouped(column):
                as_integer, point = cell.replace(",", ""), cell.replace(",", ".")
                return (
                    f"{shown(cell)} may be grouped by thousands, or have a decimal comma, as every such number of this "
                    f"column may; write {as_integer} or {point}, whichever is meant"
                )
            if self.decimal == ".":
                stated = 'state decimal = "," under [recording]'
                return f"{shown(cell)} has a decimal comma; write a decimal point, or {stated} where all numbers do"
            return f"{shown(cell)} has a decimal point, other numbers have decimal commas"
        if is_date(cell):
            left_out = f"ignore = {_as_list(self.names[column])}"
            return f"{shown(cell)} is a date without a time of day; leave it out under [recording]: {left_out}"
        if re.fullmatch(r"[+-]?\d+(?:[.,]\d+)+", cell, re.ASCII):
            return f"{shown(cell)} is grouped by thousands; write it without"
        if any(map(str.isdigit, cell)):
            return f"{shown(cell)} is not a number"
        stated = f"missing = {_as_list(cell)}"
        return f"{shown(cell)} is not a number; if it marks a missing sample, state {stated} under [recording]"


def _as_list(word: str) -> str:
    """A list of one word, as ``experiment.toml`` has it."""
    return json.dumps([word], ensure_ascii=False)


def _floats(cells: list[str], decimal: str) -> NDArray[np.float64] | None:
    """(n,) numbers; None where one is not plainly a number."""
    joined = "".join(cells)
    if decimal == ",":
        if "." in joined:
            return None
        joined = joined.replace(",", ".")
        cells = [cell.replace(",", ".") for cell in cells]
    if _NO_NUMBER.search(joined.replace(" ", "")):
        return None
    try:
        values = np.fromiter(map(float, cells), float, len(cells))
    except ValueError:
        try:
            values = np.array(
                [float(cell) if cell and not cell.isspace() else math.nan for cell in cells]
            )
        except ValueError:
            return None
    return None if np.isinf(values).any() else values
