"""The words by which people call what they measure, in English, German and French, and what they mean.

The same words read the headings of a recording and the descriptions of a bench's inputs and outputs, so that one finds
the other. Folded: small letters without accents. A long word may stand within another ("Muskeldruck"), a short one
stands alone.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from pam_cosim.drafting.words import (
    ABSOLUTE,
    ANY_PRESSURE,
    ATMOSPHERE,
    COUNTS,
    DIRECTIONS,
    KINDS,
    MEASURED_IN_COUNTS,
    NEEDING_UNITS,
    NO_LOAD,
    OF_VALVES,
    ROLES,
    SAID_IN_PASSING,
    SAYS_SURELY,
    SPELLINGS,
    STANDS_FOR,
    TRANSMITTED,
    UNITS,
    USUAL_UNITS,
    WITHOUT_ROLES,
)
from pam_cosim.measurement.table import is_unit
from pam_cosim.units import UnitError, convert, is_dimensionless, pressure_reference
from pam_cosim.wording import shown

_AT_END = re.compile(
    r"(?P<name>.+?)(?:\s*\((?P<round>.+)\)|\s+(?:/|in)\s+(?P<over>.+)|[\s_]+(?P<part>\d[^\s_]*))"
)
_SIZE = r"\d+(?:[.,]\d+)?(?:e[+-]?\d+)?(?:\^[+-]?\d+)?"
_FACTOR = re.compile(
    rf"(?:[x×*]\s*)?{_SIZE}(?:/{_SIZE})?\s*[x×*·]?\s*(?P<behind>\D.*)|(?P<before>\D.*?)\s*[/x×*·]\s*{_SIZE}"
)


@dataclass(frozen=True)
class Meaning:
    """What a column or a variable is: a kind of ``UNITS`` and what tells it from others of its kind."""

    kind: str
    roles: frozenset[str] = frozenset()

    def __str__(self) -> str:
        return " ".join([*sorted(self.roles), self.kind])


AT_REST = Meaning("length", frozenset({"rest"}))
"""The length of a muscle at rest, in a column."""


@dataclass(frozen=True)
class Heading:
    """What a heading says.

    Attributes:
        meaning: None where no word is known.
        unit: as pint reads it; "" where none is written.
        written: the unit as it stands in the file's place for units is ``unit``.
        unknown: the unit that is written, where nobody knows how large it is, or with a factor; else "".
        absolute: it says that the pressure is absolute.
        known: how many of its words are known, of all: the larger share names it better.
    """

    meaning: Meaning | None
    unit: str
    written: bool
    unknown: str = ""
    absolute: bool = False
    known: float = 0.0


def folded(text: str) -> str:
    """Small letters without accents."""
    plain = unicodedata.normalize("NFKD", text.casefold())
    return "".join(c for c in plain if not unicodedata.combining(c))


def read_heading(name: str, unit: str) -> Heading:
    """What a column is, by its name and unit."""
    stated = "" if is_count(unit) else known_unit(unit)
    absolute = _says_absolute(unit, name)
    written_unit = unit.strip() or scaled_unit(name)
    if not written_unit:
        stated, name = _unit_in_name(name)
        if is_count(stated):
            stated, written_unit = "", stated
    small = [folded(word) for word in split_words(name)]
    meaning = _meaning(small, stated or _unit_with_factor(written_unit))
    known = [word for i, word in enumerate(small) if _kinds_of(word, i) or _roles_of([word])]
    share = len(known) / len(small) if small else 0.0
    unknown = "" if stated or is_dimensionless(written_unit) else written_unit
    written = bool(stated) and stated == unit.strip()
    return Heading(meaning, stated, written, unknown, absolute, share)


def says_time(name: str, unit: str = "") -> bool:
    """Whether a heading is that of a time."""
    meaning = read_heading(name, unit).meaning
    return meaning is not None and meaning.kind == "time"


def scaled_unit(name: str) -> str:
    """A unit with a factor that a name ends with, ``Pressure (10^5 Pa)``, ``x in mm/10``, ``Time_10ms``; "" for none.

    Without a sign that sets it apart, a number may be a range or a level, but of a time.
    """
    match = _AT_END.fullmatch(name)
    if match is None:
        return ""
    kinds = _kinds_in([folded(word) for word in split_words(match["name"])])
    part = match["part"] if "time" in kinds else None
    text = match["round"] or match["over"] or part or ""
    unit = _unit_with_factor(text)
    needing = NEEDING_UNITS.intersection(kinds or NEEDING_UNITS)
    return text if unit and any(fits(unit, kind) for kind in needing) else ""


def _unit_with_factor(text: str) -> str:
    """The unit of a text such as ``x10^5 Pa`` or ``mm/10``; "" where it is another text."""
    match = _FACTOR.fullmatch(text)
    return known_unit(match["before"] or match["behind"]) if match else ""


def contradiction(name: str, unit: str) -> str:
    """What the words of a name say without doubt, and what its unit says instead; "" where they agree.

    A current is a valve's or a transmitter's: any word for what is measured says whose.
    """
    words = [folded(word) for word in split_words(name)]
    possible = _kinds_in(words)
    named = [kind for kind, surely in SAYS_SURELY.items() if any(map(surely.fullmatch, words))]
    if fits(unit, "current"):
        named += [kind for kind in possible if kind in TRANSMITTED]
    kinds = (*SAYS_SURELY, "length", "time", "current")
    by_unit = next((kind for kind in kinds if fits(unit, kind)), "")
    if not named or not by_unit or _kinds_with(unit).intersection([*named, *possible]):
        return ""
    return f"its name says {named[0]}, its unit {shown(unit)} says {by_unit}"


def _says_absolute(unit: str, name: str) -> bool:
    """Whether a heading says that a pressure is absolute: by a word, by its unit, or by one in its name: ``p_psia``."""
    units = [unit, *re.split(r"[\W_]+", name)]
    by_unit = any(pressure_reference(one)[1] == "absolute" for one in units)
    return by_unit or any(ABSOLUTE.fullmatch(folded(word)) for word in split_words(name))


def direction_word(word: str) -> int:
    """1 where a word says that a muscle contracts or its pressure rises, -1 the other way; 0: it says neither."""
    text = folded(word)
    for way, said in DIRECTIONS:
        if _among(text, said):
            return way
    return 0


def says_no_load(text: str) -> bool:
    """Whether a text, such as a file's name, says that a muscle pulled at nothing."""
    plain = re.sub(r"[\W_]+", "", folded(text))
    return any(word in plain for word in NO_LOAD)


@lru_cache(maxsize=4096)
def read_variable(name: str, description: str, unit: str) -> Meaning | None:
    """What an input or output of a bench is, by its unit and what is said of it."""
    said = [folded(word) for word in split_words(description)]
    words = [folded(word) for word in split_words(name)] + [
        word for word in said if word not in SAID_IN_PASSING
    ]
    return _meaning(words, unit or "1", exact=True)


def known_unit(unit: str) -> str:
    """The unit as the registry of units has it, without what a pressure is counted from; "" where it is none.

    Where only capitals tell units apart, the usual one is meant: nobody measures muscles in Mbar or mPa.
    """
    text = pressure_reference(unit.strip())[0]
    usual = SPELLINGS.get(folded(text), "")
    if usual:
        return usual
    return text if text and is_unit(text) and not text.isdigit() else ""


def is_count(unit: str) -> bool:
    """Whether a unit is one of a converter, a camera or a bridge, of which only the lab knows how large it is."""
    return folded(unit.strip()) in COUNTS.split()


@lru_cache(maxsize=4096)
def kinds_of(word: str) -> tuple[str, ...]:
    """What a word in small letters means."""
    return tuple(kind for kind, listed in KINDS.items() if _among(word, listed))


def usual_unit(kind: str, largest: float) -> str:
    """The unit that numbers of a kind most likely have, by their largest magnitude."""
    return next((unit for most, unit in USUAL_UNITS.get(kind, ()) if largest <= most), "")


@lru_cache(maxsize=4096)
def fits(unit: str, kind: str) -> bool:
    """Whether numbers of this unit are of that kind."""
    try:
        convert(0.0, unit, UNITS[kind])
    except UnitError:
        return False
    return True


def split_words(text: str) -> list[str]:
    """``uDruck_1``, ``p kPa`` and ``SollDruck`` in words; numbers are left out."""
    apart = re.sub(r"(?<=[a-zäöüß])(?=[A-Z][a-zäöü])", " ", text)
    return [
        word
        for word in re.split(r"[\W_]+|(?<=[^\W\d])(?=\d)|(?<=\d)(?=[^\W\d])", apart)
        if word and not word.isdigit()
    ]


def _unit_in_name(name: str) -> tuple[str, str]:
    """A unit that stands behind a name, and the name without: ``p_kPa``, ``source kPa gauge``; "20 kPa" is a value."""
    share = re.fullmatch(r"(.*?\w)\s*[/_]?\s*%", name)
    if share:
        return "%", share[1]
    parts = [part for part in re.split(r"[\W_]+", name) if part]
    for place in range(len(parts) - 1, 0, -1):
        rest = parts[:place] + parts[place + 1 :]
        unit = _unit_beside(parts[place], rest)
        if unit and split_words(" ".join(rest)):
            return unit, " ".join(rest)
    return "", name


def _unit_beside(part: str, rest: Sequence[str]) -> str:
    """The unit that a part of a name is, if it can be one of what the other parts say; "" where it is none."""
    unit, said = known_unit(part), _kinds_in([folded(w) for one in rest for w in split_words(one)])
    if is_count(part):
        return part if MEASURED_IN_COUNTS.intersection(said) else ""
    if len(part) == 1 and not (is_unit(part) and (part.isupper() or unit == part)):
        return ""
    kinds = set(said)
    of_length = {UNITS[kind] for kind in kinds} == {"m"}  # it has neither inlet nor exhaust
    if not unit or (_is_role(part, rest) and not of_length):
        return ""
    # "valve_A", "valve_A1" and "F_g" name valves and a weight.
    is_word = len(part) > 1 and part.isalpha()
    among = _kinds_with(unit) if is_word else {kind for kind in UNITS if fits(unit, kind)}
    says_so = bool(among & kinds) if kinds else bool(among) and len(part) > 1
    return unit if says_so or "voltage" in among else ""


def _kinds_with(unit: str) -> set[str]:
    """What has numbers of this unit, or is also measured in it."""
    kinds = {kind for kind in UNITS if fits(unit, kind)}
    return kinds.union(*(STANDS_FOR.get(kind, ()) for kind in kinds))


def _is_role(part: str, rest: Sequence[str]) -> bool:
    """Whether a part of a name says which quantity it is, as "in" and "atm" do that are units too.

    Behind the name of one pressure "atm" is its unit: ``pm_atm``, ``p_set_atm``.
    """
    word = folded(part)
    if word == ATMOSPHERE and [folded(one) for one in rest] not in ([one] for one in ANY_PRESSURE):
        return False
    return bool(_roles_of([word]))


def _meaning(words: list[str], unit: str, *, exact: bool = False) -> Meaning | None:
    named = _kinds_in(words)
    roles = _roles_of(words)
    kind = _kind_with_unit(named, unit, exact) if unit else _kind_without_unit(named, roles)
    if kind is None:
        return None
    if kind in WITHOUT_ROLES:
        return Meaning(kind)
    of_valves = set(OF_VALVES)
    return Meaning(
        kind, frozenset(roles & of_valves if kind in ("command", "current") else roles - of_valves)
    )


def _kind_without_unit(named: Sequence[str], roles: set[str]) -> str | None:
    """What the words say first; a commanded current or contraction is a command, an ambient T no time."""
    if "ambient" in roles and "temperature" in named:
        return "temperature"
    kind = named[0] if named else None
    return "command" if "command" in named and kind in ("current", "contraction") else kind


def _kind_with_unit(named: Sequence[str], unit: str, exact: bool) -> str | None:
    """What the words say among what has the unit; without words, what usually has it."""
    possible = [kind for kind in UNITS if fits(unit, kind)]
    kind = next((one for one in named if one in possible), None)
    if kind is None and "ratio" in possible and _is_length(named):
        kind = "ratio"
    if kind is None:
        kind = _usual_kind(possible, exact)
    if kind in ("contraction", "ratio", "command") and "ratio" in possible:
        kind = _kind_of_ratio(named)
    weighed = kind == "mass" or (kind is None and "mass" in possible)
    return "force" if weighed and "force" in named else kind


def _is_length(named: Sequence[str]) -> bool:
    return "contraction" in named or "length" in named


def _kind_of_ratio(named: Sequence[str]) -> str | None:
    """What a number without a unit is: a share of a length, or a command."""
    if _is_length(named) or "ratio" in named:
        return "ratio"
    return "command" if "command" in named else None


def _usual_kind(possible: Sequence[str], exact: bool) -> str | None:
    """What a unit alone says."""
    if not possible or (exact and possible[0] == "ratio"):
        return None
    if "contraction" in possible:
        return "contraction"
    return None if "ratio" in possible else possible[0]


def _kinds_in(words: list[str]) -> list[str]:
    return [kind for i, word in enumerate(words) for kind in _kinds_of(word, i)]


def _kinds_of(word: str, place: int) -> tuple[str, ...]:
    """What a word means; one letter means something at the beginning only."""
    if len(word) == 1 and place > 0:
        return ()
    return kinds_of(word)


def _roles_of(words: list[str]) -> set[str]:
    return {role for role, listed in ROLES.items() if any(_among(word, listed) for word in words)}


def _among(word: str, listed: str) -> bool:
    return any(word == one[1:] if one[0] == "=" else one in word for one in listed.split())
