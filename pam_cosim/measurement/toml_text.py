"""TOML text to plain data, the line on which a key stands (which ``tomllib`` does not tell), and texts as TOML."""

from __future__ import annotations

import json
import re
import tomllib
from bisect import bisect_left
from pathlib import Path
from typing import Any

from pam_cosim.errors import InputError

_PLACE = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)$")


def parse_toml(text: str, file: Path) -> dict[str, Any]:
    """The document as plain data.

    Raises:
        InputError: a syntax error, with line and column.
    """
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise InputError("the tables or arrays are nested too deeply", file) from None
    except ValueError as error:  # TOMLDecodeError, or an integer with thousands of digits
        message = str(error)
        place = _PLACE.search(message)
        line, column = (int(place[1]), int(place[2])) if place and place[1] else (text.count("\n") + 1, None)
        cause = _PLACE.sub("", message)
        raise InputError(f"this is not valid TOML: {cause}", file, line, column) from None


def line_of(text: str, path: tuple[str | int, ...]) -> int | None:
    """The line (from 1) on which the key at ``path`` first appears; of its nearest parent when it is missing.

    The text must be valid TOML. No second parser: the key stands on the line after the longest beginning of the
    text that parses and lacks it, and that is found by bisection.
    """
    lines = text.split("\n")

    def present(count: int) -> bool:
        return _holds(_shortest_beginning(lines, count), path)

    while path:
        if _holds(tomllib.loads(text), path):
            return bisect_left(range(len(lines) + 1), True, key=present)
        path = path[:-1]
    return None


def toml_string(text: str) -> str:
    """A TOML basic string; JSON's escapes are a subset of TOML's, but for the delete character."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def toml_key(name: str) -> str:
    """A key, in quotes where it needs them."""
    return name if name.isidentifier() and name.isascii() else toml_string(name)


def _shortest_beginning(lines: list[str], count: int) -> dict[str, Any]:
    """The content of the shortest valid beginning of the text with at least ``count`` lines."""
    while count < len(lines):
        try:
            return tomllib.loads("\n".join(lines[:count]).removesuffix("\r"))
        except ValueError:
            count += 1
    return tomllib.loads("\n".join(lines))


def _holds(content: Any, path: tuple[str | int, ...]) -> bool:
    for key in path:
        if isinstance(key, int):
            if not isinstance(content, list) or key >= len(content):
                return False
        elif not isinstance(content, dict) or key not in content:
            return False
        content = content[key]
    return True
