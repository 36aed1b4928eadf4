"""Small helpers for messages a person can act on."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches

_LONGEST = 60
_LONGEST_LINE = 200
_MOST_NAMES = 20
_NUMBER = re.compile(r"[-+]?\d[\d.]*(?:e[-+]?\d+)?")
_ALIKE = 0.55  # of the letters, from which on a name may have been meant


def shown(value: object) -> str:
    """``value`` as it may stand in a message: quoted, and cut when it is long."""
    text = str(value)
    return repr(text if len(text) <= _LONGEST else text[:_LONGEST] + "...")


def printable(text: str) -> str:
    """A line of foreign text: characters that would control a terminal are replaced by blanks."""
    if text.isprintable():
        return text
    return "".join(letter if letter.isprintable() else " " for letter in text)


def listed(names: Iterable[str]) -> str:
    """``a, b, c``, cut after some twenty names; "none" when there are none."""
    names = list(names)
    omitted = len(names) - _MOST_NAMES
    return (", ".join(names[:_MOST_NAMES]) or "none") + (
        f" and {omitted} more" if omitted > 0 else ""
    )


def enumeration(names: Iterable[str]) -> str:
    """``a, b and c``; "" when there are none."""
    *leading, last = [*names] or [""]
    return f"{', '.join(leading)} and {last}" if leading else last


def words(identifier: str) -> str:
    """An identifier as words: "dry_friction" is "dry friction"."""
    return identifier.replace("_", " ")


def look_first(texts: Iterable[str]) -> list[str]:
    """A line for each text that a person reads before the result."""
    return [f"  LOOK FIRST: {text}" for text in texts]


def distinct_warnings(warnings: Mapping[str, Sequence[str]]) -> tuple[str, ...]:
    """Each warning of a model once, whatever its numbers, after the names of its runs.

    Args:
        warnings: of every run, by its name.
    """
    by_text: dict[str, dict[str, str]] = {}
    for run, texts in warnings.items():
        for text in texts:
            by_text.setdefault(_NUMBER.sub("", text), {}).setdefault(run, text)
    return tuple(_warning(by_run, len(warnings)) for by_run in by_text.values())


def _warning(by_run: Mapping[str, str], count: int) -> str:
    (run, text), *_ = by_run.items()
    runs = "every run" if len(by_run) == count > 1 else listed(by_run)
    return f"{runs}: {text}" + (f" (in {run})" if len({*by_run.values()}) > 1 else "")


def runs_in_words(count: int) -> str:
    """``1 run``, ``2 runs``."""
    return f"{count} run" if count == 1 else f"{count} runs"


def closest(name: str, candidates: Iterable[str], most: int = 1) -> list[str]:
    """The names among ``known`` that ``name`` may have been meant for, best first; case does not matter.

    A name with all parts of ``name`` in their order comes first: "muscle.sleeve.L0" for "muscle.L0".
    """
    folded = {candidate.casefold(): candidate for candidate in candidates}
    wanted = name[:_LONGEST].casefold()
    longer = sorted((candidate for candidate in folded if has_parts(wanted, candidate)), key=len)
    alike = get_close_matches(wanted, list(folded), n=most, cutoff=_ALIKE)
    return [folded[candidate] for candidate in dict.fromkeys([*longer, *alike])][:most]


def has_parts(name: str, longer: str) -> bool:
    """Whether the parts of a name, between dots, are among those of a longer one in their order."""
    parts = iter(longer.split("."))
    return all(part in parts for part in name.split("."))


def did_you_mean(name: str, candidates: Iterable[str]) -> str:
    """A hint to append to "unknown name": the closest known name, then all of them."""
    candidates = list(candidates)
    close = closest(name, candidates)
    hint = f"did you mean '{close[0]}'? " if close else ""
    return f"{hint}Known: {listed(candidates)}"


class Printed:
    """A product: ``str`` is its text, ``repr`` is one line of it, and a notebook shows the text."""

    def __init_subclass__(cls, **options: object) -> None:
        """Keeps the line where a dataclass would list every field."""
        super().__init_subclass__(**options)
        cls.__repr__ = cls.__repr__  # type: ignore[method-assign]

    def __str__(self) -> str:
        return ""

    def __repr__(self) -> str:
        line = f"{type(self).__name__}{self._headline()}"
        return line if len(line) <= _LONGEST_LINE else f"{line[: _LONGEST_LINE - 3]}..."

    def _headline(self) -> str:
        """What follows the name of the class in ``repr``: the first line of the text."""
        text = str(self).strip()
        return f": {text.splitlines()[0]}" if text else ""

    def _repr_html_(self) -> str:
        from html import escape  # in notebooks alone

        return f"<pre>{escape(str(self))}</pre>"
