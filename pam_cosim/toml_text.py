"""TOML text to plain data, the line on which a key stands (which ``tomllib`` does not report), and texts as TOML."""

from __future__ import annotations

import json
import re
import tomllib
from bisect import bisect_left
from pathlib import Path
from typing import Any

from pam_cosim.errors import InputError

_MOST_PARSED = 3_000_000  # letters, about a second
_PARTS = 40
_PART = r"""(?:[\w-]+|"[^"\n]{0,200}"|'[^'\n]{0,200}')[ \t]{0,9}"""
_DEEP_KEY = re.compile(
    rf"(?:^|[\[{{,])[ \t]{{0,99}}(?:{_PART}\.[ \t]{{0,9}}){{{_PARTS}}}", re.MULTILINE
)
_PLACE = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)$")


def parse_toml(text: str, file: Path) -> dict[str, Any]:
    """The document as plain data.

    Raises:
        InputError: a syntax error, with line and column.
    """
    deep = _DEEP_KEY.search(text)
    if deep is not None:
        line = text.count("\n", 0, deep.start()) + 1
        raise InputError(
            f"a key of more than {_PARTS} parts: names with a dot need quotes", file, line
        )
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise InputError("the tables or arrays are nested too deeply", file) from None
    except ValueError as error:  # TOMLDecodeError, or an integer with thousands of digits
        message = str(error)
        place = _PLACE.search(message)
        line, column = (
            (int(place[1]), int(place[2])) if place and place[1] else (text.count("\n") + 1, None)
        )
        cause = _PLACE.sub("", message)
        raise InputError(f"this is not valid TOML: {cause}", file, line, column) from None


def line_of(text: str, path: tuple[str | int, ...]) -> int | None:
    """The line (from 1) on which the key at ``path`` first appears; of its nearest parent when it is missing.

    The text must be valid TOML. No second parser: the key stands on the line after the longest beginning of the
    text that parses and lacks it, and that is found by bisection. Where that takes too long, because values span
    thousands of lines, it is the first line with the key's name.
    """
    try:
        return _exact_line(text.split("\n"), path)
    except _TooLong:
        return _named_line(text.split("\n"), path)


class _TooLong(Exception):
    """Parsing beginnings of a text takes too long."""


class _Beginnings:
    """Beginnings of a text, as far as they parse, within a budget of letters."""

    def __init__(self, lines: list[str]) -> None:
        self.lines, self.left = lines, _MOST_PARSED

    def parsed(self, count: int) -> dict[str, Any]:
        """The content of a number of lines.

        Raises:
            ValueError: they are no whole document.
        """
        text = "\n".join(self.lines[:count])
        self.left -= len(text)
        if self.left < 0:
            raise _TooLong
        return tomllib.loads(text.removesuffix("\r") if count < len(self.lines) else text)

    def shortest(self, count: int) -> dict[str, Any]:
        """The content of the shortest valid beginning of the text with at least ``count`` lines."""
        while count < len(self.lines):
            try:
                return self.parsed(count)
            except ValueError:
                count += 1
        return self.parsed(count)


def _named_line(lines: list[str], path: tuple[str | int, ...]) -> int | None:
    name = next((str(part) for part in reversed(path) if isinstance(part, str)), "")
    return next(
        (number for number, line in enumerate(lines, start=1) if name and name in line), None
    )


def _exact_line(lines: list[str], path: tuple[str | int, ...]) -> int | None:
    beginnings = _Beginnings(lines)

    def present(count: int) -> bool:
        return _holds(beginnings.shortest(count), path)

    document = beginnings.parsed(len(lines))
    while path:
        if _holds(document, path):
            return bisect_left(range(len(lines) + 1), True, key=present)
        path = path[:-1]
    return None


def toml_string(text: str) -> str:
    """A TOML basic string; JSON's escapes are a subset of TOML's, but for the delete character."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def toml_key(name: str) -> str:
    """A key, in quotes where it needs them."""
    return name if name.isidentifier() and name.isascii() else toml_string(name)


def _holds(content: Any, path: tuple[str | int, ...]) -> bool:
    for key in path:
        if isinstance(key, int):
            if not isinstance(content, list) or key >= len(content):
                return False
        elif not isinstance(content, dict) or key not in content:
            return False
        content = content[key]
    return True
