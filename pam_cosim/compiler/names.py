"""Dotted names; a part in quotation marks may be nearly any text, dots included (Modelica 3.6, section 2.3.1)."""

from __future__ import annotations

import re

from pam_cosim.compiler.lexer import KEYWORDS

PREDEFINED = frozenset(
    [
        "Real",
        "Integer",
        "Boolean",
        "String",
        "Clock",
        "ExternalObject",
        "StateSelect",
        "AssertionLevel",
        "Connections",
    ]
)
"""Types that the language has, which no class may take the name of (Modelica 3.6, sections 4.9 and 9.4)."""
_PART = re.compile(r"(?:'(?:[^'\\]|\\.)*'|[^.'])+", re.DOTALL)
_PLAIN = re.compile(r"[A-Za-z_][A-Za-z_0-9]*", re.ASCII)


def parts(name: str) -> list[str]:
    """The parts between the dots; what is no dotted name is one part."""
    matches = _PART.findall(name)
    return matches if matches and ".".join(matches) == name else [name]


def last(name: str) -> str:
    """The last part."""
    return parts(name)[-1]


def parent(name: str) -> str:
    """All parts but the last; empty where there is one."""
    return ".".join(parts(name)[:-1])


def unquoted(part: str) -> str:
    """What stands in the quotation marks, escapes as they are; a plain name as it is."""
    return part[1:-1] if len(part) > 1 and part[0] == part[-1] == "'" else part


def identifier(text: str) -> str:
    """A name for a class or component: the text itself, in quotation marks where it is no plain name.

    A name that has them already stays as it is; a character that no name may have becomes ``_``.
    """
    if (_PLAIN.fullmatch(text) and text not in KEYWORDS) or re.fullmatch(
        r"'(?:[^'\\]|\\.)+'", text
    ):
        return text
    return "'" + "".join(c if c.isprintable() and c not in "'\\" else "_" for c in text) + "'"
