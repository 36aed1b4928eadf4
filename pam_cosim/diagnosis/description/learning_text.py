"""A learned term in words: the formula that a person reads, and the Modelica class."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass

from pam_cosim.catalogue import EFFECT, library_of
from pam_cosim.compiler import ClassTree
from pam_cosim.diagnosis.description.forms import Form, Quantity
from pam_cosim.ledger.augmented import TERM
from pam_cosim.units import format_quantity

_REACH = 10.0  # a coefficient may become this many times larger when it is fitted


@dataclass(frozen=True)
class TermPlace:
    """Where a term acts.

    Attributes:
        balance: in which it acts. base: full name of the partial class whose equation for the term is open.
        unit: of the term. meaning: what is positive.
    """

    balance: str
    base: str
    unit: str
    meaning: str


@dataclass(frozen=True)
class Addend:
    """A coefficient [unit of the term] times a form; ``reach``: the size by which its bounds are set."""

    coefficient: float
    form: Form
    reach: float


def formula_text(place: TermPlace, addends: Sequence[Addend]) -> str:
    """The formula with numbers and units, such as ``missing force = 5.1 N x, where x stands for x/(40 mm)``."""
    text, scales = "", dict[str, None]()
    for addend in addends:
        words = f" {addend.form.words}" * (addend.form.words != "1")
        sign = "-" if addend.coefficient < 0 else "+"
        sign = f" {sign} " if text else sign.removeprefix("+")
        text += f"{sign}{f'{abs(addend.coefficient):.4g} {place.unit}'.rstrip()}{words}"
        sizes = {q.name: format_quantity(q.size, q.unit) for q in _divided(addend.form)}
        scales |= dict.fromkeys(
            f"{name} stands for {name}/({size})" for name, size in sizes.items()
        )
    return f"missing {place.balance} = {text}" + (f", where {'; '.join(scales)}" if scales else "")


def modelica_text(
    tree: ClassTree, name: str, place: TermPlace, addends: Sequence[Addend], score: float
) -> str:
    """The term as an effect class, family "learned"; ``score``: part of the mean square error that it explains."""
    absent = ",".join(f"c_{i}=0" for i in range(1, len(addends) + 1))
    says = 'final family="learned"'
    lines = [
        f'model {name} "Term in the balance of {place.balance} that describes what a measurement lacks"'
    ]
    effect = f"{library_of(place.base)}.{EFFECT}"
    if tree.is_subtype(place.base, effect):
        lines.append(f'  extends {place.base}({says}, final absent="{absent}");')
    else:
        lines.append(f"  extends {place.base};")
        lines.append(f'  extends {effect}({says}, final balance="{place.balance}");')
    body = []
    for i, addend in enumerate(addends, 1):
        reach = _rounded(_REACH * addend.reach)
        lines.append(
            f'  parameter Real c_{i}(unit="{place.unit}", min={-reach:.6g}, max={reach:.6g}, '
            f'nominal={_rounded(addend.reach):.6g}) = {addend.coefficient:.6g} "Coefficient of {addend.form.words}";'
        )
        body.append(f"c_{i}" if addend.form.text == "1" else f"c_{i}*{addend.form.text}")
    sizes = {q.scale: q for addend in addends for q in _divided(addend.form)}
    lines += ["protected"] if sizes else []
    lines += [
        f'  constant Real {n}(unit="{q.unit}") = {q.size:.6g} "Size of {q.name}";'
        for n, q in sorted(sizes.items())
    ]
    lines += ["equation", f"  {TERM} = {' + '.join(body)};"]
    says = (
        f"<p>{formula_text(place, addends).replace('<', '&lt;')}. Source: learned from a measurement; it explains "
        f"{100 * score:.0f} % of the model's mean square error in runs that it was not learned from. It is a "
        "description, not a cause: another formula may describe the same measurement as well, and beyond the range "
        "that was measured it means nothing.</p>"
    )
    lines += ['  annotation (Documentation(info="<html>', *textwrap.wrap(says, 116)]
    lines.append(
        f"<p>Fingerprint: {place.meaning[:1].lower() + place.meaning[1:]}, of the form of the formula.</p>"
    )
    return "\n".join([*lines, '</html>"));', f"end {name};", ""])


def _divided(form: Form) -> list[Quantity]:
    return [q for q in form.quantities if q.scale in form.text]


def _rounded(value: float) -> float:
    return float(f"{value:.1g}") or 1.0
