"""Reads a text file that a person or a program wrote, or raises the reason why it cannot be read."""

from __future__ import annotations

import codecs
import re
from pathlib import Path

from pam_cosim.errors import InputError
from pam_cosim.files import MOST_BYTES, read_file
from pam_cosim.measurement.table import check_content
from pam_cosim.measurement.workbook import WORKBOOKS, sheet_text
from pam_cosim.wording import shown

_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),  # begins as that of UTF-16 does
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_NO_TEXT = re.compile(rb"[\x00-\x08\x0e-\x1f\x81\x8d\x8f\x90\x9d]")
WESTERN = "cp1252"
_MOST = 20_000_000  # bytes of a text that a person wrote
_MOST_OF_TABLE = (
    400_000_000  # bytes of a text that a program wrote; read, it takes several times as many
)


def read_text(path: Path) -> str:
    """The file's text, UTF-8 with or without byte order mark.

    Raises:
        InputError: the file is missing, not readable or not UTF-8 (with the line of the first bad byte).
    """
    return _decoded(read_bytes(path, _MOST), "utf-8-sig", path)


def read_any_text(
    path: Path, encoding: str | None = None, sheet: str | None = None
) -> tuple[str, str]:
    """The file's text and its encoding: the stated one, that of a byte order mark, UTF-8, or Western European.

    The text of a workbook is that of one ``sheet``.

    What is not UTF-8 is read as Windows-1252, of which Latin-1 is a part. Were it another encoding, only letters of
    names and units would be wrong, which then fit nothing.

    Raises:
        InputError: as ``read_text``; an unknown encoding; no text; as ``sheet_text``.
    """
    data = read_bytes(path, _MOST_OF_TABLE)
    check_content(data, path)
    if path.suffix.lower() in WORKBOOKS:
        return sheet_text(path, sheet), "utf-8"
    return any_text(data, path, encoding)


def any_text(data: bytes, path: Path, encoding: str | None = None) -> tuple[str, str]:
    """The text of bytes that were read from a file, or from its beginning, and their encoding: ``read_any_text``.

    Raises:
        InputError: an unknown encoding; no text.
    """
    if encoding is not None:
        return _decoded(data, encoding, path), encoding
    for mark, name in _MARKS:
        if data.startswith(mark):
            return _decoded(data, name, path), name
    other = _NO_TEXT.search(data)
    try:
        if b"\0" not in data[:4]:
            return data.decode("utf-8"), "utf-8"
    except UnicodeDecodeError:
        pass
    if other is None:
        return data.decode(WESTERN), WESTERN
    line = data.count(b"\n", 0, other.start()) + 1
    message = f"byte 0x{other[0][0]:02x} is no text, neither UTF-8 nor Western European"
    likely = "utf-16-be" if data.startswith(b"\0") else "utf-16-le"
    raise InputError(
        f'{message}; state the encoding under [recording], such as encoding = "{likely}"',
        path,
        line,
    )


def read_bytes(path: Path, most: int = MOST_BYTES) -> bytes:
    """The file's bytes.

    Raises:
        InputError: the file is missing, not readable, no regular file, or has more bytes than ``most``.
    """
    try:
        return read_file(path, most)
    except FileNotFoundError:
        raise InputError("the file does not exist", path) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(f"the file cannot be read: {reason}", path) from None


def _decoded(data: bytes, encoding: str, path: Path) -> str:
    try:
        return data.decode(encoding)
    except (LookupError, ValueError) as error:
        if not isinstance(error, UnicodeDecodeError):
            raise InputError(f"there is no encoding {shown(encoding)} of texts", path) from None
        line = data.count(b"\n", 0, error.start) + 1
        name = "UTF-8" if encoding == "utf-8-sig" else encoding
        message = f"byte 0x{data[error.start]:02x} is not {name} text; save the file with the encoding UTF-8"
        raise InputError(message, path, line) from None
