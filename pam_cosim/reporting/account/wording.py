"""Numbers, units and names as a person reads them in a report."""

from __future__ import annotations

import math
import re

from pam_cosim.fitting import Estimate
from pam_cosim.units import readable_factor, readable_unit

NOTHING = "–"
_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_SMALLEST, _LARGEST = 1e-3, 1e6  # outside, a power of ten is easier to read
_MOST_DIGITS = 6


def number(value: float | None, digits: int = 3) -> str:
    """``value`` with so many significant digits; a dash where there is no number."""
    if value is None or not math.isfinite(value):
        return NOTHING
    if value == 0:
        return "0"
    rounded = float(f"{value:.{max(digits, 1) - 1}e}")
    exponent = math.floor(math.log10(abs(rounded)))
    if _SMALLEST <= abs(rounded) < _LARGEST:
        text = f"{value:.{max(digits - 1 - exponent, 0)}f}"
    else:
        text = (
            f"{rounded / 10.0**exponent:.{digits - 1}f}×10{str(exponent).translate(_SUPERSCRIPT)}"
        )
    return text.replace("-", "−")


def fixed(value: float | None) -> str:
    """``value`` with one decimal, where the distance from zero matters and small numbers do not."""
    if value is None or not math.isfinite(value):
        return NOTHING
    text = f"{value:.1f}"
    return text.removeprefix("-") if float(text) == 0 else text.replace("-", "−")


def unit_text(unit: str) -> str:
    """The readable unit of a quantity stored in SI ``unit``, with superscripts: "W/(m²·K)"; "" without dimension."""
    text = readable_unit(unit)
    text = re.sub(r"(?<=[A-Za-z)])(-?\d+)", lambda m: m.group(1).translate(_SUPERSCRIPT), text)
    return text.replace("*", "·").replace(".", "·")


def quantity_text(value: float | None, unit: str, digits: int = 3) -> str:
    """``value`` [SI ``unit``] with a readable unit: 84000 Pa is "84.0 kPa"."""
    if value is None or not math.isfinite(value):
        return NOTHING
    return f"{number(value * readable_factor(unit), digits)}\u00a0{unit_text(unit)}".rstrip()


def percent(share: float | None) -> str:
    """0.713 is "71 %"; just under the whole keeps a decimal, so that 99.7 % does not read as all."""
    if share is None or not math.isfinite(share):
        return NOTHING
    text = f"{100 * share:.{int(0.99 < share < 1)}f}".replace("-", "−")
    return f"{'0' if text == '−0' else text}\u00a0%"


def estimate_texts(estimate: Estimate) -> tuple[str, str]:
    """Value and 95 % interval in the readable unit, with the digits that the interval supports."""
    factor = readable_factor(estimate.unit)
    value, low, high = (v * factor for v in (estimate.value, estimate.low, estimate.high))
    if not estimate.determined or not math.isfinite(high - low):
        return number(value), NOTHING
    digits = _digits(value, (high - low) / 2)
    return number(
        value, digits
    ), f"{_bound_text(low, value, digits)} to {_bound_text(high, value, digits)}"


def _digits(value: float, reach: float) -> int:
    """Significant digits of ``value`` down to the first uncertain one, to the second where that is a 1 or 2."""
    if not value or reach <= 0:
        return 3
    exponent = math.floor(math.log10(reach))
    digits = (
        math.floor(math.log10(abs(value))) - exponent + (2 if reach < 3 * 10.0**exponent else 1)
    )
    return min(max(digits, 2), _MOST_DIGITS)


def _bound_text(bound: float, value: float, digits: int) -> str:
    """``bound`` with as many decimals as ``value`` has."""
    if not (_SMALLEST <= abs(value) < _LARGEST):
        return number(bound, digits)
    decimals = max(digits - 1 - math.floor(math.log10(abs(value))), 0)
    return f"{bound:.{decimals}f}".replace("-", "−")


def remark(estimate: Estimate) -> str:
    """What a reader must know before using the value; "" where there is none."""
    remarks = []
    if not estimate.determined:
        remarks.append(
            "held there, not needed" if estimate.held else "not determined by these data"
        )
    if estimate.at_bound:
        remarks.append("at its bound")
    return ", ".join(remarks)


def wrapped(text: str, longest: int = 28, lines: int = 2) -> str:
    """A label in some lines at most, broken between words and parts of a name; its end is kept."""
    broken = [""]
    for part in re.findall(r"\s+|[^\s./+,]*[./+,]*", text):
        if broken[-1] and len(broken[-1]) + len(part.rstrip()) > longest:
            broken.append("")
        broken[-1] += part if broken[-1] else part.lstrip()
    rows = [row.rstrip() for row in broken if row.strip()]
    head, last_row = rows[: lines - 1], "".join(broken[lines - 1 :]) if len(rows) >= lines else ""
    return "\n".join(shortened(row, longest) for row in [*head, last_row.strip()] if row)


def shortened(text: str, longest: int = 28) -> str:
    """``text``, its middle left out when it is too long for a figure."""
    if len(text) <= longest:
        return text
    tail = longest // 2 - 1
    return f"{text[: longest - tail - 1]}…{text[-tail:]}"
