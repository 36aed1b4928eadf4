"""Words for the two states of a switch, as controllers and their engineers write them into a recording."""

from __future__ import annotations

from collections.abc import Iterable

_ON = (
    "on",
    "true",
    "open",
    "high",
    "ein",
    "an",
    "auf",
    "offen",
    "wahr",
    "ouvert",
    "vrai",
    "marche",
)
_OFF = (
    "off",
    "false",
    "closed",
    "low",
    "aus",
    "zu",
    "geschlossen",
    "falsch",
    "fermé",
    "ferme",
    "faux",
    "arrêt",
)

SWITCH_WORDS = {word: float(word in _ON) for word in (*_ON, *_OFF)}
"""1 or 0 by the word in small letters."""


def are_switch_words(cells: Iterable[str]) -> bool:
    """Whether there are cells, and each is a word for a state of a switch."""
    small = [cell.casefold() for cell in cells]
    return bool(small) and all(cell in SWITCH_WORDS for cell in small)
