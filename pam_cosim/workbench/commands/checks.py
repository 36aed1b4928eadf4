"""What a command holds is checked before it is used."""

from __future__ import annotations

from typing import Any

from pam_cosim.errors import InputError
from pam_cosim.wording import shown

_MOST = 1000


def names_of(value: Any, what: str) -> list[str]:
    """A list of names.

    Raises:
        InputError: it is none.
    """
    if (
        not isinstance(value, (list, tuple))
        or len(value) > _MOST
        or not all(isinstance(v, str) for v in value)
    ):
        raise InputError(f"{what} wants a list of names, not {shown(value)}")
    return list(dict.fromkeys(value))


def text_of(value: Any, what: str) -> str:
    """A text.

    Raises:
        InputError: it is none.
    """
    if not isinstance(value, str) or not value.strip():
        raise InputError(f"{what} wants a name, not {shown(value)}")
    return value.strip()
