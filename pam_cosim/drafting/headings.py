"""What headings, descriptions of variables, names of files and remarks mean by the vocabulary of a library."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from functools import lru_cache
from math import inf

from pam_cosim.measurement.table import is_unit
from pam_cosim.model.interface import Variable
from pam_cosim.model.vocabulary import Vocabulary
from pam_cosim.units import (
    UnitError,
    convert,
    is_dimensionless,
    parse_quantity,
    pressure_reference,
)
from pam_cosim.wording import shown

LENGTHS = ("contraction", "length", "ratio")
MECHANICAL = (*LENGTHS, "force")
VALVES = frozenset(("inlet", "exhaust"))
_TIME = "time|zeit|temps"
_ANY_PRESSURE = ("p", "press", "pressure", "druck", "pression")
_ABSOLUTE = re.compile(r"abs|pabs|absol.*")
_STANDS_FOR = {"ratio": ("contraction", "length"), "mass": ("force",), "current": ("command",)}
_SIZE = r"\d+(?:[.,]\d+)?(?:e[+-]?\d+)?(?:\^[+-]?\d+)?"
_FACTOR = re.compile(
    rf"(?:[x×*]\s*)?{_SIZE}(?:/{_SIZE})?\s*[x×*·]?\s*(?P<behind>\D.*)|(?P<before>\D.*?)\s*[/x×*·]\s*{_SIZE}"
)
_AT_END = re.compile(
    r"(?P<name>.+?)(?:\s*\((?P<round>.+)\)|\s+(?:/|in)\s+(?P<over>.+)|[\s_]+(?P<part>\d[^\s_]*))"
)


@dataclass(frozen=True)
class Meaning:
    """A kind of the vocabulary, "" where it is unknown, and the roles that distinguish a quantity within its kind."""

    kind: str
    roles: frozenset[str] = frozenset()

    def __str__(self) -> str:
        return " ".join([*sorted(self.roles), self.kind])

    def __bool__(self) -> bool:
        return bool(self.kind)


def meant(kind: str, *roles: str) -> Meaning:
    """A kind with just these roles."""
    return Meaning(kind, frozenset(roles))


UNKNOWN, PRESSURE, SET_PRESSURE = meant(""), meant("pressure"), meant("pressure", "set")
AT_REST = meant("length", "rest")
"""The length of a muscle at rest, in a column."""


@dataclass(frozen=True)
class Heading:
    """The reading of a heading.

    Attributes:
        unit: as pint reads it; "" where none is written.
        written: the unit as it stands in the file's place for units is ``unit``.
        unknown: the unit that is written, where its size is unknown, or with a factor; else "".
        absolute: it states an absolute pressure.
        known_share: share of its words that are known; a larger share names the quantity better.
    """

    meaning: Meaning
    unit: str
    written: bool
    unknown: str = ""
    absolute: bool = False
    known_share: float = 0.0


def folded(text: str) -> str:
    """Small letters without accents."""
    plain = unicodedata.normalize("NFKD", text.casefold())
    return "".join(c for c in plain if not unicodedata.combining(c))


def split_words(text: str) -> list[str]:
    """``uDruck_1``, ``p kPa`` and ``SollDruck`` in words, in small letters; numbers are left out."""
    apart = re.sub(r"(?<=[a-zäöüß])(?=[A-Z][a-zäöü])", " ", text)
    parts = re.split(r"[\W_]+|(?<=[^\W\d])(?=\d)|(?<=\d)(?=[^\W\d])", apart)
    return [folded(word) for word in parts if word and not word.isdigit()]


@lru_cache(maxsize=4096)
def alike(unit: str, other: str) -> bool:
    """Whether numbers of a unit can be converted to another one."""
    try:
        convert(0.0, unit, other)
    except UnitError:
        return False
    return True


def _among(word: str, listed: str) -> bool:
    return any(word == p[1:] if p[0] == "=" else p in word for p in listed.split())


class Headings:
    """Reads headings and descriptions by a vocabulary.

    Args:
        vocabulary: of the library.
        opening: unit of what opens the valves, by their data sheet; "": not stated.
    """

    def __init__(self, vocabulary: Vocabulary, opening: str = "") -> None:
        self.vocabulary, self._opening = vocabulary, opening
        self.units = {kind: unit for kind, unit, _, _ in reversed(vocabulary.kinds)}
        self.kinds_of = lru_cache(maxsize=4096)(self._kinds_of)
        self.meaning_of = lru_cache(maxsize=4096)(self._meaning_of)
        self._traits = {kind: set(traits.split()) for kind, _, traits, _ in vocabulary.kinds}
        self._spellings = {
            spelling: unit
            for unit, spellings in vocabulary.spellings
            for spelling in spellings.split(", ")
        }

    def with_trait(self, *traits: str) -> set[str]:
        """The kinds that have one of these traits."""
        return {kind for kind, has in self._traits.items() if has.intersection(traits)}

    def is_count(self, unit: str) -> bool:
        """Whether a unit is one of a converter, a camera or a bridge, of which only the lab knows how large it is."""
        return folded(unit.strip()) in self.vocabulary.counts

    def known_unit(self, unit: str) -> str:
        """The unit as the registry of units has it, without what a pressure is counted from; "" where it is none.

        Where only capitals distinguish units, the usual one is meant: muscles are not measured in Mbar or mPa.
        """
        text = pressure_reference(unit.strip())[0]
        is_written = bool(text) and is_unit(text) and not text.isdigit()
        return self._spellings.get(folded(text), "") or (text if is_written else "")

    def read(self, name: str, unit: str) -> Heading:
        """What a column is, by its name and unit."""
        stated = "" if self.is_count(unit) else self.known_unit(unit)
        absolute = _says_absolute(unit, name)
        written_unit = unit.strip() or self.scaled_unit(name)
        if not written_unit:
            stated, name = self._unit_in_name(name)
            if self.is_count(stated):
                stated, written_unit = "", stated
        # Of a path, ``Model Root/ADC/p``, the last part names the quantity, if it has a known word.
        parts = [split_words(part) for part in re.split(r"[/\\|.]", name)]
        parts = [part for part in parts if part not in (["in"], ["out"])] or parts  # of a block
        if self._kinds_in(parts[-1]):
            parts = parts[::-1]
        words = [word for part in parts for word in part]
        meaning = self._meaning(words, stated or self._unit_with_factor(written_unit))
        recognised = [w for i, w in enumerate(words) if self._kinds_at(w, i) or self._roles([w])]
        return Heading(
            meaning,
            stated,
            bool(stated) and stated == unit.strip(),
            "" if stated or is_dimensionless(written_unit) else written_unit,
            absolute,
            len(recognised) / (len(words) or 1),
        )

    def says_time(self, name: str, unit: str = "") -> bool:
        """Whether a heading is that of a time."""
        return self.read(name, unit).meaning.kind == "time"

    def time_of(self, name: str, names: Collection[str]) -> str:
        """The column of which this one has the times: ``p.Time`` and ``t_p`` of ``p``; "" for none."""
        match = re.fullmatch(rf"(.+)[._ ](?:{_TIME}|t)|(?:{_TIME}|t)[._ ](.+)", name, re.IGNORECASE)
        bare = match[1] or match[2] if match else ""
        return next((n for n in names if n in (bare, f"{bare}.Data", f"{bare}_data")), "")

    def scaled_unit(self, name: str) -> str:
        """A unit with a factor that a name ends with, ``Pressure (10^5 Pa)``, ``x in mm/10``, ``Time_10ms``; else "".

        Without a sign that sets it apart, a number may be a range or a level, but of a time.
        """
        match = _AT_END.fullmatch(name)
        if match is None:
            return ""
        kinds = self._kinds_in(split_words(match["name"]))
        part = match["part"] if "time" in kinds else None
        text = match["round"] or match["over"] or part or ""
        unit = self._unit_with_factor(text)
        needing = self.with_trait("counted", "transmitted") | {"mass", "current", "time"}
        wanted = needing.intersection(kinds or needing)
        return text if unit and wanted & self._fitting(unit) else ""

    def _unit_with_factor(self, text: str) -> str:
        """The unit of a text such as ``x10^5 Pa`` or ``mm/10``; "" where it is another text."""
        match = _FACTOR.fullmatch(text)
        return self.known_unit(match["before"] or match["behind"]) if match else ""

    def contradiction(self, name: str, unit: str) -> str:
        """The message where the words of a name contradict its unit; "" where they agree."""
        words, fitting = split_words(name), self._fitting(unit)
        possible = self._kinds_in(words)
        sure = self.vocabulary.sure
        named = [k for k, ps in sure if any(fnmatchcase(w, p) for w in words for p in ps.split())]
        if "current" in fitting:
            transmitted = self.with_trait("counted", "transmitted")
            named += [kind for kind in possible if kind in transmitted]
        kinds = (*dict(sure), "length", "time", "current")
        by_unit = next((kind for kind in kinds if kind in fitting), "")
        if not named or not by_unit or self._with_unit(unit).intersection([*named, *possible]):
            return ""
        return f"its name means {named[0]}, its unit {shown(unit)} means {by_unit}"

    def direction_word(self, word: str) -> int:
        """1 for a word of contraction or rising pressure, -1 for the contrary; 0: neither."""
        ways = (w for w, listed in self.vocabulary.directions if _among(folded(word), listed))
        return {"up": 1, "down": -1}.get(next(ways, ""), 0)

    def usual_unit(self, meaning: str, largest: float) -> str | None:
        """The unit that numbers of a kind most likely have, by their largest magnitude; None: unknown."""
        rows = dict(reversed(self.vocabulary.units))
        listed = rows.get(meaning, rows.get(meaning.split()[-1], ""))
        for entry in listed.split(", ") if listed else ():
            size, _, unit = entry.rpartition(" ")
            if not size and unit[0].isdigit():
                size, unit = unit, ""
            if largest <= float(size or inf):
                return unit
        return None

    def fits(self, unit: str, kind: str) -> bool:
        """Whether numbers of this unit are of that kind."""
        return kind in self._fitting(unit)

    def _fitting(self, unit: str) -> set[str]:
        """The kinds whose numbers can have this unit."""
        return {kind for kind, usual in self.units.items() if alike(unit, usual)}

    def variable(self, variable: Variable) -> Meaning:
        """What an input or output of a bench is, by its unit and description."""
        return self.meaning_of(variable.name, variable.description, variable.unit)

    def meanings(self, variables: Mapping[str, Variable]) -> dict[str, Meaning]:
        """What inputs and outputs are, by name."""
        return {name: self.variable(variable) for name, variable in variables.items()}

    def _meaning_of(self, name: str, description: str, unit: str) -> Meaning:
        words = split_words(name)
        words += [word for word in split_words(description) if word not in ("in", "out")]
        return self._meaning(words, unit or "1", exact=True)

    def _unit_in_name(self, name: str) -> tuple[str, str]:
        """A unit that stands behind a name, and the name without: ``p_kPa``, ``source kPa gauge``."""
        share = re.fullmatch(r"(.*?\w)\s*[/_]?\s*%", name)
        if share:
            return "%", share[1]
        parts = [part for part in re.split(r"[\W_]+", name) if part]
        for place in range(len(parts) - 1, 0, -1):
            remaining = parts[:place] + parts[place + 1 :]
            unit = self._unit_beside(parts[place], remaining)
            if unit and split_words(" ".join(remaining)):
                return unit, " ".join(remaining)
        return "", name

    def _unit_beside(self, part: str, remaining: Sequence[str]) -> str:
        """The unit that a part of a name is, if it fits the quantity of the other parts; "" where it is none."""
        unit = self.known_unit(part)
        kinds = set(self._kinds_in([word for text in remaining for word in split_words(text)]))
        if self.is_count(part):
            return part if self.with_trait("counted").intersection(kinds) else ""
        if len(part) == 1 and not (is_unit(part) and (part.isupper() or unit == part)):
            return ""
        of_length = {self.units[kind] for kind in kinds} == {"m"}  # neither inlet nor exhaust
        if not unit or (self._is_role(part, remaining) and not of_length):
            return ""
        # "valve_A", "valve_A1" and "F_g" name valves and a weight.
        is_word = len(part) > 1 and part.isalpha()
        among = self._with_unit(unit) if is_word else self._fitting(unit)
        says_so = bool(among & kinds) if kinds else bool(among) and len(part) > 1
        return unit if says_so or "voltage" in among else ""

    def _with_unit(self, unit: str) -> set[str]:
        """What has numbers of this unit, or is also measured in it."""
        kinds = self._fitting(unit)
        return kinds.union(*(_STANDS_FOR.get(kind, ()) for kind in kinds))

    def _is_role(self, part: str, remaining: Sequence[str]) -> bool:
        """Whether a part of a name is a role, as "in" and "atm", which are units too.

        Behind the name of one pressure "atm" is its unit: ``pm_atm``, ``p_set_atm``.
        """
        word = folded(part)
        any_pressure = len(remaining) == 1 and folded(remaining[0]) in _ANY_PRESSURE
        return bool(self._roles([word])) and not (word == "atm" and not any_pressure)

    def _meaning(self, words: list[str], unit: str, *, exact: bool = False) -> Meaning:
        named, roles = self._kinds_in(words), self._roles(words)
        is_time = not exact and bool(words) and words[-1] in _TIME.split("|")
        if is_time and alike(unit or "s", "s"):
            return Meaning("time")
        by_words = self._kind_without_unit(named, roles)
        kind = self._kind_with_unit(named, unit, exact) if unit else by_words
        if kind in ("", "time", "count", "direction"):
            return Meaning(kind)
        opens = bool(self._opening) and alike(unit, self._opening)
        if kind == "voltage" and opens and {*named} <= {"voltage", "current", "command"}:
            kind = "current"  # volts of a card open a valve as its amperes do
        return Meaning(
            kind, frozenset(roles & VALVES if kind in ("command", "current") else roles - VALVES)
        )

    def _kind_without_unit(self, named: Sequence[str], roles: set[str]) -> str:
        """The kind of the first known word; a commanded current or contraction is a command, an ambient T no time."""
        if "ambient" in roles and "temperature" in named:
            return "temperature"
        alone = [kind for role, kind, _ in self.vocabulary.roles if role in roles and kind]
        kind = [*named, *alone, ""][0]
        if kind == "command" and len(named) == 1 and "set" in roles and not roles & VALVES:
            return kind
        return "command" if "command" in named and kind in ("current", "contraction") else kind

    def _kind_with_unit(self, named: Sequence[str], unit: str, exact: bool) -> str:
        """The kind of the words among those that have the unit; without words, the usual kind of that unit."""
        possible = [kind for kind in self.units if alike(unit, self.units[kind])]
        is_share = "ratio" in possible
        is_length = "contraction" in named or "length" in named
        kind = next((k for k in named if k in possible), "")
        if not kind and is_share and is_length:
            kind = "ratio"
        if not kind and possible and not is_share:
            kind = "contraction" if "contraction" in possible else possible[0]
        if kind in ("contraction", "ratio", "command") and is_share:
            kind = (
                "ratio"
                if is_length or "ratio" in named
                else "command"
                if "command" in named
                else ""
            )
        weighed = kind == "mass" or (not kind and "mass" in possible)
        return "force" if weighed and "force" in named else kind

    def _kinds_in(self, words: Sequence[str]) -> list[str]:
        return [kind for i, word in enumerate(words) for kind in self._kinds_at(word, i)]

    def _kinds_at(self, word: str, place: int) -> tuple[str, ...]:
        """What a word means; one letter means something at the beginning only."""
        return () if len(word) == 1 and place > 0 else self.kinds_of(word)

    def _kinds_of(self, word: str) -> tuple[str, ...]:
        return tuple(kind for kind, _, _, listed in self.vocabulary.kinds if _among(word, listed))

    def roles_of(self, name: str) -> set[str]:
        """The roles that the words of a name state, such as "inlet"."""
        return self._roles(split_words(name))

    def _roles(self, words: Iterable[str]) -> set[str]:
        rows = self.vocabulary.roles
        return {role for word in words for role, _, listed in rows if _among(word, listed)}


def _says_absolute(unit: str, name: str) -> bool:
    """Whether a heading states an absolute pressure: by a word, by its unit, or by a unit in its name."""
    units = [unit, *re.split(r"[\W_]+", name)]
    by_unit = any(pressure_reference(text)[1] == "absolute" for text in units)
    return by_unit or any(map(_ABSOLUTE.fullmatch, split_words(name)))


# ---- what names of files and remarks above the rows say -----------------------------------------------------------

GRAVITY = "9.80665 m/s2"
"""By which a weight is a mass."""
_LOAD = re.compile(
    r"(?<![A-Za-z0-9])(?:(?P<number>\d+(?:[.,]\d+)?)[ _-]?(?P<unit>[A-Za-z]+)"
    r"|(?P<first>kg|lbs?)[ _-]?(?P<behind>\d+(?:[.,]\d+)?))(?![A-Za-z0-9])"
)
_MASSES, _WEIGHTS = ("kg", "g", "lb", "lbs"), ("N", "kN", "lbf")
_REMARK = re.compile(
    r"(?P<name>[^\W\d][^\d,;:=]*?)\s*[:=]?\s*(?P<number>[-+]?\d+(?:[.,]\d+)?)\s*(?P<unit>[^\s\d,;]+(?:\([ga]\))?)?(?=[\s,;.]|$)"
)


@dataclass(frozen=True)
class Remark:
    """A quantity that a line above the rows states."""

    text: str
    meaning: Meaning
    value: str


def muscle_in(texts: Sequence[str], muscles: Sequence[str]) -> tuple[str, str]:
    """The muscle of a library that every text names, as ``DMSP-20-300``, and its length; "" where they do not."""
    named = {_muscle(text, muscles) for text in texts}
    if len(named) == 1:
        return named.pop()
    names = {name for name, _ in named}
    return (names.pop(), "") if len(names) == 1 else ("", "")


def _muscle(stem: str, muscles: Iterable[str]) -> tuple[str, str]:
    for name in sorted(muscles, key=len, reverse=True):
        letters, digits = re.fullmatch(r"(.*?)(\d*)", name.casefold()).groups()  # type: ignore[union-attr]
        length = r"(?:[ _-]?(\d{2,4})(?!\d|[.,]\d))?"
        text = rf"{re.escape(letters)}[ _-]?{digits}(?!\d){length}"
        if digits and (match := re.search(text, stem.casefold())):
            return name, f"{match[1]} mm" if match[1] else ""
    return "", ""


def load_in(stem: str, weights: bool) -> tuple[str, float] | None:
    """The mass in a name, or the weight where ``weights``, as a mass: as a text, and [kg]; None: neither."""
    for match in _LOAD.finditer(stem):
        number = (match["number"] or match["behind"]).replace(",", ".")
        unit = match["unit"] or match["first"]
        quantity = f"{number} {unit}"
        if unit in _MASSES:
            return quantity, parse_quantity(quantity, "kg")
        if unit in _WEIGHTS and weights:
            mass = parse_quantity(quantity, "N") / parse_quantity(GRAVITY, "m/s2")
            return f"{mass:.6g} kg", mass
    return None


def remarks_in(lines: Iterable[str], headings: Headings) -> Iterator[Remark]:
    """Quantities that lines above the rows state, as ``load mass: 3 kg``; a force in kilograms is a mass."""
    for line in lines:
        for match in _REMARK.finditer(line):
            unit = headings.known_unit((match["unit"] or "").rstrip("."))
            reading = headings.read(match["name"].strip(" ,;:="), unit)
            written = unit or reading.unit
            if reading.meaning and written:
                meaning = meant("mass") if headings.fits(written, "mass") else reading.meaning
                value = f"{match['number'].replace(',', '.')} {written}"
                yield Remark(match[0].strip(" ,;"), meaning, value)
