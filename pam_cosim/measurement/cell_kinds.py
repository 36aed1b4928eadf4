"""What a cell of a text table holds: a number, a number with a unit, a date with a time of day, a word of a switch.

Dates are written as ISO 8601 has them, ``2024-03-12 14:05:00.01`` and ``2024-03-12T14:05:00Z``, or as
``12.03.2024 14:05:00,01``; a time of day, ``14:05:00.01``, may stand alone. The words for the two states of a switch
are those of controllers and their engineers.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from datetime import datetime
from functools import lru_cache

from pam_cosim.measurement.table import is_unit
from pam_cosim.model.interface import SWITCH_WORDS

NUMBER = re.compile(r"[+-]?(\d+(?:[.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?", re.ASCII)
_BETWEEN_THOUSANDS = ",.'\u2019 \u00a0\u202f"
_GROUPED = re.compile(
    r"[+-]?[1-9]\d{0,2}(?:(?:,\d{3})+\.\d*|(?:\.\d{3})+,\d*|(?:,\d{3}){2,}|(?:\.\d{3}){2,}"
    r"|(?:(?P<sign>['\u2019 \u00a0\u202f])\d{3})(?:(?P=sign)\d{3})*(?:[.,]\d*)?)",
    re.ASCII,
)
_MEASURED = re.compile(rf"(?:{NUMBER.pattern})\s*(?P<unit>[A-Za-zµμ%°][^\s\d]*)", re.ASCII)
EXAMPLE = "2024-03-12 14:05:00.01"
_DATE_TIME = re.compile(
    r"\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d([.,]\d+)?)?(Z|[+-]\d\d(:?\d\d)?)?", re.ASCII
)
_CLOCK = re.compile(
    r"(?:(?P<day>\d{1,2})\.(?P<month>\d{1,2})\.(?P<year>\d{4}) )?"
    r"(?P<hour>\d{1,2}):(?P<minute>\d\d):(?P<second>\d\d)(?:[.,](?P<fraction>\d{1,6})\d*)?",
    re.ASCII,
)
_TIME_OF_DAY = re.compile(r"(.*\D)?\d{1,2}:\d\d(:\d\d([.,]\d+)?)?(\D.*)?", re.ASCII)
_DATE = re.compile(r"\d{1,2}([./-])\d{1,2}\1(\d{2}|\d{4})|\d{4}([./-])\d{1,2}\3\d{1,2}", re.ASCII)


def is_number(cell: str) -> bool:
    """Whether a cell can be read as a number, possibly grouped by thousands, or as a date with a time of day."""
    return bool(NUMBER.fullmatch(cell) or _GROUPED.fullmatch(cell)) or is_date_time(cell)


def decimal_sign_of(cell: str) -> str:
    """The decimal sign of a number whose thousands are grouped by a point or a comma; "" where it is undetermined."""
    if not _GROUPED.fullmatch(cell) or not {",", "."}.intersection(cell):
        return ""
    last = "," if cell.rfind(",") > cell.rfind(".") else "."
    return last if cell.count(last) == 1 else "." if last == "," else ","


def grouping_sign(cells: Sequence[str]) -> str:
    """The sign between thousands of the cells of a column; "" where they are not, or may not be, grouped.

    ``1,234`` may have decimals; ``1,234.5`` and ``1,234,567`` do not.
    """
    for sign in _BETWEEN_THOUSANDS:
        grouped = [cell for cell in cells if sign in cell]
        other = {",": r"\.", ".": ","}.get(sign, "[.,]")
        pattern = re.compile(
            rf"[+-]?\d{{1,3}}(?:{re.escape(sign)}\d{{3}})+(?:{other}\d*)?", re.ASCII
        )
        if any(map(_GROUPED.fullmatch, grouped)) and all(map(pattern.fullmatch, grouped)):
            return sign
    return ""


def is_date(cell: str) -> bool:
    """Whether a cell is written as a day alone, in whatever order: ``12.03.2024``, ``2024-03-12``."""
    return _DATE.fullmatch(cell) is not None


def is_date_time(cell: str) -> bool:
    """Whether a cell is written so, be there such a day or not."""
    return (_DATE_TIME.fullmatch(cell) or _CLOCK.fullmatch(cell)) is not None


def says_time_of_day(cell: str) -> bool:
    """Whether a text holds a time of day in whatever way, as ``12.03.2024 14:05`` does."""
    return _TIME_OF_DAY.fullmatch(cell) is not None


def date_time(cell: str) -> datetime | None:
    """The date and time, of a time of day alone that of the first day; None: it is not written so, or is impossible."""
    if not is_date_time(cell):
        return None
    try:
        match = _CLOCK.fullmatch(cell)
        if match is None:
            return datetime.fromisoformat(cell)
        numbers = [int(match[name] or 1) for name in ("year", "month", "day")]
        numbers += [int(match[name]) for name in ("hour", "minute", "second")]
        return datetime(*numbers, int(f"{match['fraction'] or 0:0<6}"))  # type: ignore[arg-type, call-arg]
    except ValueError:
        return None


def seconds_between(earlier: datetime, later: datetime) -> float | None:
    """Seconds from one to the other; None: one of them alone says its time zone."""
    try:
        return (later - earlier).total_seconds()
    except TypeError:
        return None


def are_switch_words(cells: Iterable[str]) -> bool:
    """Whether there are cells, and each is a word for a state of a switch."""
    small = [cell.casefold() for cell in cells]
    return bool(small) and all(cell in SWITCH_WORDS for cell in small)


_is_known = lru_cache(maxsize=256)(is_unit)


def unit_behind(cell: str) -> str:
    """The unit behind the number in a cell; "" where it is no number with a unit."""
    match = _MEASURED.fullmatch(cell)
    return match["unit"] if match and _is_known(match["unit"]) else ""


def unit_of(cells: Sequence[str]) -> str:
    """The one unit behind the number in each of the cells; "" where there is none, or are several."""
    unit = unit_behind(cells[0]) if cells else ""
    return unit if unit and all(unit_behind(cell) == unit for cell in cells) else ""


def is_measured(cell: str) -> bool:
    """Whether a cell holds a number, with or without a unit."""
    return is_number(cell) or bool(unit_behind(cell))


def is_measured_row(cells: list[str]) -> bool:
    """A row that begins with a number and its unit, and holds nothing else than such and numbers."""
    filled = [cell for cell in cells if cell]
    return len(cells) > 1 and bool(unit_behind(cells[0])) and all(map(is_measured, filled))
