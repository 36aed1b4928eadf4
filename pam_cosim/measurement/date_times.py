"""Dates with times of day, written as ISO 8601 has them: ``2024-03-12 14:05:00.01``, ``2024-03-12T14:05:00Z``."""

from __future__ import annotations

import re
from datetime import datetime

EXAMPLE = "2024-03-12 14:05:00.01"
_DATE_TIME = re.compile(
    r"\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d([.,]\d+)?)?(Z|[+-]\d\d(:?\d\d)?)?", re.ASCII
)
_TIME_OF_DAY = re.compile(r"(.*\D)?\d{1,2}:\d\d(:\d\d([.,]\d+)?)?(\D.*)?", re.ASCII)
_DATE = re.compile(r"\d{1,2}([./-])\d{1,2}\1(\d{2}|\d{4})|\d{4}([./-])\d{1,2}\3\d{1,2}", re.ASCII)


def is_date(cell: str) -> bool:
    """Whether a cell is written as a day alone, in whatever order: ``12.03.2024``, ``2024-03-12``."""
    return _DATE.fullmatch(cell) is not None


def is_date_time(cell: str) -> bool:
    """Whether a cell is written so, be there such a day or not."""
    return _DATE_TIME.fullmatch(cell) is not None


def says_time_of_day(cell: str) -> bool:
    """Whether a text holds a time of day in whatever way, as ``12.03.2024 14:05`` does."""
    return _TIME_OF_DAY.fullmatch(cell) is not None


def date_time(cell: str) -> datetime | None:
    """The date and time; None: it is not written so, or there is no such day."""
    if not is_date_time(cell):
        return None
    try:
        return datetime.fromisoformat(cell)
    except ValueError:
        return None


def seconds_between(first: datetime, later: datetime) -> float | None:
    """Seconds from one to the other; None: one of them alone says its time zone."""
    try:
        return (later - first).total_seconds()
    except TypeError:
        return None
