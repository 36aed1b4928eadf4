"""A report to a file."""

from __future__ import annotations

from pathlib import Path

from pam_cosim.files import PAGE, check_ending, check_writable, write_text


def write_report(path: Path | str, html: str) -> None:
    """Writes a report, whole or not at all.

    Raises:
        InputError: the folder does not exist or cannot be written.
    """
    check_ending(Path(path), "reports are written as HTML", PAGE)
    check_writable(Path(path))
    write_text(Path(path), html)
