"""Products and quotients of units, as Modelica's texts: factors joined by points, one solidus."""

from __future__ import annotations

import re
from collections import Counter

from pam_cosim.units.grammar import is_dimensionless

_FACTOR = re.compile(r"([A-Za-z]+)([+-]?\d+)?")


def product(left: str, right: str) -> str:
    """``N`` and ``m`` are ``N.m``, ``m`` and ``m`` are ``m2``; without dimension: "1"."""
    powers = _powers(left)
    for symbol, power in _powers(right).items():
        powers[symbol] += power
    return _text(powers)


def quotient(unit: str, by: str) -> str:
    """``m/s`` by ``s`` is ``m/s2``; without dimension: "1"."""
    powers = _powers(unit)
    for symbol, power in _powers(by).items():
        powers[symbol] -= power
    return _text(powers)


def _powers(unit: str) -> Counter[str]:
    """Power of each symbol of a text in Modelica's grammar; what is not of it is one symbol by itself."""
    powers: Counter[str] = Counter()
    above, _, below = unit.replace(" ", "").partition("/")
    for text, sign in ((above, 1), (below.removeprefix("(").removesuffix(")"), -1)):
        for factor in text.split("."):
            if not is_dimensionless(factor):
                match = _FACTOR.fullmatch(factor)
                symbol, power = (match.group(1), int(match.group(2) or 1)) if match else (factor, 1)
                powers[symbol] += sign * power
    return powers


def _text(powers: Counter[str]) -> str:
    above = [_power(symbol, power) for symbol, power in powers.items() if power > 0]
    below = [_power(symbol, -power) for symbol, power in powers.items() if power < 0]
    denominator = below[0] if len(below) == 1 else f"({'.'.join(below)})"
    return (".".join(above) or "1") + (f"/{denominator}" if below else "")


def _power(symbol: str, power: int) -> str:
    return symbol if power == 1 else f"{symbol}{power}"
