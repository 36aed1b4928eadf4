"""Any text as a string literal of C: the one way from a model's names and messages into C source."""

from __future__ import annotations

from collections.abc import Iterable

# What stands for itself. Not among them: the quotation mark and the backslash, which end or change a literal; the
# question mark, which begins a trigraph; the per cent sign, which would begin a conversion in a format.
_PLAIN = frozenset(
    b"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 _.,:;()[]<>=+-*/^"
)


def c_string(text: str) -> str:
    """A literal with the bytes of the text in UTF-8; all but the plainest are written as three octal digits."""
    data = text.encode("utf-8", "replace")
    return '"' + "".join(chr(b) if b in _PLAIN else f"\\{b:03o}" for b in data) + '"'


def c_array(kind: str, name: str, items: Iterable[str]) -> str:
    """A static table; an empty one holds a zero, for C has no empty arrays."""
    return f"static {kind} {name}[] = {{{', '.join(items) or '0'}}};"
