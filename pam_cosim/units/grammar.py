"""Texts of units as people and Modelica write them, read for pint.

Both spellings are read by one small grammar: ``W/(m2.K)``, ``N.s/m``, ``m/s^2``, ``kg*m``, ``N/mm²``, ``degC``, ``%``.
Pressures carry no reference: ``kPa`` on a gauge pressure is gauge, and so are ``kPag``, ``bar(g)`` and ``barü``; what
states an absolute pressure, such as ``psia``, is refused, for its numbers are others.
"""

from __future__ import annotations

import re
import sys
from functools import cache, lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from pam_cosim.cache import cached_folder, digest
from pam_cosim.errors import InputError
from pam_cosim.wording import shown

# [Pa], lowest and highest reading of a gauge of absolute pressure at rest
ATMOSPHERES = (90e3, 108e3)
STANDARD_ATMOSPHERE = 101325.0  # [Pa]

_ALIASES = {
    "%": "percent",
    "Ohm": "ohm",
    "°C": "degC",
    "°F": "degF",
    "°": "degree",
    "μm": "um",
    "rev": "revolution",
    "mil": "thou",
    "mils": "thou",
    "kp": "kilogram_force",
    "Torr": "torr",
    "mWS": "meter_H2O",
    "mmWS": "mmH2O",
}
_DIMENSIONLESS = ("", "1", "-")
_TOKEN = re.compile(
    r"\s*(?:(?P<symbol>[cm]mH2O|inH2O|[A-Za-zµμ°Ω%_]+)|(?P<number>\d{1,2}(?!\d|[eE][-+]?\d))|(?P<sign>\*\*|[-+*/.·^()]))"
)
_LONGEST = 60
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_REFERENCE = re.compile(
    r"(?P<unit>[mkhM]?(?:bar|Pa|psi)|mmHg|inHg|[cm]mH2O|inH2O|torr|at)"
    r"[\s_]*(?:(?P<gauge>[gü]|\([gü]\)|\(?(?:gauge|rel\.?)\)?)|(?P<absolute>a|\(a\)|\(?(?:abs\.?|absolute)\)?))",
    re.IGNORECASE,
)


class UnitError(ValueError):
    """A unit is unknown or does not fit; the caller adds the place."""


@cache
def registry() -> Any:
    """The one registry of units, pint's, which a process without units does not load.

    What pint reads from its definitions, in near half a second, is kept in the cache, where that can be written.
    """
    from importlib.metadata import version

    import pint

    key = digest(pint.__version__, pint.__file__, version("flexparser"), sys.version)
    try:
        registry = _registry(cached_folder("units", key, _definitions))
    except InputError:
        registry = _registry(None)
    registry.formatter.default_format = "~"
    return registry


def _registry(folder: Path | None) -> Any:
    import pint

    return pint.UnitRegistry(autoconvert_offset_to_baseunit=True, cache_folder=folder)


def _definitions() -> dict[str, bytes]:
    """The files that pint keeps of its definitions, by name; pint itself does not write them whole or not at all."""
    with TemporaryDirectory() as folder:
        _registry(Path(folder))
        return {file.name: file.read_bytes() for file in sorted(Path(folder).iterdir())}


def registry_errors(*other_errors: type[Exception]) -> tuple[type[Exception], ...]:
    """What the registry raises, and ``further`` exceptions: what ``except`` is to catch."""
    import pint

    return (pint.PintError, *other_errors)


def is_dimensionless(unit: str) -> bool:
    """Whether numbers of this unit are written without one: "" and "1" (and "-" in a CSV header)."""
    return unit.strip() in _DIMENSIONLESS


def pressure_reference(unit: str) -> tuple[str, str]:
    """A unit of pressure without its reference, and that: "gauge", "absolute", or "" where it states none."""
    match = _REFERENCE.fullmatch(unit.strip())
    if match is None:
        return unit, ""
    return match["unit"], "gauge" if match["gauge"] else "absolute"


class _Parser:
    """Recursive descent: ``product = factor {("*" | "." | "/") factor}``, ``factor = atom [exponent]``."""

    def __init__(self, text: str, difference: bool) -> None:
        self.text, self.difference = text, difference
        self.tokens = self._split()
        self.at = 0
        # An offset unit inside a product (W/(m2.degC)) means a difference of temperature.
        self.alone = len(self.tokens) == 1

    def _split(self) -> list[tuple[str, str]]:
        tokens, at, text = [], 0, self.text.strip().translate(_RAISED)
        while at < len(text):
            match = _TOKEN.match(text, at)
            if match is None or len(text) > _LONGEST:
                raise UnitError(
                    f"unit {shown(self.text)} cannot be read; write for example 'kPa' or 'N.s/m'"
                )
            tokens.append((str(match.lastgroup), match.group(match.lastgroup or 0)))
            at = match.end()
        return tokens

    def _peek(self) -> tuple[str, str]:
        return self.tokens[self.at] if self.at < len(self.tokens) else ("end", "")

    def _take(self) -> tuple[str, str]:
        token = self._peek()
        self.at += 1
        return token

    def parse(self) -> Any:
        unit = self._product()
        if self._peek()[0] != "end":
            raise UnitError(f"unit {shown(self.text)} cannot be read at '{self._peek()[1]}'")
        return unit

    def _product(self) -> Any:
        unit = self._factor()
        while True:
            kind, sign = self._peek()
            if sign in ("*", ".", "·", "/"):
                self._take()
            elif kind != "symbol" and sign != "(":
                return unit
            factor = self._factor()
            unit = unit / factor if sign == "/" else unit * factor

    def _factor(self) -> Any:
        unit = self._atom()
        raised = self._peek()[1] in ("^", "**")
        if raised:
            self._take()
        sign = self._take()[1] if self._peek()[1] in ("+", "-") else ""
        if self._peek()[0] == "number":
            return unit ** int(sign + self._take()[1])
        if raised or sign:
            raise UnitError(f"unit {shown(self.text)} lacks an exponent")
        return unit

    def _atom(self) -> Any:
        kind, text = self._take()
        if kind == "symbol":
            return self._symbol(text)
        if kind == "number" and text == "1":
            return registry().Unit("")
        if text == "(":
            unit = self._product()
            if self._take()[1] == ")":
                return unit
        raise UnitError(f"unit {shown(self.text)} cannot be read")

    def _symbol(self, symbol: str) -> Any:
        try:
            unit = registry().parse_units(_ALIASES.get(symbol, symbol))
            if not self.alone or self.difference:
                delta = f"delta_{unit:D}"
                unit = registry().parse_units(delta) if f"{unit:D}" in _offset_units() else unit
        except registry_errors(AttributeError, ValueError, TypeError, KeyError):
            raise UnitError(
                f"unit {shown(symbol)} is unknown; write 'kPa', 'mm', 'degC' or the like"
            ) from None
        return unit


@cache
def _offset_units() -> tuple[str, ...]:
    return tuple(f"{registry().Unit(name):D}" for name in ("degC", "degF", "degRe"))


def _composed(text: str) -> str:
    """Signs that hold a degree and a letter, as the two."""
    return text.replace("℃", "°C").replace("℉", "°F")


@lru_cache(maxsize=512)
def read_unit(text: str, difference: bool) -> Any:
    """pint's unit for a text; one with an origin of its own (degC) is without it where a ``difference`` is meant.

    Raises:
        UnitError: the text cannot be read, or a symbol is unknown.
    """
    if is_dimensionless(text):
        return registry().Unit("")
    plain, reference = pressure_reference(_composed(text))
    if reference == "absolute":
        hint = f'state unit = "{plain}", offset = "-101.325 kPa" under [columns], or {plain!r} of an ambient'
        raise UnitError(
            f"unit {shown(text)} means an absolute pressure, but pressures of models are gauge; {hint}"
        )
    try:
        return _Parser(plain, difference).parse()
    except registry_errors(OverflowError, ZeroDivisionError):
        raise UnitError(f"unit {shown(text)} cannot be read") from None
