"""Modelica unit texts as FMI 2.0 unit definitions: exponents of SI base units, factor and offset."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import Any

import pint

from pam_cosim.errors import ModelError

# FMI's names of the base units, in the order of its schema, by pint's names.
_BASE = {
    "kilogram": "kg",
    "meter": "m",
    "second": "s",
    "ampere": "A",
    "kelvin": "K",
    "mole": "mol",
    "candela": "cd",
    "radian": "rad",
}
_SPELLINGS = {"Ohm": "ohm", "rev": "revolution"}
_FACTOR = re.compile(r"([A-Za-z]+)([+-]?\d+)?")


@dataclass(frozen=True)
class Unit:
    """A unit by its relation to SI base units: value [SI] = factor * value + offset."""

    name: str
    exponents: tuple[tuple[str, int], ...] = ()
    factor: float = 1.0
    offset: float = 0.0

    def display(self, unit: Unit) -> tuple[float, float]:
        """Factor and offset that turn a value of ``unit`` into this display unit.

        Raises:
            ModelError: the two measure different quantities.
        """
        if self.exponents != unit.exponents:
            raise ModelError(f"display unit '{self.name}' does not fit unit '{unit.name}'")
        return unit.factor / self.factor, (unit.offset - self.offset) / self.factor


@cache
def _registry() -> Any:
    return pint.UnitRegistry(autoconvert_offset_to_baseunit=True, cache_folder=None)


@cache
def parse_unit(text: str) -> Unit:
    """Reads a unit of Modelica's grammar (chapter 19 of its specification), such as ``W/(m2.K)``.

    Raises:
        ModelError: the text is not a unit or contains an unknown symbol.
    """
    numerator, slash, denominator = text.replace(" ", "").partition("/")
    product = _factors(numerator, text)
    if slash:
        grouped = denominator.startswith("(") and denominator.endswith(")")
        if not grouped and "." in denominator:
            raise _unreadable(text)
        product += [(s, -n) for s, n in _factors(denominator[1:-1] if grouped else denominator, text)]
    exponents, factor = _expand(product, text)
    lone = len(product) == 1 and product[0][1] == 1
    offset = _offset(product[0][0]) if lone else 0.0
    return Unit(text, exponents, factor, offset)


def _unreadable(text: str) -> ModelError:
    return ModelError(f"unit '{text}' cannot be read; write it as Modelica does, for example 'W/(m2.K)'")


def _factors(text: str, whole: str) -> list[tuple[str, int]]:
    """Symbols with exponents of a product such as ``kg.m2``."""
    if text == "1":
        return []
    matches = [_FACTOR.fullmatch(part) for part in text.split(".")]
    if not all(matches):
        raise _unreadable(whole)
    return [(m.group(1), int(m.group(2) or 1)) for m in matches if m]


@cache
def _symbol(symbol: str) -> Any:
    return _registry().parse_units(_SPELLINGS.get(symbol, symbol))


def _offset(symbol: str) -> float:
    """Value in SI of zero in this unit."""
    return float(_registry().Quantity(0.0, _symbol(symbol)).to_base_units().magnitude)


def _expand(product: list[tuple[str, int]], text: str) -> tuple[tuple[tuple[str, int], ...], float]:
    """Exponents of the base units in a fixed order, and the factor."""
    factor, sums = 1.0, dict.fromkeys(_BASE.values(), 0)
    for symbol, power in product:
        try:
            unit = _symbol(symbol)
            one = _registry().Quantity(1.0, unit).to_base_units()
        except (pint.PintError, AttributeError, ValueError) as error:
            raise ModelError(f"unit '{text}': the symbol '{symbol}' is unknown") from error
        factor *= float(one.magnitude - _offset(symbol)) ** power
        for name, exponent in one.unit_items():
            if name not in _BASE or exponent != int(exponent):
                raise ModelError(f"unit '{text}': '{symbol}' is not made of SI base units")
            sums[_BASE[name]] += int(exponent) * power
    return tuple((name, n) for name, n in sums.items() if n), factor
