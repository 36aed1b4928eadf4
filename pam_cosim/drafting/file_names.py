"""What the names of files say: a muscle, its length, and quantities that hold for a whole file."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.vocabulary import Meaning, folded, kinds_of, known_unit, says_no_load
from pam_cosim.drafting.words import LENGTHS
from pam_cosim.units import convert

_LONGEST_CONTRACTION = 0.1  # [m], of a length in a file's name that is taken as a contraction

# A hyphen behind a letter, a digit or a closing sign separates; behind a sign that separates, it is a minus.
_SIGN = r"(?P<sign>(?:(?<![^\s=_@:;,(\[-])-|\N{MINUS SIGN})?)"
_NUMBER = rf"{_SIGN}(?P<number>\d+(?:[.,]\d+|p\d+)?)"
_QUANTITY = re.compile(
    rf"(?:(?P<word>[a-z]+)[ =_-]?)?{_NUMBER}[ _-]?(?P<unit>%|[a-z]+)?(?![a-z0-9])", re.IGNORECASE
)
_UNITS = {"pct": "%", "percent": "%", "prozent": "%", "proz": "%"}
_KINDS = ("pressure", "force", "ratio", "contraction", "length")


@dataclass(frozen=True)
class Said:
    """One quantity in a file's name: ``text`` as it stands there, ``word`` before it in small letters."""

    text: str
    word: str
    value: float
    unit: str
    kind: str


@dataclass(frozen=True)
class Muscle:
    """The muscle that all names tell, and its length as a text, "" where they do not."""

    name: str
    length: str = ""


def muscle_in(texts: Sequence[str], known: Iterable[str]) -> Muscle | None:
    """The muscle of a library that every text tells, as ``DMSP-20-300``; None: they do not.

    Args:
        texts: what is said of each file: its name, and what a column of it repeats in every row.
        known: names of muscles.
    """
    told = {one for text in texts for one in [_muscle(text, known)]}
    first = next(iter(told)) if len(told) == 1 else None
    if first is not None or None in told:
        return first
    names = {one.name for one in told if one is not None}
    return Muscle(names.pop()) if len(names) == 1 else None


def _muscle(stem: str, known: Iterable[str]) -> Muscle | None:
    for name in sorted(known, key=len, reverse=True):
        letters, digits = re.fullmatch(r"(.*?)(\d*)", name.casefold()).groups()  # type: ignore[union-attr]
        if not digits:
            continue
        length = r"(?:[ _-]?(\d{2,4})(?!\d|[.,]\d))?"
        found = re.search(rf"{re.escape(letters)}[ _-]?{digits}(?!\d){length}", stem.casefold())
        if found:
            return Muscle(name, f"{found[1]} mm" if found[1] else "")
    return None


def quantities(
    files: Sequence[Path], columns: Sequence[RecordedColumn], counts: Sequence[int]
) -> list[RecordedColumn]:
    """What the name of every file says, as columns that do not change within a file.

    Args:
        columns: of the files: what one of them holds is not looked for in the names.
        counts: rows of each file.
    """
    said = [said_in(file.stem) for file in files]
    recorded = {c.meaning.kind for c in columns if c.meaning is not None and not c.meaning.roles}
    made = []
    for group in (("pressure",), ("force",), LENGTHS):
        if recorded & set(group):
            continue
        each = [[one for one in own if one.kind in group] for own in said]
        if group == ("force",) and not all(each) and all(says_no_load(file.stem) for file in files):
            each = [[Said("no load", "", 0.0, "N", "force")] for _ in files]
        one = _common(each, counts, group == LENGTHS)
        if one is not None:
            made.append(one)
    return made


def _common(
    each: Sequence[Sequence[Said]], counts: Sequence[int], lengths: bool
) -> RecordedColumn | None:
    """The quantity that each name tells once; of lengths, the one that is a contraction."""
    chosen = [_imposed(own, each) if lengths else own for own in each]
    if (
        not all(len(own) == 1 for own in chosen)
        or len({(own[0].kind, own[0].unit) for own in chosen}) != 1
    ):
        return None
    first = chosen[0][0]
    values = {
        i: np.full(count, own[0].value)
        for i, (own, count) in enumerate(zip(chosen, counts, strict=True))
    }
    texts = ", ".join(dict.fromkeys(own[0].text for own in chosen))
    why = (f"the names of the files say so: {texts}",)
    return RecordedColumn(
        texts, first.unit, False, Meaning(first.kind), values, why, known=1.0, in_names=True
    )


def _imposed(own: Sequence[Said], each: Sequence[Sequence[Said]]) -> list[Said]:
    """What is called a contraction or a ratio; else a length that is short, or not the same in all names."""
    called = [one for one in own if one.kind == "ratio" or (one.kind == "contraction" and one.word)]
    if called:
        return called
    texts = [{one.text for one in other} for other in each]
    everywhere = set.intersection(*texts) if len(texts) > 1 else set()
    left = [one for one in own if one.text not in everywhere]
    return [
        one
        for one in left
        if one.kind == "length" or convert(abs(one.value), one.unit, "m") <= _LONGEST_CONTRACTION
    ]


def said_in(stem: str) -> list[Said]:
    """Every quantity that a text tells with its number."""
    found = []
    for match in _QUANTITY.finditer(stem):
        word = folded(match["word"] or "")
        kinds = [kind for kind in kinds_of(word) if kind in _KINDS] if word else []
        size = float(match["number"].replace(",", ".").replace("p", "."))
        written = match["unit"] or ""
        unit = known_unit(_UNITS.get(folded(written), written))
        kind = _kind(kinds, unit)
        if kind == "ratio" and not unit:
            unit = "%" if size >= 1.0 else "1"
        if kind and unit:
            text = match[0] if kinds else match[0][match.start("sign") - match.start() :]
            value = -size if match["sign"] else size
            found.append(Said(text.rstrip(" _-"), word if kinds else "", value, unit, kind))
    return found


def _kind(kinds: Sequence[str], unit: str) -> str:
    """What a number is by the word before it and its unit; "" for neither."""
    if not unit:
        return "ratio" if "ratio" in kinds else ""
    by_unit = {
        "%": "ratio",
        "N": "force",
        "kN": "force",
        "mm": "contraction",
        "cm": "contraction",
        "m": "contraction",
    }
    by_unit |= dict.fromkeys(("kPa", "bar", "MPa", "psi", "mbar", "Pa"), "pressure")
    kind = by_unit.get(unit, "")
    return (
        "length"
        if kind == "contraction" and "length" in kinds and "contraction" not in kinds
        else kind
    )
