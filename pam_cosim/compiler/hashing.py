"""A content hash of everything that a compiled model depends on."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from functools import lru_cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from pam_cosim.compiler.library import (
    Signature,
    package_folder,
    signature_of,
    source_bytes,
)
from pam_cosim.errors import ModelError
from pam_cosim.model.references import is_modelica
from pam_cosim.resources import modelica_root

_LARGE = 2_000_000  # bytes of a package: a larger one is not read whole for every model


def flat_hash(
    model: str, *, files: Sequence[Path] = (), root: Path | None = None, library: str = ""
) -> str:
    """SHA-256, in hexadecimal, of model name, Modelica sources, this compiler and CasADi's version.

    Arguments as for :func:`pam_cosim.compiler.compile_model`. Where the files lie makes no difference.

    Args:
        model: as there.
        files: as there.
        root: as there.
        library: ``library_hash`` of the same library, where it was computed before.
    """
    digest = hashlib.sha256()
    files = list(files)
    if is_modelica(model):
        files.append(Path(model))
        model = Path(model).name
    _add(digest, model.encode())
    _add(digest, (library or library_hash(root)).encode())
    for file in files:
        if not file.exists():
            raise ModelError("there is no such file", file)
        folder = package_folder(file)
        if folder is None:
            _add(digest, source_bytes(file))
            continue
        parts = signature_of(folder)
        is_large = sum(size for _, _, size in parts) > _LARGE
        for name, changed, size in parts:
            _add(digest, Path(name).relative_to(folder).as_posix().encode())
            _add(digest, f"{changed} {size}".encode() if is_large else source_bytes(Path(name)))
    return digest.hexdigest()


def library_hash(root: Path | None = None) -> str:
    """SHA-256, in hexadecimal, of the library's sources, this compiler and CasADi's version."""
    base = modelica_root() if root is None else root
    return _hash_of_library(base, signature_of(base))


@lru_cache(maxsize=8)
def _hash_of_library(base: Path, of: Signature) -> str:
    """Read again only when a file has changed."""
    digest = hashlib.sha256()
    for file in (Path(name) for name, _, _ in of):
        _add(digest, file.relative_to(base).as_posix().encode())
        _add(digest, file.read_bytes())
    for file in sorted(Path(__file__).parent.glob("*.py")):
        _add(digest, file.read_bytes())
    for package in ("casadi", "pam-cosim"):
        try:
            _add(digest, version(package).encode())
        except PackageNotFoundError:
            _add(digest, b"not installed")
    return digest.hexdigest()


def _add(digest: hashlib._Hash, part: bytes) -> None:
    """Add a part with its length, so that parts cannot run into each other."""
    digest.update(len(part).to_bytes(8, "little"))
    digest.update(part)
