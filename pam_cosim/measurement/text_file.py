"""Reads a text file that a person wrote, or says why it cannot be read."""

from __future__ import annotations

from pathlib import Path

from pam_cosim.errors import InputError


def read_text(path: Path) -> str:
    """The file's text, UTF-8 with or without byte order mark.

    Raises:
        InputError: the file is missing, not readable or not UTF-8 (with the line of the first bad byte).
    """
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        raise InputError("the file does not exist", path) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(f"the file cannot be read: {reason}", path) from None
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        message = f"byte 0x{data[error.start]:02x} is not UTF-8 text; save the file with the encoding UTF-8"
        raise InputError(message, path, line) from None
