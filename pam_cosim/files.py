"""Files are written whole or not at all, and only where there is a file or nothing yet."""

from __future__ import annotations

import os
import re
import stat
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import fields, is_dataclass
from functools import cache, reduce
from math import isfinite
from pathlib import Path
from typing import Any, ClassVar

from pam_cosim.errors import InputError
from pam_cosim.wording import shown

_LONGEST_PREFIX = 50  # of a temporary name, which must not be too long where the name itself is not
MOST_BYTES = 2_000_000_000  # of a file that is read whole
MOST_TEXT = 200_000_000  # of a document, such as JSON
PACKAGE = "package.mo"  # in every folder that is a Modelica package
JSON, TABLE, PAGE = (".json",), (".csv",), (".html", ".htm")  # endings
PICTURE = (".png", ".svg", ".pdf")
MOST_VALUES = 50_000_000  # of a table, 0.4 GB; compressed, they take hardly any place in a file
_AT_ONCE = 1 << 20  # bytes
_MOST_LINKS = 40  # as Linux has it
_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
    stat.S_IFIFO: "a pipe",
    stat.S_IFSOCK: "a socket",
}


def write_bytes(path: Path, content: bytes | bytearray) -> None:
    """Writes ``content`` under a temporary name and moves it to ``path``.

    A link stays a link: what it leads to is replaced.

    Raises:
        InputError: the folder does not exist or cannot be written, or ``path`` is no regular file.
    """
    with written_whole(path) as name:
        name.write_bytes(content)


@contextmanager
def written_whole(path: Path) -> Iterator[Path]:
    """A temporary name next to ``path`` for a program to write; moved to ``path`` at the end, removed after an error.

    Raises:
        InputError: as ``write_bytes``.
    """
    target = _target(path)
    try:
        mode = (
            stat.S_IMODE(os.stat(target).st_mode) & 0o777 if target.exists() else 0o666 & ~_umask()
        )
        handle, name = tempfile.mkstemp(
            prefix=f".{target.name[:_LONGEST_PREFIX]}.", dir=target.parent
        )
        os.close(handle)
    except OSError as problem:
        raise InputError(f"cannot be written: {problem.strerror}", path) from problem
    try:
        yield Path(name)
        os.chmod(name, mode)
        os.replace(name, target)
    except OSError as problem:
        raise InputError(f"cannot be written: {_reason(problem)}", path) from problem
    finally:
        Path(name).unlink(missing_ok=True)


def _reason(problem: OSError) -> str:
    """In the system's words; those of HDF5 and Arrow hold them among others."""
    number = problem.errno or next(iter(re.findall(r"errno[ =]+(\d+)", str(problem))), None)
    return (
        os.strerror(int(number)) if number else " ".join((problem.strerror or str(problem)).split())
    )


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _target(path: Path) -> Path:
    """The regular file, or the place for one, that ``path`` leads to.

    Raises:
        InputError: it is something else, such as a folder or a device; it is a link that leads nowhere.
    """
    place = Path(path)
    try:
        for _ in range(_MOST_LINKS):
            place = Path(os.path.realpath(place.parent)) / place.name
            status = os.lstat(place)
            if not stat.S_ISLNK(status.st_mode):
                break
            if status.st_dev == _processes():  # /dev/stdout: what it leads to has other writers
                raise InputError("is a stream; name a file", path)
            place = place.parent / os.readlink(place)
        else:
            raise InputError("cannot be written: the link leads to itself", path)
    except FileNotFoundError:
        return place
    except OSError as problem:
        raise InputError(f"cannot be written: {problem.strerror}", path) from problem
    _check_kind(status, path)
    if not os.access(place, os.W_OK):
        raise InputError("cannot be written: it is protected", path)
    return place


def check_ending(path: Path, what: str, endings: Sequence[str]) -> None:
    """Refuses a name whose ending is that of another format; a name without an ending is accepted.

    Raises:
        InputError: the name ends in none of ``known``.
    """
    if path.suffix and path.suffix.lower() not in endings:
        raise InputError(f"{what}: name a file that ends in {' or '.join(endings)}", path)


def check_model_file(path: Path) -> None:
    """A model is written as Modelica, in a file whose name is that of the class.

    Raises:
        InputError: the name ends otherwise, or is that of a package.
    """
    if path.suffix != ".mo":
        raise InputError("the model is written as Modelica: name a file that ends in .mo", path)
    if path.name == PACKAGE:
        raise InputError(f"{PACKAGE} makes its folder a package: name a file after the model", path)


def _processes() -> int | None:
    """The device number of ``/proc``, where open files of processes look like links."""
    try:
        return os.stat("/proc").st_dev
    except OSError:
        return None


def write_text(path: Path, text: str) -> None:
    """As ``write_bytes``, for text."""
    write_bytes(path, text.encode())


def write_json(path: Path, content: Any) -> None:
    """As ``write_text``; numbers that do not exist become null. The name ends in ``.json``, or has no ending."""
    check_ending(path, "this is written as JSON", JSON)
    write_text(path, json_text(content))


def plain(value: Any) -> Any:
    """What JSON can hold: lists, dictionaries, texts and numbers; a number that does not exist is None.

    A data class becomes its fields, or the keys that its ``json_keys`` lists; a complex number both parts.
    """
    if type(value) in _PLAIN:
        return value
    if hasattr(value, "as_dict") and not isinstance(value, type):
        return plain(value.as_dict())
    if isinstance(value, Mapping):
        return {str(key): plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    if is_dataclass(value) and not isinstance(value, type):
        return plain_fields(value)
    if isinstance(value, frozenset):
        return sorted(value)
    if isinstance(value, complex):
        return [value.real, value.imag]
    if hasattr(value, "tolist"):  # an array or a number of NumPy, which is not loaded for this
        return plain(value.tolist())
    return None if isinstance(value, float) and not isfinite(value) else value


_PLAIN = (str, int, bool, type(None))


def plain_fields(value: Any, keys: str = "") -> dict[str, Any]:
    """A data class as a dictionary: its fields, the keys of its ``json_keys`` or those stated in the same form, each as
    ``plain`` returns it."""
    content: dict[str, Any] = {}
    for key, path, optional in _json_keys(value.__class__, keys):
        part = plain(reduce(_part, path, value))
        if key.startswith("*"):
            content |= part
        elif part or not optional:
            content[key] = part
    return content


@cache
def _json_keys(kind: Any, keys: str) -> list[tuple[str, list[str], bool]]:
    """Key, names of the attributes that lead to its value, and whether an empty value is left out."""
    keys = keys or getattr(kind, "json_keys", "")
    words = keys.split() or [field.name for field in fields(kind)]
    parts = [(*word.rstrip("?").partition("="), word.endswith("?")) for word in words]
    return [
        (key, (path or key).strip("*").split("."), optional) for key, _, path, optional in parts
    ]


def _part(value: Any, name: str) -> Any:
    """An attribute, the result of a method, or the entry of a dictionary."""
    part = value[name] if isinstance(value, Mapping) else getattr(value, name)
    return part() if callable(part) else part


class Plain:
    """A data class that converts itself to plain data.

    Attributes:
        json_keys: what JSON holds of it, default: its fields. ``key`` is an attribute, or a method without arguments;
            ``key=path.to.attribute`` where the attribute has another name; ``key?`` is left out where it is empty;
            ``*key`` adds the entries of a dictionary.
    """

    json_keys: ClassVar[str] = ""

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON; SI units, and None where there is no number."""
        return plain_fields(self)


def json_text(content: Any) -> str:
    """As JSON; numbers that do not exist become null."""
    import json

    return json.dumps(plain(content), indent=1, allow_nan=False) + "\n"


def read_file(path: Path, most: int = MOST_BYTES) -> bytes:
    """The bytes of a regular file: what a pipe or a device gives has no end.

    Args:
        path: of the file, or a link to it.
        most: bytes that are taken.

    Raises:
        OSError: the file is missing or cannot be read.
        InputError: it is no regular file, or too large.
    """
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    with os.fdopen(handle, "rb") as file:
        status = os.fstat(handle)
        _check_kind(status, path)
        _check_size(status, path, most)
        content = file.read(status.st_size + 1)
        while len(content) <= most and (
            more := file.read(_AT_ONCE)
        ):  # it grows, or does not say its size
            content += more
    if len(content) > most:
        raise InputError(f"has more than {most / 1e6:.0f} MB, which cannot be taken", path)
    return content


def check_regular(path: Path, most: int = MOST_BYTES) -> None:
    """Checks that a file can be opened by a library's reader: a pipe would never end, or never begin.

    Raises:
        InputError: it is missing, no regular file, or too large.
    """
    try:
        status = os.stat(path)
    except FileNotFoundError:
        raise InputError("there is no such file", path) from None
    except (OSError, ValueError) as problem:
        raise InputError(
            f"cannot be read: {getattr(problem, 'strerror', None) or problem}", path
        ) from problem
    _check_kind(status, path)
    _check_size(status, path, most)


def _check_kind(status: os.stat_result, path: Path) -> None:
    if not stat.S_ISREG(status.st_mode):
        raise InputError(
            f"is {_KINDS.get(stat.S_IFMT(status.st_mode), 'no file')}; name a file", path
        )


def _check_size(status: os.stat_result, path: Path, most: int) -> None:
    if status.st_size > most:
        raise InputError(
            f"has {status.st_size / 1e6:.0f} MB; {most / 1e6:.0f} MB can be taken", path
        )


def read_json(path: Path) -> Any:
    """The content of a JSON file.

    Raises:
        InputError: the file is missing or is not JSON.
    """
    import json

    try:
        return json.loads(read_file(path, MOST_TEXT).decode(), object_pairs_hook=_once)
    except _Twice as twice:
        raise InputError(f"the key {shown(twice)} appears twice in one object", path) from None
    except OSError as problem:
        raise InputError(f"cannot be read: {problem.strerror}", path) from problem
    except UnicodeDecodeError as problem:
        raise InputError("cannot be read: it is not UTF-8 text", path) from problem
    except json.JSONDecodeError as problem:
        raise InputError(
            f"not JSON: {problem.msg}", path, problem.lineno, problem.colno
        ) from problem
    except (
        RecursionError,
        ValueError,
    ) as problem:  # nested too deeply; an integer of thousands of digits
        raise InputError(
            "not JSON that can be read: nested too deeply, or a number too long", path
        ) from problem


class _Twice(Exception):
    """A key that an object of JSON has twice: one of its values would be passed over."""


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    content = dict(pairs)
    if len(content) < len(pairs):
        keys = [key for key, _ in pairs]
        raise _Twice(next(key for key in keys if keys.count(key) > 1))
    return content


def check_writable(path: Path, *, new_folder: bool = False) -> None:
    """Finds out before long work whether its result can be written; ``new_folder``: its folder may be made for it.

    Raises:
        InputError: as ``write_bytes``.
    """
    target = _target(path)
    folder, is_link = target.parent, path.is_symlink()
    while new_folder and not is_link and not os.path.lexists(folder) and folder != folder.parent:
        folder = folder.parent
    if not folder.is_dir():
        where = f"the folder of {target}" if is_link else "its folder"
        raise InputError(f"cannot be written: {where} does not exist", path)
    if not os.access(folder, os.W_OK):
        raise InputError("cannot be written: no permission for its folder", path)


def check_distinct(paths: Iterable[Path]) -> None:
    """Refuses two results for one file.

    Raises:
        InputError: names the second of them.
    """
    targets: set[Path] = set()
    for path in paths:
        target = _target(path)
        if target in targets:
            raise InputError("two results would be written to this file; name two", path)
        targets.add(target)


def identity(path: Path) -> object:
    """Something that changes whenever the file is written; None: there is none."""
    try:
        status = os.stat(path)
    except OSError:
        return None
    return status.st_ino, status.st_mtime_ns


def check_spared(results: Iterable[Path], sources: Iterable[Path | str]) -> None:
    """Refuses a result that would replace a file that is read, or one of a Modelica package that is.

    Raises:
        InputError: names that result.
    """
    read = {os.path.realpath(source) for source in sources}
    folders = {
        os.path.dirname(place) if os.path.basename(place) == PACKAGE else place for place in read
    }
    packages = [Path(place) for place in folders if os.path.isfile(os.path.join(place, PACKAGE))]
    for path in results:
        target = _target(path)
        if str(target) in read or any(_is_part(target, package) for package in packages):
            raise InputError(
                "this file is read by the command; name another one for the result", path
            )


def _is_part(target: Path, package: Path) -> bool:
    """Whether a file is there and belongs to a Modelica package, whose folder is given."""
    named = target.suffix == ".mo" or target.name == "package.order"
    return named and target.exists() and target.is_relative_to(package)


def is_vacant(folder: Path) -> bool:
    """Whether a new folder can be made there: nothing exists, or an empty folder.

    Raises:
        InputError: the folder cannot be read.
    """
    try:
        return not folder.exists() or (folder.is_dir() and not any(folder.iterdir()))
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"the folder cannot be read: {reason}", shown(folder)) from None


def make_folder(folder: Path) -> None:
    """Creates a folder with its parents.

    Raises:
        InputError: it cannot be created.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"the folder cannot be made: {error.strerror}", folder) from error
