"""The forms that a missing term is described with: lines with bends of the model's variables, and their products.

A form is written once, as the text of a Modelica expression; its values come from the same text.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.compiler import elementwise

_ROUNDING = 0.03  # of the span of a variable: width of a bend, a tenth of the distance of two
_BENDS = 3  # of a spline in each variable; a quarter of the samples lies between two
_SIGNED_SHARE = 0.1  # of its size, that a variable reaches on both sides of zero to have a sign
# on either side, beyond which values do not set the size of a variable
_EXTREME_QUANTILE = 0.02
_CONSTANT_RANGE = 1e-3  # of its size: a variable that varies less is left out
_SAME_CORRELATION = 0.9995  # correlation of two variables of which one is enough


@dataclass(frozen=True)
class Quantity:
    """A variable of the model: name, unit and a round size [unit] that it is divided by."""

    name: str
    unit: str
    size: float
    signed: bool

    @property
    def scale(self) -> str:
        """Name of the constant that holds the size."""
        return f"{self.name}_0"

    @property
    def ratio(self) -> str:
        """The variable over its size."""
        return f"({self.name}/{self.scale})"


@dataclass(frozen=True)
class Form:
    """A dimensionless expression.

    Attributes:
        text: Modelica, with names of variables and of their sizes.
        quantities: the variables in it.
        words: how a person writes it.
    """

    text: str
    quantities: tuple[Quantity, ...]
    words: str

    def values(self, variables: Mapping[str, Array]) -> Array:
        """(n,) from variables (n,) [SI]."""
        names: dict[str, Array | float] = {q.name: variables[q.name] for q in self.quantities}
        names |= {q.scale: q.size for q in self.quantities}
        count = len(next(iter(variables.values())))
        return np.broadcast_to(elementwise(self.text, names), (count,))


def quantities(variables: Mapping[str, Array], units: Mapping[str, str]) -> list[Quantity]:
    """What a term can depend on; of variables that say the same the first."""
    distinct: list[Quantity] = []
    for name, z in variables.items():
        size = float(np.quantile(np.abs(z), 1 - _EXTREME_QUANTILE))
        if not size > 0 or np.ptp(z) < _CONSTANT_RANGE * size:
            continue
        if any(abs(np.corrcoef(z, variables[q.name])[0, 1]) > _SAME_CORRELATION for q in distinct):
            continue
        low, high = np.quantile(z, [_EXTREME_QUANTILE, 1 - _EXTREME_QUANTILE])
        digits = 10.0 ** np.floor(np.log10(size))
        distinct.append(
            Quantity(
                name,
                units.get(name, ""),
                float(f"{round(size / digits) * digits:.3g}"),
                bool(min(-low, high) > _SIGNED_SHARE * size),
            )
        )
    return distinct


def ramps(
    quantities: Sequence[Quantity], variables: Mapping[str, Array], straight: Collection[str] = ()
) -> list[Form]:
    """Forms that add up to splines: lines with rounded bends at quantiles of each variable, and their products.

    Variables with a name in ``straight`` have no bends.
    """
    forms_by_quantity = {
        q.name: [
            Form(q.ratio, (q,), q.name),
            *(_bends(q, variables[q.name]) if q.name not in straight else []),
        ]
        for q in quantities
    }
    listed = [Form("1", (), "1"), *(f for forms_of in forms_by_quantity.values() for f in forms_of)]
    for i, a in enumerate(quantities):
        for b in quantities[i + 1 :]:
            listed.append(Form(f"{a.ratio}*{b.ratio}", (a, b), f"{a.name} {b.name}"))
            for factor, spline in ((a, b), (b, a)):
                listed += [
                    Form(f"{factor.ratio}*{f.text}", (factor, spline), f"{factor.name} {f.words}")
                    for f in forms_by_quantity[spline.name][1:]
                ]
    return listed


def _bends(q: Quantity, z: Array) -> list[Form]:
    """max(0, z - bend), rounded, for bends that divide the samples evenly."""
    places = np.unique(np.quantile(z, np.arange(1, _BENDS + 1) / (_BENDS + 1)) / q.size)
    width = _ROUNDING * float(np.ptp(z)) / q.size
    inside = (places > z.min() / q.size + width) & (places < z.max() / q.size - width)
    listed = []
    for place in places[inside].tolist():
        sign = "+" if place < 0 else "-"
        above = f"({q.ratio} {sign} {abs(place):.6g})"
        text = f"(0.5*({above} + sqrt({above}^2 + {width**2:.6g})))"
        listed.append(Form(text, (q,), f"max(0, {q.name} {sign} {abs(place):.3g})"))
    return listed
