"""Modelica text to tokens (Modelica 3.6, appendix A.1)."""

from __future__ import annotations

import re
from typing import NamedTuple

from pam_cosim.compiler.source import SourceText

_KEYWORD_LIST = """
algorithm and annotation assert block break class connect connector constant constrainedby der discrete each else
elseif elsewhen encapsulated end enumeration equation expandable extends external false final flow for function if
import impure in initial inner input loop model not operator or outer output package parameter partial protected
public pure record redeclare replaceable return stream then true type when while within
"""
KEYWORDS = frozenset(_KEYWORD_LIST.split())

_TOKEN = re.compile(
    r"""(?P<space>\s+|//[^\n]*|/\*.*?\*/)
      | (?P<name>[A-Za-z_][A-Za-z_0-9]*|'(?:[^'\\]|\\.)*')
      | (?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)
      | (?P<string>"(?:[^"\\]|\\.)*")
      | (?P<symbol>\.\+|\.-|\.\*|\./|\.\^|:=|==|<>|<=|>=|[-+*/^<>=()\[\]{},;:.])""",
    re.VERBOSE | re.DOTALL,
)


class Tokens(NamedTuple):
    """Parallel lists.

    Attributes:
        kinds: keyword and symbol texts as they are, or ``name``, ``number``, ``string``, ``end of file``.
        texts: the text of each token.
        offsets: the place of its first character.
    """

    kinds: list[str]
    texts: list[str]
    offsets: list[int]


def is_flat(source: SourceText) -> bool:
    """Whether a text is Base Modelica, as tools write flat models."""
    return source.text.startswith("//! base")


def tokenise(source: SourceText) -> Tokens:
    """All tokens of a source, comments and white space dropped.

    In Base Modelica a name in quotation marks is the dotted name of what was flattened: it is taken without them.

    Raises:
        ModelError: a character that starts no token (an unclosed string or comment included).
    """
    tokens = Tokens([], [], [])
    add_kind, add_text, add_offset = tokens.kinds.append, tokens.texts.append, tokens.offsets.append
    position, text = 0, source.text
    unquoted = is_flat(source)
    match = _TOKEN.match
    while position < len(text):
        token = match(text, position)
        if token is None:
            what = {'"': "string is not closed", "/": "comment is not closed"}.get(text[position])
            raise source.error(what or f"unexpected character {text[position]!r}", position)
        kind = token.lastgroup
        if kind == "name" and not token.group().isprintable():
            bad = next(i for i, c in enumerate(token.group()) if not c.isprintable())
            raise source.error(
                f"a name must not hold the character {token.group()[bad]!r}", position + bad
            )
        if kind != "space":
            word = token.group()
            is_literal = kind in ("number", "string") or (kind == "name" and word not in KEYWORDS)
            add_kind(str(kind) if is_literal else word)
            add_text(word[1:-1] if unquoted and word[0] == "'" else word)
            add_offset(position)
        position = token.end()
    add_kind("end of file")
    add_text("end of file")
    add_offset(len(text))
    return tokens
