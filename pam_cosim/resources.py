"""Where the Modelica library, the C runtime and the demonstration lie: in the repository, or inside a wheel."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).parent


def _find(name: str, place: str = "") -> Path:
    inside = _PACKAGE / "_resources" / name
    return inside if inside.exists() else _PACKAGE.parent / (place or name)


def modelica_root() -> Path:
    """Directory that holds the packages of the Modelica library."""
    return _find("modelica")


def shipped_models() -> Path:
    """Directory of the compiled models that come with a wheel; it need not be there."""
    return _find("shipped")


def fmu_runtime() -> Path:
    """Directory that holds the C sources of the FMU runtime."""
    return _find("fmu")


def demonstration_data() -> Path:
    """Directory of the data set that ``pam-cosim demo`` diagnoses."""
    return _find("demo", "examples/hidden-spring")
