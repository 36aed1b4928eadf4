"""Workbooks of spreadsheets: a sheet as the text that a spreadsheet would export."""

from __future__ import annotations

import csv
import io
from contextlib import suppress
from datetime import date, time, timedelta
from pathlib import Path
from typing import Any
from zipfile import BadZipFile, ZipFile

from pam_cosim.errors import InputError
from pam_cosim.libraries import library
from pam_cosim.measurement.table import check_count, reading
from pam_cosim.wording import listed, shown

WORKBOOKS = (".xlsx", ".xlsm", ".xls", ".ods")


def sheet_text(file: Path, sheet: str | None) -> str:
    """A line of comma-separated cells for each row of a sheet.

    Args:
        file: the workbook.
        sheet: its name, or its number from 1; None: the only one that has cells.

    Raises:
        InputError: the reader is not installed, no workbook, no such sheet, several sheets and none is stated.
    """
    calamine = library("python_calamine", file)
    with reading(file, "a workbook", calamine.CalamineError, OSError):
        with suppress(BadZipFile), ZipFile(file) as archive:
            check_count(0, file, sum(entry.file_size for entry in archive.infolist()))
        book = calamine.load_workbook(file)
        sheets = {name: book.get_sheet_by_name(name) for name in book.sheet_names}
    filled = [name for name, content in sheets.items() if content.height]
    chosen = {str(number): content for number, content in enumerate(sheets.values(), 1)} | sheets
    if sheet is None and len(filled) == 1:
        sheet = filled[0]
    if sheet not in chosen:
        message = (
            "the workbook has several sheets"
            if sheet is None
            else f"there is no sheet {shown(sheet)}"
        )
        hint = f'state one of {listed(filled)} under [recording], as table = "{filled[0]}"'
        raise InputError(f"{message}; {hint}" if filled else "the workbook is empty", file)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    for row in chosen[sheet].to_python(skip_empty_area=False):
        cells = list(map(_cell, row))
        writer.writerow(cells if any(cells) else [])
    return text.getvalue()


def _cell(value: Any) -> str:
    if isinstance(value, timedelta):
        return repr(value.total_seconds())
    if isinstance(value, date | time):
        return str(value)
    return (
        " ".join(value.split()) if isinstance(value, str) else repr(float(value)).removesuffix(".0")
    )
