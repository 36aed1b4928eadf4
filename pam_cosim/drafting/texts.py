"""What names of files and remarks above the rows say: a muscle, its length, quantities of a whole file."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from pam_cosim.drafting.headings import LENGTHS, Headings, Meaning, folded, known_unit
from pam_cosim.units import convert, parse_quantity

GRAVITY = "9.80665 m/s2"
"""By which a weight is a mass."""
_LONGEST_CONTRACTION = 0.1  # [m], of a length in a file's name that is taken as a contraction
# A hyphen behind a letter, a digit or a closing sign separates; behind a sign that separates, it is a minus.
_SIGN = r"(?P<sign>(?:(?<![^\s=_@:;,(\[-])-|\N{MINUS SIGN})?)"
_NUMBER = rf"{_SIGN}(?P<number>\d+(?:[.,]\d+|p\d+)?)"
_QUANTITY = re.compile(
    rf"(?:(?P<word>[a-z]+)[ =_-]?)?{_NUMBER}[ _-]?(?P<unit>%|[a-z]+)?(?![a-z0-9])", re.IGNORECASE
)
_SHARES = {"pct": "%", "percent": "%", "prozent": "%", "proz": "%"}
_KINDS = ("pressure", "force", "ratio", "contraction", "length")
_LOAD = re.compile(
    r"(?<![A-Za-z0-9])(?:(?P<number>\d+(?:[.,]\d+)?)[ _-]?(?P<unit>[A-Za-z]+)"
    r"|(?P<first>kg|lbs?)[ _-]?(?P<behind>\d+(?:[.,]\d+)?))(?![A-Za-z0-9])"
)
_MASSES, _WEIGHTS = ("kg", "g", "lb", "lbs"), ("N", "kN", "lbf")
_REMARK = re.compile(
    r"(?P<name>[^\W\d][^\d,;:=]*?)\s*[:=]?\s*(?P<number>[-+]?\d+(?:[.,]\d+)?)\s*(?P<unit>[^\s\d,;]+(?:\([ga]\))?)?(?=[\s,;.]|$)"
)


@dataclass(frozen=True)
class Said:
    """One quantity in a text: ``text`` as it stands there, ``word`` before it in small letters."""

    text: str
    word: str
    value: float
    unit: str
    kind: str


@dataclass(frozen=True)
class Remark:
    """A quantity that a line above the rows states."""

    text: str
    meaning: Meaning
    value: str


def said_in(stem: str, headings: Headings) -> list[Said]:
    """Every quantity that a text tells with its number."""
    found = []
    for match in _QUANTITY.finditer(stem):
        word = folded(match["word"] or "")
        kinds = [kind for kind in headings.kinds_of(word) if kind in _KINDS] if word else []
        size = float(match["number"].replace(",", ".").replace("p", "."))
        written = match["unit"] or ""
        unit = known_unit(_SHARES.get(folded(written), written))
        kind = _kind(kinds, unit, headings)
        if kind == "ratio" and not unit:
            unit = "%" if size >= 1.0 else "1"
        if kind and unit:
            text = match[0] if kinds else match[0][match.start("sign") - match.start() :]
            value = -size if match["sign"] else size
            found.append(Said(text.rstrip(" _-"), word if kinds else "", value, unit, kind))
    return found


def _kind(kinds: Sequence[str], unit: str, headings: Headings) -> str:
    """What a number is by the word before it and its unit; "" for neither."""
    if not unit:
        return "ratio" if "ratio" in kinds else ""
    if unit == "m" and not kinds:
        return "contraction"
    order = ("pressure", "contraction", "force") if unit != "%" else ("ratio",)
    kind = next((one for one in order if headings.fits(unit, one)), "")
    is_length = kind == "contraction" and "length" in kinds and "contraction" not in kinds
    return "length" if is_length else kind


def common_quantities(
    stems: Sequence[str], known: Iterable[str], headings: Headings
) -> list[list[Said]]:
    """For each quantity that every name tells once, and that no column of a kind ``known`` has: one for each name."""
    said, known = [said_in(stem, headings) for stem in stems], {*known}
    made = []
    for group in (("pressure",), ("force",), LENGTHS):
        if known & set(group):
            continue
        each = [[one for one in own if one.kind in group] for own in said]
        if group == ("force",) and not all(each) and all(map(headings.says_no_load, stems)):
            each = [[Said("no load", "", 0.0, "N", "force")] for _ in stems]
        chosen = [_imposed(own, each) if group == LENGTHS else own for own in each]
        alike = {(own[0].kind, own[0].unit) if len(own) == 1 else None for own in chosen}
        if len(alike) == 1 and None not in alike:
            made.append([own[0] for own in chosen])
    return made


def _imposed(own: Sequence[Said], each: Sequence[Sequence[Said]]) -> list[Said]:
    """What is called a contraction or a ratio; else a length that is short, or not the same in all names."""
    called = [one for one in own if one.kind == "ratio" or (one.kind == "contraction" and one.word)]
    if called:
        return called
    texts = [{one.text for one in other} for other in each]
    everywhere = set.intersection(*texts) if len(texts) > 1 else set()
    left = [one for one in own if one.text not in everywhere]
    short = _LONGEST_CONTRACTION
    return [
        one
        for one in left
        if one.kind == "length" or convert(abs(one.value), one.unit, "m") <= short
    ]


def muscle_in(texts: Sequence[str], known: Sequence[str]) -> tuple[str, str]:
    """The muscle of a library that every text tells, as ``DMSP-20-300``, and its length; "" where they do not."""
    told = {_muscle(text, known) for text in texts}
    if len(told) == 1:
        return told.pop()
    names = {name for name, _ in told}
    return (names.pop(), "") if len(names) == 1 else ("", "")


def _muscle(stem: str, known: Iterable[str]) -> tuple[str, str]:
    for name in sorted(known, key=len, reverse=True):
        letters, digits = re.fullmatch(r"(.*?)(\d*)", name.casefold()).groups()  # type: ignore[union-attr]
        length = r"(?:[ _-]?(\d{2,4})(?!\d|[.,]\d))?"
        text = rf"{re.escape(letters)}[ _-]?{digits}(?!\d){length}"
        if digits and (found := re.search(text, stem.casefold())):
            return name, f"{found[1]} mm" if found[1] else ""
    return "", ""


def load_in(stem: str, weights: bool) -> tuple[str, float] | None:
    """The mass that a name tells, or the ``weights``, as a mass: as it is written, and [kg]; None: neither."""
    for match in _LOAD.finditer(stem):
        number = (match["number"] or match["behind"]).replace(",", ".")
        unit = match["unit"] or match["first"]
        said = f"{number} {unit}"
        if unit in _MASSES:
            return said, parse_quantity(said, "kg")
        if unit in _WEIGHTS and weights:
            return said, parse_quantity(said, "N") / parse_quantity(GRAVITY, "m/s2")
    return None


def remarks_in(lines: Iterable[str], headings: Headings) -> Iterator[Remark]:
    """Quantities that lines above the rows state, as ``load mass: 3 kg``; a force in kilograms is a mass."""
    for line in lines:
        for match in _REMARK.finditer(line):
            unit = known_unit((match["unit"] or "").rstrip(".")) or ""
            name = match["name"].strip(" ,;:=")
            reading = headings.read(name, unit)
            meaning = reading.meaning
            if meaning is None or not (unit or reading.unit):
                continue
            written = unit or reading.unit
            if headings.fits(written, "mass"):
                meaning = Meaning("mass")
            yield Remark(
                match[0].strip(" ,;"), meaning, f"{match['number'].replace(',', '.')} {written}"
            )
