"""The forms that a missing term is described with: monomials and a few curves of the model's variables.

A form is written once, as the text of a Modelica expression; its values come from the same text.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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

_SPEEDS = (0.005, 0.02, 0.1)  # width of a rounded jump, over the size of the variable
_GROWTHS = (0.25, 0.5, 1.0)  # what a variable grows by until an exponential is e times as large
_WAVES = tuple(1 / k for k in (1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8))


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
class FormConstant:
    """A number inside a form: placeholder, the variable whose unit it has, value and bounds [unit]."""

    name: str
    of: Quantity
    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Form:
    """A dimensionless expression.

    Attributes:
        text: Modelica, with names of variables, of their sizes and of ``shape``.
        quantities: the variables in it.
        shape: a number in it that is not linear; None: there is none.
        words: how a person writes it, with ``{shape}`` and the variables' names.
    """

    text: str
    quantities: tuple[Quantity, ...]
    shape: FormConstant | None = None
    words: str = ""

    def values(self, variables: Mapping[str, Array], shape: float | None = None) -> Array:
        """(n,) from variables (n,) [SI], with another value of the shape if given."""
        names: dict[str, Array | float] = {q.name: variables[q.name] for q in self.quantities}
        names |= {q.scale: q.size for q in self.quantities}
        if self.shape is not None:
            names[self.shape.name] = self.shape.value if shape is None else shape
        count = len(next(iter(variables.values())))
        return np.broadcast_to(elementwise(self.text, names), (count,))


def quantities(variables: Mapping[str, Array], units: Mapping[str, str]) -> list[Quantity]:
    """What a term can depend on; of variables that say the same the first."""
    kept: list[Quantity] = []
    for name, z in variables.items():
        size = float(np.quantile(np.abs(z), 1 - _EXTREME_QUANTILE))
        if not size > 0 or np.ptp(z) < _CONSTANT_RANGE * size:
            continue
        if any(abs(np.corrcoef(z, variables[q.name])[0, 1]) > _SAME_CORRELATION for q in kept):
            continue
        low, high = np.quantile(z, [_EXTREME_QUANTILE, 1 - _EXTREME_QUANTILE])
        digits = 10.0 ** np.floor(np.log10(size))
        kept.append(
            Quantity(
                name,
                units.get(name, ""),
                float(f"{round(size / digits) * digits:.3g}"),
                bool(min(-low, high) > _SIGNED_SHARE * size),
            )
        )
    return kept


def forms(known: Sequence[Quantity]) -> list[Form]:
    """All forms of some variables, simple ones first."""
    listed = [Form("1", (), None, "1")]
    for q in known:
        listed += _powers(q)
        listed += _jumps(q) if q.signed else _curves(q)
    for i, a in enumerate(known):
        for b in known[i + 1 :]:
            listed += _products(a, b)
    return listed


def ramps(known: Sequence[Quantity], variables: Mapping[str, Array]) -> list[Form]:
    """Forms that add up to splines: lines with rounded bends at quantiles of each variable, and their products."""
    own = {
        q.name: [Form(q.ratio, (q,), None, q.name), *_bends(q, variables[q.name])] for q in known
    }
    listed = [Form("1", (), None, "1"), *(f for forms_of in own.values() for f in forms_of)]
    for i, a in enumerate(known):
        for b in known[i + 1 :]:
            listed.append(Form(f"{a.ratio}*{b.ratio}", (a, b), None, f"{a.name} {b.name}"))
            for one, two in ((a, b), (b, a)):
                bends = own[two.name][1:]
                listed += [
                    Form(f"{one.ratio}*{f.text}", (one, two), None, f"{one.name} {f.words}")
                    for f in bends
                ]
    return listed


def _bends(q: Quantity, z: Array) -> list[Form]:
    """max(0, z - bend), rounded, for bends that divide the samples evenly."""
    places = np.unique(np.quantile(z, np.arange(1, _BENDS + 1) / (_BENDS + 1)) / q.size)
    width = _ROUNDING * float(np.ptp(z)) / q.size
    inside = (places > z.min() / q.size + width) & (places < z.max() / q.size - width)
    listed = []
    for place in places[inside].tolist():
        above = f"({q.ratio} - {place:.6g})" if place >= 0 else f"({q.ratio} + {-place:.6g})"
        text = f"(0.5*({above} + sqrt({above}^2 + {width**2:.6g})))"
        listed.append(Form(text, (q,), None, f"max(0, {q.name} - {place:.3g})"))
    return listed


def _powers(q: Quantity) -> list[Form]:
    texts = [(q.ratio, q.name)]
    texts += [(f"{q.ratio}^{k}", f"{q.name}^{k}") for k in (2, 3)]
    if q.signed:
        texts[1] = (f"{q.ratio}*sqrt({q.ratio}^2 + 1e-4)", f"{q.name} |{q.name}|")
    return [Form(text, (q,), None, words) for text, words in texts]


def _jumps(q: Quantity) -> list[Form]:
    shapes = [
        FormConstant(f"{q.name}_1", q, k * q.size, 1e-3 * q.size, 0.5 * q.size) for k in _SPEEDS
    ]
    root = Form(
        f"{q.ratio}/({q.ratio}^2 + 1e-4)^0.25", (q,), None, f"sign({q.name}) |{q.name}|^0.5"
    )
    return [
        root,
        *(Form(f"tanh({q.name}/{s.name})", (q,), s, f"tanh({q.name}/{{shape}})") for s in shapes),
    ]


def _curves(q: Quantity) -> list[Form]:
    growths = [
        FormConstant(f"{q.name}_1", q, k * q.size, 0.1 * q.size, 5 * q.size) for k in _GROWTHS
    ]
    listed = [
        Form(f"(exp({q.name}/{s.name}) - 1)", (q,), s, f"(exp({q.name}/{{shape}}) - 1)")
        for s in growths
    ]
    for k in _WAVES:
        s = FormConstant(f"{q.name}_2", q, k * q.size, 0.9 * k * q.size, 1.1 * k * q.size)
        for wave in ("sin", "cos"):
            text = f"{wave}(6.283185307*{q.name}/{s.name})"
            listed.append(Form(text, (q,), s, f"{wave}(2 pi {q.name}/{{shape}})"))
    return listed


def _products(a: Quantity, b: Quantity) -> list[Form]:
    listed = [Form(f"{a.ratio}*{b.ratio}", (a, b), None, f"{a.name} {b.name}")]
    for one, two in ((a, b), (b, a)):
        if two.signed:
            for jump in _jumps(two)[1:]:
                listed.append(
                    Form(
                        f"{one.ratio}*{jump.text}",
                        (one, two),
                        jump.shape,
                        f"{one.name} {jump.words}",
                    )
                )
        else:
            listed.append(
                Form(f"{one.ratio}*{two.ratio}^2", (one, two), None, f"{one.name} {two.name}^2")
            )
    return listed
