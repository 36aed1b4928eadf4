"""Physical units: texts as people and Modelica write them, converted by pint.

Both spellings are read by one small grammar: ``W/(m2.K)``, ``N.s/m``, ``m/s^2``, ``kg*m``, ``degC``, ``%``.
Pressures carry no reference: ``kPa`` on a gauge pressure is gauge.
"""

from __future__ import annotations

import math
import re
from functools import cache, lru_cache
from typing import Any

import numpy as np
import pint
from numpy.typing import ArrayLike, NDArray

from pam_cosim.measurement.wording import shown

_ALIASES = {
    "%": "percent", "Ohm": "ohm", "°C": "degC", "°F": "degF", "°": "degree", "μm": "um",
    "barg": "bar", "psig": "psi", "kPag": "kPa",
}  # fmt: skip
_EXAMPLES = {
    "Pa": "kPa, bar or psi", "m": "mm", "K": "degC", "A": "mA", "N": "kN", "kg": "g", "m3": "l", "s": "ms",
}  # fmt: skip
_DIMENSIONLESS = ("", "1", "-")
_TOKEN = re.compile(
    r"\s*(?:(?P<symbol>[cm]mH2O|inH2O|[A-Za-zµμ°Ω%_]+)|(?P<number>\d{1,2}(?!\d))|(?P<sign>\*\*|[-+*/.·^()]))"
)
_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*", re.DOTALL)
_LONGEST = 60


class UnitError(ValueError):
    """A unit is unknown or does not fit; the caller adds the place."""


@cache
def _registry() -> Any:
    registry: Any = pint.UnitRegistry(autoconvert_offset_to_baseunit=True, cache_folder=None)
    registry.formatter.default_format = "~"
    return registry


def is_dimensionless(unit: str) -> bool:
    """Whether numbers of this unit are written without one: "" and "1" (and "-" in a CSV header)."""
    return unit.strip() in _DIMENSIONLESS


def examples(unit: str) -> str:
    """Units a person might have meant where the model uses ``unit``."""
    return f"{unit}, {_EXAMPLES[unit]}" if unit in _EXAMPLES else unit


class _Parser:
    """Recursive descent: ``product = factor {("*" | "." | "/") factor}``, ``factor = atom [exponent]``."""

    def __init__(self, text: str, difference: bool) -> None:
        self.text, self.difference = text, difference
        self.tokens = self._split()
        self.at = 0
        # An offset unit inside a product (W/(m2.degC)) means a difference of temperature.
        self.alone = len(self.tokens) == 1

    def _split(self) -> list[tuple[str, str]]:
        tokens, at, text = [], 0, self.text.strip()
        while at < len(text):
            match = _TOKEN.match(text, at)
            if match is None or len(text) > _LONGEST:
                raise UnitError(f"unit {shown(self.text)} cannot be read; write for example 'kPa' or 'N.s/m'")
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
            return _registry().Unit("")
        if text == "(":
            unit = self._product()
            if self._take()[1] == ")":
                return unit
        raise UnitError(f"unit {shown(self.text)} cannot be read")

    def _symbol(self, symbol: str) -> Any:
        try:
            unit = _registry().parse_units(_ALIASES.get(symbol, symbol))
            if not self.alone or self.difference:
                delta = f"delta_{unit:D}"
                unit = _registry().parse_units(delta) if f"{unit:D}" in _offset_units() else unit
        except (pint.PintError, AttributeError, ValueError, TypeError, KeyError):
            raise UnitError(f"unit {shown(symbol)} is unknown; write 'kPa', 'mm', 'degC' or the like") from None
        return unit


@cache
def _offset_units() -> tuple[str, ...]:
    return tuple(f"{_registry().Unit(name):D}" for name in ("degC", "degF", "degRe"))


@lru_cache(maxsize=512)
def _unit(text: str, difference: bool) -> Any:
    if is_dimensionless(text):
        return _registry().Unit("")
    try:
        return _Parser(text, difference).parse()
    except (pint.PintError, OverflowError, ZeroDivisionError):
        raise UnitError(f"unit {shown(text)} cannot be read") from None


def convert(values: ArrayLike, unit: str, target: str, *, difference: bool = False) -> NDArray[np.float64]:
    """Numbers in ``unit`` as numbers in ``target``.

    Args:
        values: any shape; NaN stays NaN.
        unit: as a person writes it; "", "1" and "-" are dimensionless.
        target: the model's unit.
        difference: the values are differences (0.5 degC is 0.5 K, not 273.65 K).

    Raises:
        UnitError: a unit is unknown, or the dimensions differ.
    """
    source, goal = _unit(unit, difference), _unit(target, difference)
    if source.dimensionality != goal.dimensionality:
        if is_dimensionless(target):
            raise UnitError(f"unit {shown(unit)} does not fit a number without dimension; leave it out")
        if is_dimensionless(unit):
            raise UnitError(f"a unit is missing; use one of {examples(target)}")
        message = f"unit {shown(unit)} cannot be converted to '{target}'; use one of {examples(target)}"
        raise UnitError(message)
    numbers = np.array(values, dtype=float)
    try:
        with np.errstate(over="ignore", invalid="ignore"):
            return np.asarray(_registry().Quantity(numbers, source).to(goal).magnitude, dtype=float)
    except (pint.PintError, ValueError, OverflowError):
        raise UnitError(f"unit {shown(unit)} cannot be converted to '{target}'") from None


def quantity(value: str | float, target: str, *, difference: bool = False) -> float:
    """One value such as ``"2.27 kg"``, in ``target``; a bare number only where ``target`` has no dimension.

    Raises:
        UnitError: no number, not finite, no unit where one is needed, or a unit that does not fit.
    """
    number, unit = _split_quantity(value, target) if isinstance(value, str) else (float(value), "")
    if not math.isfinite(number):
        raise UnitError(f"{shown(value)} is not a finite number")
    if is_dimensionless(unit) and not is_dimensionless(target):
        raise UnitError(f'{shown(value)} needs a unit; write for example "{number:g} {target}"')
    result = float(convert(number, unit, target, difference=difference))
    if not math.isfinite(result):
        raise UnitError(f"{shown(value)} is too large")
    return result


def _split_quantity(text: str, target: str) -> tuple[float, str]:
    match = _QUANTITY.fullmatch(text)
    if match is None:
        example = "0.7" if is_dimensionless(target) else f"0.7 {target}"
        raise UnitError(f'{shown(text)} is not a number with a unit; write for example "{example}"')
    if match.group(2).startswith(","):
        raise UnitError(f"{shown(text)} has a decimal comma; write a decimal point")
    return float(match.group(1)), match.group(2)
