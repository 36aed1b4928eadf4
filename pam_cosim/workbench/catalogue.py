"""Effects of the catalogue as a page shows them: with their equations and their fingerprint."""

from __future__ import annotations

import re
from collections.abc import Collection
from html import unescape

from pam_cosim.catalogue import EffectClass
from pam_cosim.workbench.protocol import ShownEffect

_EQUATIONS = re.compile(
    r"^\s*(?:initial\s+)?equation\s*$\n(.*?)(?=^\s*(?:annotation\b|end\s+\w+\s*;|protected\b))", re.M | re.S
)
_FINGERPRINT = re.compile(r"<p>\s*Fingerprint:\s*(.*?)</p>", re.S)
_SOURCE = re.compile(r"Source:\s*(.*?)(?:\.\s+[A-Z]|</p>)", re.S)
_TAG = re.compile(r"<[^>]*>")


def shown_effect(effect: EffectClass, on: Collection[str], fits: bool) -> ShownEffect:
    """An effect with what its class and its documentation say."""
    return ShownEffect(
        name=effect.name,
        family=effect.family.replace("_", " "),
        balance=effect.balance,
        description=effect.description,
        equation=_equations(effect),
        fingerprint=_said(effect.documentation, _FINGERPRINT),
        source=_said(effect.documentation, _SOURCE),
        on=effect.name in on,
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
