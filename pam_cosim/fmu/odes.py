"""Compiled models by the content that they were made from: in the cache, or shipped with the package.

What a data set leaves free, and whether a model is compiled to machine code or stays data, comes after that.
"""

from __future__ import annotations

import json
import lzma
import zlib
from collections.abc import Callable, Mapping
from functools import cache, partial
from pathlib import Path

from pam_cosim.cache import cached
from pam_cosim.compiler import Ode, ode_bytes, read_ode
from pam_cosim.files import make_folder, write_bytes
from pam_cosim.resources import shipped_models

_KIND, _SUFFIX = "odes", ".ode"
_INDEX = "index.json"
_LETTERS = 16  # of a key, which distinguish the shipped models


def cached_ode(key: str, make: Callable[[], Ode]) -> Ode:
    """The model in the cache; ``make`` is called only where it is neither there nor shipped."""
    models: list[Ode] = []

    def content() -> bytes:
        shipped = _shipped(key)
        if shipped is not None:
            return zlib.compress(shipped)
        models.append(make())
        return zlib.compress(ode_bytes(models[0]))

    path = cached(_KIND, key, _SUFFIX, content)
    return models[0] if models else read_ode(zlib.decompress(path.read_bytes()))


def _shipped(key: str) -> bytes | None:
    """The model as it came with the package; all others of its archive go to the cache with it."""
    name = _index().get(key[:_LETTERS])
    if name is None:
        return None
    models = _archive(name)
    for other, content in models.items():
        if other != key:
            cached(_KIND, other, _SUFFIX, partial(zlib.compress, content))
    return models.get(key)


@cache
def _index() -> dict[str, str]:
    """Archive of each model, by the first letters of its key."""
    file = shipped_models() / _INDEX
    index: dict[str, str] = json.loads(file.read_bytes()) if file.exists() else {}
    return index


def _archive(name: str) -> dict[str, bytes]:
    lengths, _, content = lzma.decompress((shipped_models() / name).read_bytes()).partition(b"\n")
    models, at = {}, 0
    for key, length in json.loads(lengths).items():
        models[key] = content[at : at + length]
        at += length
    return models


def write_archives(folder: Path, archives: Mapping[str, Mapping[str, bytes]]) -> None:
    """Writes models by archive and key into a folder, as ``cached_ode`` finds them there."""
    make_folder(folder)
    index = {}
    for name, models in archives.items():
        head = json.dumps({key: len(content) for key, content in models.items()}).encode()
        write_bytes(
            folder / name, lzma.compress(head + b"\n" + b"".join(models.values()), preset=9)
        )
        index.update({key[:_LETTERS]: name for key in models})
    write_bytes(folder / _INDEX, json.dumps(index).encode())
