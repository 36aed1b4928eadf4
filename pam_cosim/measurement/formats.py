"""Which format a file has, by its ending, and the one reader of it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from pam_cosim.measurement.table import Layout, Table
from pam_cosim.measurement.text_table import read_text_table

_READERS: dict[str, Callable[[Path, Layout], Table]] = {}


def read_table(file: Path, stated: Layout | None = None) -> Table:
    """Reads a file of any format; what has no ending of a binary one is a text.

    Raises:
        InputError: see the reader of the format.
    """
    return _READERS.get(file.suffix.lower(), read_text_table)(file, stated or Layout())
