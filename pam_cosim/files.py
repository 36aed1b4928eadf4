"""Files are written whole or not at all."""

from __future__ import annotations

import json
import os
import tempfile
from pathlib import Path
from typing import Any

from pam_cosim.errors import InputError


def write_bytes(path: Path, content: bytes) -> None:
    """Writes ``content`` under a temporary name and moves it to ``path``.

    Raises:
        InputError: the folder does not exist or cannot be written.
    """
    try:
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
    except OSError as problem:
        raise InputError(f"cannot be written: {problem.strerror}", path) from problem
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(name, 0o666 & ~mask)
        os.replace(name, path)
    except OSError as problem:
        Path(name).unlink(missing_ok=True)
        raise InputError(f"cannot be written: {problem.strerror}", path) from problem


def write_text(path: Path, text: str) -> None:
    """As ``write_bytes``, for text."""
    write_bytes(path, text.encode())


def write_json(path: Path, content: Any) -> None:
    """As ``write_text``; numbers that do not exist become null."""
    write_text(path, json.dumps(_plain(content), indent=1, allow_nan=False) + "\n")


def read_json(path: Path) -> Any:
    """The content of a JSON file.

    Raises:
        InputError: the file is missing or is not JSON.
    """
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as problem:
        raise InputError(f"cannot be read: {problem.strerror}", path) from problem
    except UnicodeDecodeError as problem:
        raise InputError("cannot be read: it is not UTF-8 text", path) from problem
    except json.JSONDecodeError as problem:
        raise InputError(f"not JSON: {problem.msg}", path, problem.lineno, problem.colno) from problem
    except (RecursionError, ValueError) as problem:  # nested too deeply; an integer of thousands of digits
        raise InputError("not JSON that can be read: nested too deeply, or a number too long", path) from problem


def check_writable(path: Path) -> None:
    """Finds out before long work whether its result can be written.

    Raises:
        InputError: the folder does not exist or cannot be written.
    """
    if path.is_dir():
        raise InputError("is a folder; name a file", path)
    if not path.parent.is_dir():
        raise InputError("cannot be written: its folder does not exist", path)
    if not os.access(path.parent, os.W_OK):
        raise InputError("cannot be written: no permission for its folder", path)


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(k): _plain(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(v) for v in value]
    if hasattr(value, "item"):
        value = value.item()
    if isinstance(value, float) and not (abs(value) < float("inf")):
        return None
    return value
