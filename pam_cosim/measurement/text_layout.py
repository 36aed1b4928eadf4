"""How a text of columns is written: separator, decimal sign, and which lines hold names and units.

A separator is taken when by it every row has as many cells as the header has names, all of them numbers. A decimal
sign is taken when a number shows it that cannot be grouped thousands: "1,234" can, "0,5" cannot. Where nothing
decides, nothing is guessed.
"""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from pam_cosim.errors import InputError
from pam_cosim.measurement import labview_text
from pam_cosim.measurement.cell_kinds import (
    NUMBER,
    decimal_sign_of,
    is_measured,
    is_measured_row,
    is_number,
)
from pam_cosim.measurement.table import Layout, split_heading
from pam_cosim.measurement.text_header import header_of
from pam_cosim.measurement.text_rows import (
    LOOKED_AT,
    Line,
    first_row,
    is_comment,
    is_dated_row,
    is_row,
    rows_of,
    split_cells,
)
from pam_cosim.wording import shown

SEPARATORS = {";": ";", "tab": "\t", ",": ",", "blank": " "}
WORDS = {";": "semicolons", "\t": "tabs", ",": "commas", " ": "blanks"}
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2}(?:,\d{3})+|[+-]?[1-9]\d{0,2}(?:\.\d{3})+", re.ASCII)
_SAID = re.compile(r'\s*"?sep=(.)"?\s*', re.IGNORECASE)


@dataclass(frozen=True)
class TextLayout:
    """What the lines of a text mean.

    Attributes:
        separator: one character; a blank stands for any number of blanks.
        headings: of every column, a unit from a row of units included.
        header_line: of the names.
        start: index of the first row among the lines.
        consistent: every line looked at is a row of numbers.
        complaint: the line at fault and why, where there is no header for the rows.
        passed_over: rows above the header, of what was logged before.
    """

    separator: str
    headings: tuple[tuple[str, str], ...]
    header_line: int
    start: int
    consistent: bool = True
    complaint: tuple[int, str] | None = None
    passed_over: int = 0


def find_layout(lines: list[Line], stated: Layout, file: Path) -> TextLayout:
    """The one layout by which the ``lines`` (number and text, without blank ones) are a table.

    Raises:
        InputError: there is none, or several; the message states what to type.
    """
    stated_separator = _SAID.fullmatch(lines[0][1])
    if stated_separator and stated_separator[1] in WORDS:
        stated = (
            stated if stated.separator else replace(stated, separator=_key(stated_separator[1]))
        )
        lines = [(0, "#"), *lines[1:]]
    separator_names = [stated.separator] if stated.separator else list(SEPARATORS)
    layouts = [_layout_by(SEPARATORS[name], lines, stated) for name in separator_names]
    read = [layout for layout in layouts if layout is not None]
    if not read:
        raise _no_rows(lines, file)
    best = _only_consistent(read, file)
    best = best or max(read, key=lambda name: (name.complaint is None, len(name.headings)))
    if best.complaint:
        raise InputError(best.complaint[1], file, best.complaint[0])
    return best


def _only_consistent(layouts: list[TextLayout], file: Path) -> TextLayout | None:
    """The layout that all rows agree with; None: there is none.

    Raises:
        InputError: there are several.
    """
    fits = [layout for layout in layouts if layout.consistent]
    if len(fits) > 1 and fits[-1].separator == " ":  # Tabs are blanks too.
        fits.pop()
    if len(fits) > 1:
        words = " or ".join(WORDS[layout.separator] for layout in fits)
        message = (
            f"the columns may be separated by {words}; state it under [recording], as separator = "
        )
        raise InputError(f'{message}"{_key(fits[0].separator)}"', file, fits[0].header_line)
    return fits[0] if fits else None


def _key(separator: str) -> str:
    return next(key for key, sign in SEPARATORS.items() if sign == separator)


def _no_rows(lines: list[Line], file: Path) -> InputError:
    held = [number for number, line in lines if not is_comment(line)]
    if not held:
        return InputError("the file is empty; begin with a header such as 'time [s],p [kPa]'", file)
    return _rows_of_words(lines, file) or InputError(
        "there are no rows below the header: no line begins with a number and has several cells, "
        "separated by commas, semicolons, tabs or blanks",
        file,
        held[-1],
    )


def _rows_of_words(lines: list[Line], file: Path) -> InputError | None:
    """The error about the first line that begins with a number and goes on with words; None: there is none."""
    for number, line in lines[:LOOKED_AT]:
        for separator in SEPARATORS.values():
            with suppress(csv.Error):
                head, *more = split_cells(line, separator) or [""]
                words = [cell for cell in more if cell and not is_number(cell)]
                if words and is_number(head):
                    message = f"most cells of this row are no numbers, such as {shown(words[0])}"
                    hint = f"missing = {json.dumps([words[0]], ensure_ascii=False)}"
                    return InputError(
                        f"{message}; if it marks a missing sample, state {hint} under [recording]",
                        file,
                        number,
                    )
    return None


def _layout_by(separator: str, lines: list[Line], stated: Layout) -> TextLayout | None:
    """The layout by this separator; None when there are no rows."""
    stated_lines = (stated.header_line or 0, stated.units_line or 0)
    after = max(*stated_lines, labview_text.end_of_header(lines))
    layout = _layout_below(after, separator, lines, stated)
    if layout is None or not layout.complaint or any(stated_lines):
        return layout
    return _layout_further_down(layout.start, separator, lines, stated) or layout


def _layout_further_down(
    start: int, separator: str, lines: list[Line], stated: Layout
) -> TextLayout | None:
    """The layout of all rows below a header that stands lower than the first row, at ``start``; None: there is none.

    A logger that is switched on again while a line is written goes on with what it says of itself, and the header.
    """
    looked_at = lines[start : start + LOOKED_AT]
    rows = [_is_row(separator, line, stated.missing) for _, line in looked_at]
    for k in (k for k in range(1, len(rows) - 1) if not rows[k] and rows[k + 1]):
        layout = _layout_below(looked_at[k][0], separator, lines, stated)
        if layout is not None and layout.consistent:
            has_names = not any(is_number(heading) for heading, _ in layout.headings)
            return replace(layout, passed_over=sum(rows[:k])) if has_names else None
    return None


def _is_row(separator: str, line: str, missing: frozenset[str]) -> bool:
    with suppress(csv.Error):
        return is_row(split_cells(line, separator), missing)
    return False


def _layout_below(
    after: int, separator: str, lines: list[Line], stated: Layout
) -> TextLayout | None:
    """The layout of the rows below a line; None where there are none."""
    for kind in (partial(is_row, missing=stated.missing), is_dated_row, is_measured_row):
        rows, start = rows_of(separator, lines, after, kind)
        if start is not None:
            break
    else:
        return None
    start = first_row(rows, start)
    comments = [(number, line) for number, line in lines[: rows[start].index] if is_comment(line)]
    header = header_of(separator, rows[:start], rows[start].cells, comments, stated)
    if isinstance(header, str):
        return TextLayout(separator, (), 0, rows[start].index, False, (rows[start].number, header))
    headings = header.headings()
    kept_columns = [
        i for i, (heading, _) in enumerate(headings) if stated.keeps(heading, _name_in(heading))
    ]
    fits = all(
        _fits(row.cells, len(headings), kept_columns, stated.missing) for row in rows[start:]
    )
    return TextLayout(separator, headings, header.line, rows[start].index, fits)


def _name_in(heading: str) -> str:
    """The name in a heading, without its unit; "" where it holds none."""
    parts = split_heading(heading)
    return parts[0] if parts else ""


def _fits(cells: list[str], count: int, kept_columns: list[int], missing: frozenset[str]) -> bool:
    if len(cells) < count or any(cells[count:]):
        return False
    return all(
        not cells[i] or is_measured(cells[i]) or cells[i].casefold() in missing
        for i in kept_columns
    )


def decimal_sign(cells: Iterable[tuple[int, str]], separator: str, file: Path) -> str:
    """The sign before the decimals.

    Args:
        cells: number of the line and text of every cell that holds a number or something like it.

    Raises:
        InputError: all numbers with a sign could be grouped thousands.
    """
    if separator == ",":
        return "."
    example: tuple[int, str] | None = None
    by_groups = ""
    for line, cell in cells:
        sign = "," if "," in cell else "." if "." in cell else ""
        if sign and NUMBER.fullmatch(cell) and not _THOUSANDS.fullmatch(cell):
            return sign
        by_groups = by_groups or decimal_sign_of(cell)
        if sign and example is None:
            example = (line, cell)
    if by_groups or example is None:
        return by_groups or "."
    sign = "," if "," in example[1] else "."
    message = f"{shown(example[1])} may have decimals or be grouped by thousands, and no other number decides"
    hint = f'state decimal = "{sign}" under [recording], or write numbers without groups'
    raise InputError(f"{message}; {hint}", file, example[0])
