"""Modelica's unit texts as FMI's unit definitions: exponents of SI base units, factor and offset."""

from __future__ import annotations

import re
from functools import cache
from typing import NamedTuple

from pam_cosim.units.grammar import UnitError, read_unit, registry

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
_FACTOR = r"[A-Za-z]+(?:[+-]?\d+)?"
_PRODUCT = rf"{_FACTOR}(?:\.{_FACTOR})*"
_MODELICA = rf"(?:1|{_PRODUCT})(?:/(?:{_FACTOR}|\({_PRODUCT}\)))?"


class BaseUnit(NamedTuple):
    """A unit by its relation to SI base units: value [SI] = factor * value + offset."""

    name: str
    exponents: tuple[tuple[str, int], ...] = ()
    factor: float = 1.0
    offset: float = 0.0

    def display(self, unit: BaseUnit) -> tuple[float, float]:
        """Factor and offset that turn a value of ``unit`` into this display unit.

        Raises:
            UnitError: the two measure different quantities.
        """
        if self.exponents != unit.exponents:
            raise UnitError(f"display unit '{self.name}' does not fit unit '{unit.name}'")
        return unit.factor / self.factor, (unit.offset - self.offset) / self.factor


def same_unit(unit_a: str, unit_b: str) -> bool:
    """Whether numbers in two units are the same, however these are written."""
    if unit_a == unit_b:
        return True
    try:
        base_a, base_b = base_unit(unit_a), base_unit(unit_b)
    except UnitError:
        return False
    return base_a._replace(name=base_b.name) == base_b


@cache
def base_unit(text: str) -> BaseUnit:
    """Reads a unit of Modelica's grammar (chapter 19 of its specification), such as ``W/(m2.K)``.

    Raises:
        UnitError: the text is not a unit or contains an unknown symbol.
    """
    if not re.fullmatch(_MODELICA, text.replace(" ", "")):
        raise UnitError(
            f"unit '{text}' cannot be read; write it as Modelica does, for example 'W/(m2.K)'"
        )
    unit = read_unit(text, False)
    try:
        zero, unity = (registry().Quantity(value, unit).to_base_units() for value in (0.0, 1.0))
    except (OverflowError, ZeroDivisionError):
        raise UnitError(f"unit '{text}' has a factor beyond what a number holds") from None
    exponents = {}
    for name, exponent in unity.unit_items():
        if name not in _BASE or exponent != int(exponent):
            raise UnitError(f"unit '{text}' is not made of SI base units")
        exponents[_BASE[name]] = int(exponent)
    ordered = tuple((name, exponents[name]) for name in _BASE.values() if exponents.get(name))
    return BaseUnit(text, ordered, float(unity.magnitude - zero.magnitude), float(zero.magnitude))
