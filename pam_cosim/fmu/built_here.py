"""Which FMUs this program has built itself on this machine: their code is trusted as that of a Modelica model is."""

from __future__ import annotations

from pathlib import Path

from pam_cosim.cache import cached, digest, folder_in_cache
from pam_cosim.files import read_file

_KIND = "built"


def note_built(content: bytes) -> None:
    """Keeps in the cache that an FMU with this content was built here."""
    cached(_KIND, digest(content), "", bytes)


def is_built_here(fmu: Path) -> bool:
    """Whether this program built a file with this content."""
    try:
        return fmu.is_file() and folder_in_cache(_KIND, digest(read_file(fmu))).exists()
    except OSError:
        return False
