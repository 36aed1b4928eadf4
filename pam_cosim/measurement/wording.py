"""Small helpers for messages a person can act on."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

_LONGEST = 60
_MOST_NAMES = 20


def shown(value: object) -> str:
    """``value`` as it may stand in a message: quoted, and cut when it is long."""
    text = str(value)
    return repr(text if len(text) <= _LONGEST else text[:_LONGEST] + "...")


def listed(names: Iterable[str]) -> str:
    """``a, b, c``, cut after some twenty names; "none" when there are none."""
    names = list(names)
    rest = len(names) - _MOST_NAMES
    return (", ".join(names[:_MOST_NAMES]) or "none") + (f" and {rest} more" if rest > 0 else "")


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A hint to append to "unknown name": the closest known name, then all of them."""
    known = list(known)
    folded = {one.casefold(): one for one in known}
    close = get_close_matches(name[:_LONGEST].casefold(), list(folded), n=1, cutoff=0.55)
    hint = f"did you mean '{folded[close[0]]}'? " if close else ""
    return f"{hint}Known: {listed(known)}"
