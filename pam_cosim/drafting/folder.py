"""The place of a new data set: drafted beside it, and put there as a whole or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, read_data_set
from pam_cosim.measurement.data_set import FILE_NAME
from pam_cosim.model.interface import Interface
from pam_cosim.wording import shown

_NOT_IN_NAMES = frozenset('\\/:*?"<>|@')


def without_detour(folder: Path) -> Path:
    """The same place, not named by way of folders that are not there: they would have to be made for it."""
    if ".." in folder.parts and not folder.parent.exists():
        return Path(os.path.realpath(folder))
    return folder


def check_place(folder: Path) -> None:
    """Raises InputError where there is something already, or nothing can be made."""
    try:
        if folder.is_symlink() or (folder.exists() and not folder.is_dir()):
            raise InputError("this is no folder; name a new one for the data set", folder)
        if folder.is_dir() and any(folder.iterdir()):
            raise InputError(
                "the folder is not empty, and nothing is overwritten; name a new one", folder
            )
    except OSError as error:
        raise InputError(f"the folder cannot be used: {error.strerror}", shown(folder)) from None


@contextmanager
def temporary_sibling(folder: Path) -> Iterator[Path]:
    """A new folder on the disk of the data set's place, gone at the end.

    Raises:
        InputError: nothing can be written there.
    """
    parent = folder.absolute().parent
    while not parent.exists() and parent != parent.parent:
        parent = parent.parent
    try:
        made = tempfile.TemporaryDirectory(dir=parent, prefix=".new-", ignore_cleanup_errors=True)
    except OSError as error:
        raise InputError(f"the data set cannot be written: {error.strerror}", folder) from None
    with made as name:
        place = Path(name) / "set"
        place.mkdir()
        yield place


def copy_files(files: Sequence[Path], place: Path) -> list[str]:
    """Copies under their own names; where two are called alike, with a number."""
    made = []
    taken = {one.stem.casefold() for one in place.iterdir()} | {Path(FILE_NAME).stem}
    for file in files:
        letters = [c if c.isprintable() and c not in _NOT_IN_NAMES else "_" for c in file.stem]
        stem = "".join(letters) or "run"
        name, number = stem, 2
        while name.casefold() in taken:
            name, number = f"{stem}-{number}", number + 1
        taken.add(name.casefold())
        try:
            shutil.copyfile(file, place / f"{name}{file.suffix}")
        except OSError as error:
            raise InputError(f"the file cannot be copied: {error.strerror}", file) from None
        made.append(f"{name}{file.suffix}")
    return made


def read_draft(
    place: Path, origin: Mapping[str, Path], describe: Callable[[str], Interface]
) -> DataSet:
    """The data set as it reads; an error names the file that the user gave."""
    try:
        return read_data_set(place, describe)
    except InputError as error:
        file = Path(str(error.file)) if error.file is not None else None
        if file is not None and file.name in origin:
            raise type(error)(error.message, origin[file.name], error.line, error.column) from None
        raise type(error)(
            error.message
        ) from None  # Of what the user says, or of a draft that is gone.


def put(place: Path, folder: Path) -> None:
    """Moves the draft to its place."""
    check_place(folder)
    try:
        folder.absolute().parent.mkdir(parents=True, exist_ok=True)
        if folder.is_dir():
            folder.rmdir()
        os.replace(place, folder)
    except OSError as error:
        raise InputError(f"the data set cannot be written: {error.strerror}", folder) from None
