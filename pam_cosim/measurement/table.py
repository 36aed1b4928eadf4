"""A recording as columns of numbers, in the file's own units, with the line of every row."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pam_cosim.errors import InputError
from pam_cosim.files import MOST_VALUES
from pam_cosim.units import UnitError, convert, pressure_reference
from pam_cosim.wording import shown

TIME = "time"
LEFT_OUT = "left out:"
"""How a note on rows that are not read begins."""
_BYTES = 8  # of a number
_POINTER = b"version https://git-lfs.github.com/spec/"
LONGEST_HEADING = 500  # letters; what is longer is no name
_BRACKETS = re.compile(r"([^\[\]]+?)\s*(?:\[([^\[\]]*)\])?")
_ROUND = re.compile(r"(.+?)\s*\(((?:[^()]|\([^()]*\))+)\)")
_OVER = re.compile(r"(.+?)(?:\s*/\s*|\s+in\s+)([^\s(]\S*(?:\s+\S+)?)")


Words = Mapping[str, Mapping[str, float]]
"""By column, the numbers of the words that it may hold, in small letters."""


@dataclass(frozen=True)
class Column:
    """One column: values (n,) in ``unit``, NaN where a sample is missing; what the file calls it, and which it is.

    Attributes:
        since: of dates with times of day, the first, from which the values count.
    """

    name: str
    unit: str
    values: NDArray[np.float64]
    heading: str = ""
    place: int = 0
    since: str = ""


@dataclass(frozen=True)
class Table:
    """What a file holds.

    Attributes:
        file: where it was read from.
        columns: by name.
        header_line: of a text, the line of the names.
        lines: (n,) of a text, the lines of the rows; errors can name them.
        notes: what a reader should know of how the file was read.
        missing: words that stood for missing samples, as they were written.
    """

    file: Path
    columns: dict[str, Column]
    header_line: int | None = None
    lines: NDArray[np.int64] | None = None
    notes: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()

    def rows(self, selection: slice | NDArray[np.bool_]) -> Table:
        """The table with some of its rows."""
        columns = {
            n: replace(column, values=column.values[selection])
            for n, column in self.columns.items()
        }
        lines = None if self.lines is None else self.lines[selection]
        return replace(self, columns=columns, lines=lines)

    def with_time(self, interval: float) -> Table:
        """The table with time from zero in equal steps [s]."""
        count = len(next(iter(self.columns.values())).values)
        time = Column(TIME, "s", interval * np.arange(count, dtype=np.float64), TIME)
        return replace(self, columns={TIME: time, **self.columns})

    def error(self, message: str, column: str, row: int | None = None) -> InputError:
        """An error about a column: its header, or one of its rows."""
        if row is None:
            return InputError(message, self.file, self.header_line, column)
        if self.lines is None:
            return InputError(f"row {row + 1}: {message}", self.file, None, column)
        return InputError(message, self.file, int(self.lines[row]), column)


@dataclass(frozen=True)
class Layout:
    """How a file is written, as far as that is stated; None: as the file shows.

    Attributes:
        encoding: of a text, such as "latin-1".
        separator: of a text's columns: ",", ";", "tab" or "blank".
        decimal: sign of a text's numbers, "." or ",".
        names: headings "name [unit]" of a file that has none.
        header_line: line of a text's names.
        units_line: line of a text's units.
        table: which group, channel group or variable of a file with several.
        ignore: patterns of names of columns that are not read; ``*`` stands for any text.
        missing: of a text, words that stand where a sample is missing, in small letters.
        required: names that a pattern with ``*`` does not mean.
        clock: names, headings or places of the columns of times, in which every number is one; None: not known.
        words: of a text, by column: numbers of the words that it may hold.
    """

    encoding: str | None = None
    separator: str | None = None
    decimal: str | None = None
    names: tuple[str, ...] | None = None
    header_line: int | None = None
    units_line: int | None = None
    table: str | None = None
    ignore: tuple[str, ...] = ()
    missing: frozenset[str] = frozenset()
    required: frozenset[str] = field(default=frozenset())
    clock: frozenset[str | int] | None = None
    words: Words = field(default_factory=dict)

    def keeps(self, heading: str, name: str) -> bool:
        """Whether a column is read."""
        if heading in self.ignore or name in self.ignore:
            return False
        if heading in self.required or name in self.required:
            return True
        return not any(
            "*" in p and (fnmatchcase(name, p) or fnmatchcase(heading, p)) for p in self.ignore
        )


def split_heading(text: str) -> tuple[str, str] | None:
    """Name and unit ("" where none is written) of ``p [kPa]``, ``p (kPa)``, ``p/kPa(g)`` or ``p in kPa``.

    Only square brackets always hold a unit: "sensor (left)" is a name. None: the text is no heading.
    """
    match = _BRACKETS.fullmatch(text) if len(text) <= LONGEST_HEADING else None
    if match is None or not text.isprintable():
        return None
    if match[2] is None:
        for other in (_OVER.fullmatch(text), _ROUND.fullmatch(text)):
            if other is not None and names_unit(other[2]) and not other[2].isdigit():
                return other[1], other[2].strip()
    return match[1], (match[2] or "").strip()


def is_unit(text: str) -> bool:
    """Whether a text is a unit that is known."""
    try:
        convert(0.0, text, text)
    except UnitError:
        return False
    return True


def names_unit(text: str) -> bool:
    """Whether a text is a unit; that of an absolute pressure is one too."""
    return is_unit(text) or pressure_reference(text)[1] == "absolute"


def without_empty_end(table: Table) -> Table:
    """The table less its last rows without a value, as of a spreadsheet, or where columns that are not read go on."""
    filled = [np.flatnonzero(~np.isnan(column.values)) for column in table.columns.values()]
    end = max((int(rows[-1]) + 1 for rows in filled if rows.size), default=0)
    if not end or all(end == len(column.values) for column in table.columns.values()):
        return table
    return table.rows(slice(end))


@contextmanager
def reading(file: Path, kind: str, *errors: type[Exception]) -> Iterator[None]:
    """Turns errors of the reader of a format into InputError."""
    if file.is_file():
        with file.open("rb") as content:
            check_content(content.read(len(_POINTER)), file)
    try:
        yield
    except InputError:
        raise
    except FileNotFoundError:
        raise InputError("the file does not exist", file) from None
    except errors as error:
        raise InputError(f"this file cannot be read as {kind}: {error}", file) from None


def check_content(beginning: bytes, file: Path) -> None:
    """Raises InputError where Git has left a pointer in the place of a large file."""
    if beginning.startswith(_POINTER):
        message = "this is a pointer of Git LFS, and not the recording: git lfs pull"
        raise InputError(message, file)


def check_count(values: int, file: Path, unpacked: int = 0) -> None:
    """Raises InputError where a file declares more values than can be taken: found out before they are read.

    Args:
        values: that it declares.
        file: where they are.
        unpacked: bytes that it states it unpacks to; they count as numbers, texts and lists included.
    """
    values = max(values, unpacked // _BYTES)
    if values > MOST_VALUES:
        raise InputError(
            f"it declares {values:.3g} values, and {MOST_VALUES / 1e6:.0f} million can be taken: "
            "record less often, or leave columns out of the file",
            file,
        )


def table_of(vectors: Iterable[tuple[str, str, Any]], stated: Layout, file: Path) -> Table:
    """The table of a file in which each column stands by itself; times of day are seconds since the first.

    Args:
        vectors: heading, its unit ("": none) and values of each column; a text states what it holds instead of
            numbers.
        stated: how the file is written.
        file: path of the file.

    Raises:
        InputError: a heading that cannot be read, no numbers, two columns of a name, or of unlike length.
    """
    columns_by_name: dict[str, Column] = {}
    for heading, unit_next, vector in vectors:
        name, unit = _headed(heading, unit_next, file)
        if not stated.keeps(heading, name):
            continue
        if name in columns_by_name:
            raise InputError("there are two columns of this name", file, None, name)
        values = np.asarray(vector)
        if values.dtype.kind in "mM":
            unit, values = "s", since_first(values)
        elif values.dtype.kind not in "fiu":
            held = f"{vector} and no numbers" if isinstance(vector, str) else "no numbers"
            message = f"it holds {held}; leave it out: [recording] ignore = [...]"
            raise InputError(message, file, None, name)
        columns_by_name[name] = Column(name, unit, np.array(values, dtype=float).ravel(), heading)
    if not columns_by_name:
        raise InputError("there is no column of numbers", file)
    example = next(iter(columns_by_name.values()))
    for column in columns_by_name.values():
        if len(column.values) != len(example.values):
            message = f"it has {len(column.values)} values, {shown(example.name)} has {len(example.values)}"
            raise InputError(
                f"{message}; state which to leave out: ignore = [...]", file, None, column.name
            )
    return Table(file, columns_by_name)


def _headed(heading: str, unit: str, file: Path) -> tuple[str, str]:
    """Name and unit of a column of a file that may state units next to names."""
    parts = split_heading(heading)
    if parts is None:
        raise InputError(
            f"the name {shown(heading)} of a column must be 'name' or 'name [unit]'", file
        )
    if unit and parts[1] and unit != parts[1]:
        raise InputError(
            f"its name has the unit {shown(parts[1])}, but its unit is {shown(unit)}",
            file,
            None,
            parts[0],
        )
    return parts[0], parts[1] or unit


def check_names(names: Sequence[str], count: int, file: Path) -> None:
    """Raises InputError where stated ``names`` are not as many as the columns."""
    if len(names) != count:
        raise InputError(f"names has {len(names)} headings, the file has {count} columns", file)


def since_first(times: NDArray[np.datetime64]) -> NDArray[np.float64]:
    """(n,) seconds since the first of some times of day; NaN where one is missing."""
    return np.asarray((times - times[:1]) / np.timedelta64(1, "s"), dtype=float)
