"""Numbers in SI units as a person at the rig would write them."""

from __future__ import annotations

# SI unit -> (unit people read, factor, offset): only where the SI unit itself is awkward to read.
_READABLE: dict[str, tuple[str, float, float]] = {
    "Pa": ("kPa", 1e-3, 0.0),
    "Pa/s": ("kPa/s", 1e-3, 0.0),
    "m": ("mm", 1e3, 0.0),
    "m2": ("mm²", 1e6, 0.0),
    "m3": ("L", 1e3, 0.0),
    "kg/s": ("g/s", 1e3, 0.0),
}


def readable_unit(unit: str) -> str:
    """The unit in which a quantity given in SI is shown."""
    name = _READABLE.get(unit, (unit, 1.0, 0.0))[0]
    return "" if name == "1" else name


def readable_factor(unit: str) -> float:
    """Factor from the SI unit to ``readable_unit``."""
    return _READABLE.get(unit, (unit, 1.0, 0.0))[1]


def format_quantity(value: float, unit: str, digits: int = 3) -> str:
    """``value`` [SI unit] with a unit that is easy to read: 84000 Pa is "84 kPa"."""
    number = f"{value * readable_factor(unit):.{digits}g}"
    return f"{number} {readable_unit(unit)}".rstrip()
