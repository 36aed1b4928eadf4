"""Names that come from a page: of files of the study's folder, and of nothing else."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection
from itertools import chain, count
from pathlib import Path

from pam_cosim.errors import InputError
from pam_cosim.wording import shown

_LONGEST = 100  # bytes of a name
_NAME = re.compile(r"\w[\w. ()+-]*")


def safe_name(name: str) -> str:
    """A name of a file like one that somebody else gave: what ``inside`` does not allow is an underscore.

    Raises:
        InputError: nothing is left of it.
    """
    last = re.split(r"[\\/]", name)[-1]
    allowed_name = re.sub(r"[^\w.()+ -]", "_", unicodedata.normalize("NFC", last)).lstrip(". -")
    allowed_name = allowed_name.encode()[-_LONGEST:].decode(errors="ignore")
    if not _NAME.fullmatch(allowed_name):
        raise InputError(f"{shown(name)} cannot be the name of a file")
    return allowed_name.rstrip(" .")


def free_name(name: str, names: Collection[str]) -> str:
    """The name of a file, numbered where there is one of that name, in whatever case, already."""
    used = {name_in_use.casefold() for name_in_use in names}
    stem, dot, ending = name.rpartition(".")
    stem, ending = (stem, dot + ending) if stem else (name, "")
    numbered = (f"{_cut(stem, _LONGEST - len(ending.encode()) - 5)}-{i}{ending}" for i in count(2))
    return next(
        candidate for candidate in chain([name], numbered) if candidate.casefold() not in used
    )


def _cut(name: str, length: int) -> str:
    """The beginning of a name, of at most so many bytes."""
    return name.encode()[:length].decode(errors="ignore")


def is_name_here(name: str) -> bool:
    """Whether a file directly inside a folder may have this name."""
    fits = _NAME.fullmatch(name) is not None and len(name.encode()) <= _LONGEST
    return fits and not name.endswith((" ", "."))


def inside(folder: Path, name: str) -> Path:
    """The place of a file directly inside a folder.

    Raises:
        InputError: the name is not that of a file there: it has a separator, begins with a dot, or is a link.
    """
    if not is_name_here(name):
        raise InputError(
            f"{shown(name)} cannot be the name of a file here: use letters, digits, dots, dashes and underscores"
        )
    place = folder / name
    if place.is_symlink() or (place.exists() and not place.is_file()):
        raise InputError(f"{shown(name)} is no regular file of the study's folder")
    return place
