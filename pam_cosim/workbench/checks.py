"""Arguments of commands are checked before they are used."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from pam_cosim.errors import InputError
from pam_cosim.wording import did_you_mean, shown

_MOST = 1000


def names_of(value: Any, command: str) -> list[str]:
    """A list of names.

    Raises:
        InputError: it is none.
    """
    if (
        not isinstance(value, (list, tuple))
        or len(value) > _MOST
        or not all(isinstance(v, str) for v in value)
    ):
        raise InputError(f"{command} needs a list of names, not {shown(value)}")
    return list(dict.fromkeys(value))


def text_of(value: Any, command: str) -> str:
    """A text.

    Raises:
        InputError: it is none.
    """
    if not isinstance(value, str) or not value.strip():
        raise InputError(f"{command} needs a name, not {shown(value)}")
    return value.strip()


def one_of(value: Any, names: Collection[str], kind: str, purpose: str = "") -> str:
    """One of some names.

    Raises:
        InputError: it is none of them.
    """
    if not isinstance(value, str) or value not in names:
        raise InputError(
            f"there is no {kind} {shown(value)}{purpose}; {did_you_mean(str(value), names)}"
        )
    return value


def is_number(value: Any) -> bool:
    """Whether it is a number, as JSON has them."""
    return isinstance(value, (int, float)) and not isinstance(value, bool)
