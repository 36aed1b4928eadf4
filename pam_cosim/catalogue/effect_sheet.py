"""One effect in full: its equations, its documentation, its parameters, and the benches that have a place."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from html import unescape
from pathlib import Path
from textwrap import dedent, fill
from typing import Any

from pam_cosim.catalogue.compose import compose_on
from pam_cosim.catalogue.effects import EffectClass
from pam_cosim.catalogue.place import is_effect, unit_of
from pam_cosim.catalogue.series import modified
from pam_cosim.compiler import ClassTree, Structure, names
from pam_cosim.compiler.class_info import ComponentInfo
from pam_cosim.wording import Printed

_EQUATIONS = re.compile(
    r"^\s*equation\s*$\n(.*?)(?=^\s*(?:annotation\b|end\s+\w+\s*;|protected\b|initial\b))",
    re.M | re.S,
)
_DRAWN = re.compile(r"\s*annotation\s*\(Line\(.*?\)\)(?=;)", re.S)
_PARAGRAPH = re.compile(r"<p>(.*?)</p>", re.S)
_LINK = re.compile(r"</?a\b[^>]*>")
_TAG = re.compile(r"<[^>]*>")
_SOURCE = re.compile(r"Source:\s*(.*?)(?:\.\s+[A-Z]|$)", re.S)
_FINGERPRINT = "Fingerprint:"
_WORDS = ("String", "Boolean")
_WIDTH = 100  # letters of a line


@dataclass(frozen=True)
class EffectParameter(Printed):
    """A parameter of an effect that a diagnosis fits, numbers in its unit.

    Attributes:
        name, unit, description: as declared.
        default, min, max: as declared; None for what is no number.
        typical: ends of the range in which 95 % of all rigs have it; None: not known.
        absent: its value where the effect vanishes; None: any, or there is none.
        at_min, at_max: the effect that is left at a bound; "": none, None: the law stays as it is.
        limit: ("above", "x"), or "below", of a limit that lies beyond all that a signal shows.
    """

    name: str
    unit: str
    description: str
    default: float | None
    min: float | None
    max: float | None
    typical: tuple[float, float] | None
    absent: float | None
    at_min: str | None
    at_max: str | None
    limit: tuple[str, str] | None

    def __str__(self) -> str:
        ends = f", {self.min:g} to {self.max:g}" if None not in (self.min, self.max) else ""
        default = "" if self.default is None else f" = {self.default:g}"
        parts = [f"{self.name}{default} [{self.unit or '1'}]{ends}: {self.description}"]
        if self.typical:
            parts.append("typical {:g} to {:g}".format(*self.typical))
        for end, limit_value in (("minimum", self.at_min), ("maximum", self.at_max)):
            if limit_value is not None:
                parts.append(f"at its {end}: {limit_value or 'nothing'}")
        if self.limit:
            parts.append(f"{self.limit[0]} all that {self.limit[1]} shows")
        return "; ".join(parts)


@dataclass(frozen=True)
class EffectSheet(Printed):
    """The sheet of an effect.

    Attributes:
        effect: as its class declares it.
        equations: of its class and of what it extends, a line each, as of ``equations``.
        paragraphs: of its documentation, as plain text.
        parameters: those that a diagnosis fits.
        benches: names of the benches that have a place for it.
    """

    effect: EffectClass
    equations: tuple[str, ...]
    paragraphs: tuple[str, ...]
    parameters: tuple[EffectParameter, ...]
    benches: tuple[str, ...]

    @property
    def source(self) -> str:
        """Where the law comes from."""
        return source(self.paragraphs)

    @property
    def fingerprint(self) -> str:
        """What it changes in a measurement."""
        return fingerprint(self.paragraphs)

    def __str__(self) -> str:
        lines = [str(self.effect), "", "equations:", *(f"  {line}" for line in self.equations), ""]
        lines += [f"{fill(text, _WIDTH)}\n" for text in self.paragraphs]
        lines += ["parameters:", *(f"  {parameter}" for parameter in self.parameters)]
        absent = ", ".join(f"{name} = {value:g}" for name, value in self.effect.absent.items())
        lines.append(f"vanishes at {absent}" if absent else "no values give the base law back")
        return "\n".join([*lines, f"has a place in: {', '.join(self.benches) or 'no bench'}"])

    def as_dict(self) -> dict[str, Any]:
        """The record for JSON, SI units."""
        e = self.effect
        return {
            "effect": e.name,
            "class": e.qualified_name,
            "family": e.family,
            "balance": e.balance,
            "general": e.general,
            "description": e.description,
            "equations": list(self.equations),
            "documentation": list(self.paragraphs),
            "source": self.source,
            "fingerprint": self.fingerprint,
            "parameters": {p.name: asdict(p) for p in self.parameters},
            "absent": dict(e.absent),
            "benches": list(self.benches),
        }


def effect_sheet(
    tree: ClassTree, effect: EffectClass, structures: Mapping[str, Structure]
) -> EffectSheet:
    """The sheet of an effect.

    Args:
        tree: the library and the user's files.
        effect: the effect.
        structures: of the benches to try it on, by name.
    """
    return EffectSheet(
        effect,
        equations(tree, effect),
        paragraphs(effect),
        _parameters(tree, effect),
        tuple(
            bench
            for bench, structure in structures.items()
            if compose_on(tree, structure, (effect.qualified_name,)) is not None
        ),
    )


def equations(tree: ClassTree, effect: EffectClass) -> tuple[str, ...]:
    """The equations of an effect, a line each: of its variables, then as written.

    With those of the effects that it extends, and of the other bases in its package.
    """
    classes = [effect.qualified_name, *tree.bases(effect.qualified_name)]
    package = names.parent(effect.qualified_name)
    effect_bases = [
        c for c in reversed(classes) if names.parent(c) == package or is_effect([c, *tree.bases(c)])
    ]
    lines = [
        f"{c.name} = {c.value};"
        for c in tree.components(effect.qualified_name)
        if c.value
        and c.owner in effect_bases
        and "parameter" not in c.prefixes
        and c.type not in _WORDS
    ]
    texts = [dedent(text) for name in effect_bases for text in _written_equations(tree, name)]
    return (*lines, *(line for text in texts for line in _DRAWN.sub("", text).splitlines() if line))


def _written_equations(tree: ClassTree, name: str) -> list[str]:
    short = re.escape(names.last(name))
    try:
        text = Path(tree.classes[name].file).read_text(encoding="utf-8")
    except OSError:
        return []
    declaration = re.search(
        rf"\b(?:model|block|class)\s+{short}\b.*?\bend\s+{short}\s*;", text, re.S
    )
    return _EQUATIONS.findall(declaration.group() if declaration else "")


def paragraphs(effect: EffectClass) -> tuple[str, ...]:
    """The paragraphs of the documentation, as plain text."""
    texts = (_TAG.sub("", _LINK.sub("", text)) for text in _PARAGRAPH.findall(effect.documentation))
    return tuple(" ".join(unescape(text).split()) for text in texts)


def source(texts: Sequence[str]) -> str:
    """Where a law comes from, of the paragraphs of its documentation."""
    match = next(filter(None, map(_SOURCE.search, texts)), None)
    return "" if match is None else match.group(1)


def fingerprint(texts: Sequence[str]) -> str:
    """What an effect changes in a measurement, of the paragraphs of its documentation."""
    fingerprint = next((text for text in texts if text.startswith(_FINGERPRINT)), "")
    return fingerprint.removeprefix(_FINGERPRINT).strip()


def _parameters(tree: ClassTree, effect: EffectClass) -> tuple[EffectParameter, ...]:
    declared = {c.name: c for c in tree.components(effect.qualified_name)}
    return tuple(_parameter(tree, effect, declared[name]) for name in effect.parameters)


def _parameter(tree: ClassTree, effect: EffectClass, component: ComponentInfo) -> EffectParameter:
    name, modifications = component.name, modified(tree, effect.qualified_name, component)
    at_min, at_max = effect.simpler.get(name, (None, None))
    return EffectParameter(
        name=name,
        unit=unit_of(tree, component),
        description=component.description,
        default=_number(modifications["value"]),
        min=_number(modifications["min"]),
        max=_number(modifications["max"]),
        typical=effect.typical.get(name),
        absent=effect.absent.get(name),
        at_min=at_min,
        at_max=at_max,
        limit=effect.limits.get(name),
    )


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None
