"""A directory of results that are costly to make, keyed by the content they were made from."""

from __future__ import annotations

import hashlib
import os
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path

import platformdirs

from pam_cosim.errors import InputError
from pam_cosim.files import MOST_TEXT, make_folder, read_file, write_bytes

CAN_BE_MADE_AGAIN = (
    "what the cache holds can be made again: remove it, or name another folder in PAM_COSIM_CACHE"
)
_SUMS = ".sums"  # ends the name of the file with the checksums of the others


def cache_dir() -> Path:
    """The cache: ``PAM_COSIM_CACHE``, or the user's cache directory."""
    chosen = os.environ.get("PAM_COSIM_CACHE")
    return Path(chosen) if chosen else Path(platformdirs.user_cache_dir("pam-cosim"))


def digest(*parts: str | bytes) -> str:
    """A name for content: SHA-256 over the parts and their lengths."""
    sha = hashlib.sha256()
    for part in parts:
        data = part.encode() if isinstance(part, str) else part
        sha.update(f"{len(data)}:".encode())
        sha.update(data)
    return sha.hexdigest()


def cached_folder(kind: str, key: str, make: Callable[[], Mapping[str, bytes]]) -> Path:
    """As ``cached``, for a folder of files by name."""
    path = folder_in_cache(kind, key)
    if not is_whole(path / _SUMS):
        _write(path / _SUMS, make())
    return path


def folder_in_cache(kind: str, key: str) -> Path:
    """Where ``cached_folder`` has its files, which need not be there."""
    return cache_dir() / kind / key


def folder_is_whole(kind: str, key: str) -> bool:
    """Whether ``cached_folder`` has its files."""
    return is_whole(folder_in_cache(kind, key) / _SUMS)


def cached(kind: str, key: str, suffix: str, make: Callable[[], bytes]) -> Path:
    """The file with the content ``make()`` for this key, made once per cache, and again where it was damaged.

    Two processes that make the same file at once both succeed; the later one replaces an equal file.

    Raises:
        InputError: the cache cannot be written.
    """
    path = cache_dir() / kind / f"{key}{suffix}"
    sums = path.with_name(path.name + _SUMS)
    if not is_whole(sums):
        _write(sums, {path.name: make()})
    return path


def _write(sums: Path, files: Mapping[str, bytes]) -> None:
    """Files with their checksums, which are written last."""
    lines = "".join(f"{_sum(content)} {name}\n" for name, content in sorted(files.items()))
    try:
        for name, content in files.items():
            make_folder((sums.parent / name).parent)
            write_bytes(sums.parent / name, content)
        write_bytes(sums, lines.encode())
    except InputError as problem:
        raise InputError(f"{problem.message}; {CAN_BE_MADE_AGAIN}", problem.file) from problem


def _sum(content: bytes) -> str:
    return f"{len(content)} {zlib.crc32(content):08x}"


_State = tuple[int, int, int]
_seen: dict[
    Path, dict[Path, _State]
] = {}  # by a file of sums: what was found whole, and how the files were then


def is_whole(sums: Path) -> bool:
    """Whether the files that a file of sums names hold what was written into them.

    A disk may have been full, or the folder was cleaned. A process reads each file once, as long as it is not written.
    """
    try:
        checked = _seen.get(sums, {})
        if checked and all(_state(path) == state for path, state in checked.items()):
            return True
        _seen[sums] = _states_if_whole(sums)
    except (OSError, ValueError, InputError):
        return False
    return bool(_seen[sums])


def _states_if_whole(sums: Path) -> dict[Path, _State]:
    """How the files are; nothing, where one of them is not what it was."""
    states = {sums: _state(sums)}
    for line in read_file(sums, MOST_TEXT).decode().splitlines():
        size, checksum, name = line.split(" ", 2)
        path = sums.parent / name
        states[path] = _state(path)
        if _sum(read_file(path)) != f"{size} {checksum}":
            return {}
    return states if len(states) > 1 else {}


def _state(path: Path) -> _State:
    status = os.stat(path)
    return status.st_ino, status.st_size, status.st_mtime_ns
