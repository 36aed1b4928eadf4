"""A directory of results that are costly to make, keyed by the content they were made from."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Mapping
from pathlib import Path

import platformdirs

from pam_cosim.files import make_folder, write_bytes


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


def folder_in_cache(kind: str, key: str) -> Path:
    """Where ``cached_folder`` has its files, which need not be there."""
    return cache_dir() / kind / key


def cached_folder(kind: str, key: str, last: str, make: Callable[[], Mapping[str, bytes]]) -> Path:
    """As ``cached``, for a folder of files by name; the one that is named ``last`` says that all are there."""
    path = folder_in_cache(kind, key)
    if not (path / last).exists():
        files = dict(make())
        for name in sorted(files, key=lambda name: name == last):
            make_folder((path / name).parent)
            write_bytes(path / name, files[name])
    return path


def cached(kind: str, key: str, suffix: str, make: Callable[[], bytes]) -> Path:
    """The file with the content ``make()`` for this key, made at most once per cache.

    Two processes that make the same file at once both succeed; the later one replaces an equal file.

    Raises:
        InputError: the cache cannot be written.
    """
    path = cache_dir() / kind / f"{key}{suffix}"
    if not path.exists():
        content = make()
        make_folder(path.parent)
        write_bytes(path, content)
    return path
