"""A directory of results that are costly to make, keyed by the content they were made from."""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import platformdirs

from pam_cosim.errors import InputError


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


@contextmanager
def written_whole(path: Path) -> Iterator[Path]:
    """A temporary path beside ``path`` that takes its place when the block ends well, and vanishes otherwise.

    Raises:
        InputError: the directory cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
    except OSError as error:
        raise InputError(f"cannot write here: {error.strerror}", path) from error
    os.close(handle)
    temporary = Path(name)
    try:
        yield temporary
        temporary.chmod(0o644)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def cached(kind: str, key: str, suffix: str, make: Callable[[Path], None]) -> Path:
    """The file made by ``make(path)`` for this key, made at most once per cache.

    Two processes that make the same file at once both succeed; the later one replaces an equal file.
    """
    path = cache_dir() / kind / f"{key}{suffix}"
    if not path.exists():
        with written_whole(path) as temporary:
            make(temporary)
    return path
