"""A learned term in words: the formula that a person reads, and the Modelica class."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import Protocol

from pam_cosim.catalogue import EFFECT, library_of
from pam_cosim.compiler import ClassTree
from pam_cosim.diagnosis.description.learning_library import Form, Quantity
from pam_cosim.ledger import BalanceEntry
from pam_cosim.ledger.augmented import TERM
from pam_cosim.units import format_quantity

MISSING = "the missing term's mean square"
_REACH = 10.0  # a coefficient may become this many times larger when it is fitted


class Addend(Protocol):
    """A coefficient [unit of the term] with its standard deviation, times a form."""

    @property
    def coefficient(self) -> float:
        """Coefficient [unit of the term]."""

    @property
    def deviation(self) -> float:
        """Its standard deviation."""

    @property
    def form(self) -> Form:
        """What it is multiplied by."""

    @property
    def reach(self) -> float:
        """Size of the coefficient by which its bounds are set; 0: its own."""


def formula_text(entry: BalanceEntry, terms: Sequence[Addend]) -> str:
    """The formula with numbers and units, such as ``force [N] = 5.1 N (exp(x/40 mm) - 1)``."""
    if not terms:
        return f"missing {entry.balance} = 0"
    text, where = "", dict[str, None]()
    for t in terms:
        words = "" if t.form.words == "1" else f" {t.form.words}"
        if t.form.shape is not None:
            words = words.replace(
                "{shape}", f"({format_quantity(t.form.shape.value, t.form.shape.of.unit)})"
            )
        sign = (
            ("-" if t.coefficient < 0 else "")
            if not text
            else (" - " if t.coefficient < 0 else " + ")
        )
        text += f"{sign}{_sized(abs(t.coefficient), entry.unit)}{words}"
        sizes = {q.name: format_quantity(q.size, q.unit) for q in _divided(t.form)}
        where |= dict.fromkeys(f"{name} stands for {name}/({size})" for name, size in sizes.items())
    return f"missing {entry.balance} = {text}" + (f", where {'; '.join(where)}" if where else "")


def _sized(value: float, unit: str) -> str:
    return f"{value:.4g} {unit}".rstrip()


def modelica_text(
    tree: ClassTree,
    name: str,
    entry: BalanceEntry,
    terms: Sequence[Addend],
    score: float,
    explained: str = MISSING,
) -> str:
    """The term as an effect class, family "learned"; ``score`` is the part of what is ``explained``."""
    absent = ",".join(f"c_{i}=0" for i in range(1, len(terms) + 1))
    says = 'final family="learned"'
    lines = [
        f'model {name} "Term in the balance of {entry.balance} that describes what a measurement lacks"'
    ]
    effect = f"{library_of(entry.base)}.{EFFECT}"
    if tree.is_subtype(entry.base, effect):
        lines.append(f'  extends {entry.base}({says}, final absent="{absent}");')
    else:
        lines.append(f"  extends {entry.base};")
        lines.append(f'  extends {effect}({says}, final balance="{entry.balance}");')
    body, shapes = [], dict[str, str]()
    for i, t in enumerate(terms, 1):
        size = _rounded(t.reach or abs(t.coefficient))
        reach = _rounded(_REACH * (t.reach or abs(t.coefficient)))
        lines.append(
            f'  parameter Real c_{i}(unit="{entry.unit}", min={-reach:.6g}, max={reach:.6g}, '
            f'nominal={size:.6g}) = {t.coefficient:.6g} "Coefficient of {_plain(t.form)}";'
        )
        text = t.form.text
        if t.form.shape is not None:
            s, own = t.form.shape, f"s_{i}"
            low, high = max(s.low, s.value / 5), min(s.high, s.value * 5)
            shapes[own] = (
                f'  parameter Real {own}(unit="{s.of.unit}", min={low:.6g}, max={high:.6g}, '
                f'nominal={_rounded(s.value):.6g}) = {s.value:.6g} "Scale of {s.of.name} in addend {i}";'
            )
            text = text.replace(s.name, own)
        body.append(f"c_{i}" if text == "1" else f"c_{i}*{text}")
    lines += shapes.values()
    sizes = {q.scale: q for t in terms for q in _divided(t.form)}
    lines += ["protected"] if sizes else []
    lines += [
        f'  constant Real {n}(unit="{q.unit}") = {q.size:.6g} "Size of {q.name}";'
        for n, q in sorted(sizes.items())
    ]
    lines += ["equation", f"  {TERM} = {' + '.join(body) or '0'};"]
    says = (
        f"<p>{formula_text(entry, terms).replace('<', '&lt;')}. Source: learned from a measurement; it explains "
        f"{100 * score:.0f} % of {explained} in runs that it was not learned from. It is a "
        "description, not a cause: another formula may describe the same measurement as well, and beyond the range "
        "that was measured it means nothing.</p>"
    )
    lines += ['  annotation (Documentation(info="<html>', *textwrap.wrap(says, 116)]
    lines.append(
        f"<p>Fingerprint: {entry.meaning[:1].lower() + entry.meaning[1:]}, of the form of the formula.</p>"
    )
    return "\n".join([*lines, '</html>"));', f"end {name};", ""])


def _divided(form: Form) -> list[Quantity]:
    return [q for q in form.quantities if q.scale in form.text]


def _plain(form: Form) -> str:
    return form.words.replace("{shape}", "its scale").replace('"', "'")


def _rounded(value: float) -> float:
    return float(f"{value:.1g}") or 1.0
