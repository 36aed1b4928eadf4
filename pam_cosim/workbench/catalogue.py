"""Effects of the catalogue as a page shows them: with their equations and their fingerprint."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import replace
from html import unescape
from pathlib import Path

from pam_cosim.catalogue import EffectClass, compose_on, effect_classes, origins, qualified
from pam_cosim.compiler import read_library, read_structure
from pam_cosim.names import is_fmu, is_modelica
from pam_cosim.workbench.protocol import ShownEffect

_EQUATIONS = re.compile(
    r"^\s*(?:initial\s+)?equation\s*$\n(.*?)(?=^\s*(?:annotation\b|end\s+\w+\s*;|protected\b))", re.M | re.S
)
_FINGERPRINT = re.compile(r"<p>\s*Fingerprint:\s*(.*?)</p>", re.S)
_SOURCE = re.compile(r"Source:\s*(.*?)(?:\.\s+[A-Z]|</p>)", re.S)
_TAG = re.compile(r"<[^>]*>")


class Catalogue:
    """The effects of models, each looked up once.

    Args:
        files: further Modelica files.
    """

    def __init__(self, files: Sequence[Path]) -> None:
        self.files = tuple(files)
        self._known: dict[str, tuple[ShownEffect, ...]] = {}

    def shown(self, model: str, on: Collection[str]) -> tuple[ShownEffect, ...]:
        """Every effect of the model's library, and whether it finds a place in it; none for an FMU."""
        if is_fmu(model):
            return ()
        if model not in self._known:
            sources = [*self.files, Path(model)] if is_modelica(model) else list(self.files)
            tree = read_library(files=sources)
            structure = read_structure(qualified(tree, model), files=sources)
            self._known[model] = tuple(
                shown_effect(e, compose_on(tree, structure, (e.name,)) is not None)
                for e in effect_classes(tree, origins(structure.parts))
            )
        return tuple(replace(e, on=e.name in on) for e in self._known[model])


def shown_effect(effect: EffectClass, fits: bool) -> ShownEffect:
    """An effect with what its class and its documentation say."""
    return ShownEffect(
        name=effect.name,
        family=effect.family.replace("_", " "),
        balance=effect.balance,
        description=effect.description,
        equation=_equations(effect),
        fingerprint=_said(effect.documentation, _FINGERPRINT),
        source=_said(effect.documentation, _SOURCE),
        on=False,
        fits=fits,
    )


def _equations(effect: EffectClass) -> str:
    try:
        text = effect.file.read_text(encoding="utf-8")
    except OSError:
        return ""
    own = re.search(rf"\b(?:model|block|class)\s+{effect.name}\b.*?\bend\s+{effect.name}\s*;", text, re.S)
    parts = _EQUATIONS.findall(own.group() if own else "")
    return "\n".join(line.strip() for part in parts for line in part.splitlines() if line.strip())


def _said(documentation: str, part: re.Pattern[str]) -> str:
    said = part.search(documentation)
    return "" if said is None else " ".join(unescape(_TAG.sub("", said.group(1))).split())
