"""An ODE to an FMI 2.0 FMU for co-simulation and, without delays, model exchange."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable, Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import InputError
from pam_cosim.files import write_bytes
from pam_cosim.fmu.cache import cached, digest, make_folder
from pam_cosim.fmu.compile import (
    PLATFORMS,
    binary_folder,
    compile_library,
    native_platform,
    source_key,
    universal_binary,
)
from pam_cosim.fmu.description import model_description, model_identifier
from pam_cosim.fmu.generate import model_source
from pam_cosim.fmu.table import table

RUNTIME = (
    "pam_cosimulation.c", "pam_exchange.c", "pam_fmi2.c", "pam_history.c", "pam_instance.c", "pam_sensitivity.c",
    "pam_snapshot.c", "pam_solver.c",
)  # fmt: skip

_DATE = (1980, 1, 1, 0, 0, 0)


def build_fmu(ode: Ode, path: Path, *, platforms: Sequence[str] = ("native",)) -> Path:
    """Writes the FMU; the same model gives the same bytes. ``path`` is replaced whole or not at all.

    Args:
        ode: the compiled model.
        path: where the archive goes.
        platforms: keys of ``PLATFORMS``, "native", or "all".

    Returns:
        ``path``.

    Raises:
        ModelError: the model lacks a value or has an unreadable unit.
        InputError: unknown platform, or ``path`` cannot be written.
    """
    content = fmu_bytes(ode, _platform_names(platforms))
    make_folder(path.parent)
    write_bytes(path, content)
    return path


def cached_fmu(key: str, make_ode: Callable[[], Ode], *, platforms: Sequence[str] = ("native",)) -> Path:
    """The FMU of a model in the cache; ``make_ode`` is called only when it is not there yet.

    Args:
        key: content that determines the model: sources and the version of what compiles them.
        make_ode: compiles the model.
        platforms: as in ``build_fmu``.
    """
    names = _platform_names(platforms)
    full = digest(key, source_key(RUNTIME), _packaging_key(), *names)
    return cached("fmus", full, ".fmu", lambda: fmu_bytes(make_ode(), names))


def fmu_bytes(ode: Ode, names: Sequence[str]) -> bytes:
    """The archive for the named platforms."""
    files = _contents(ode, names)
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, _DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            entry.create_system = 3
            archive.writestr(entry, files[name])
    return buffer.getvalue()


def _platform_names(platforms: Sequence[str]) -> list[str]:
    chosen: dict[str, None] = {}
    for name in platforms:
        if name == "all":
            chosen |= dict.fromkeys(PLATFORMS)
        elif name == "native" or name in PLATFORMS:
            chosen[native_platform() if name == "native" else name] = None
        else:
            known = ", ".join(["native", "all", *PLATFORMS])
            raise InputError(f"there is no platform '{name}'; choose from {known}")
    return sorted(chosen)


def _tool() -> str:
    try:
        return f"pam-cosim {version('pam-cosim')}"
    except PackageNotFoundError:
        return "pam-cosim"


def _packaging_key() -> str:
    """Changes with this room's own code."""
    return digest(_tool(), version("casadi"), *(f.read_bytes() for f in sorted(Path(__file__).parent.glob("*.py"))))


def _contents(ode: Ode, names: Sequence[str]) -> dict[str, bytes]:
    """Files of the archive by name. The GUID stands for the description and the equations."""
    entries, tool = table(ode), _tool()
    draft = model_description(ode, entries, "", tool)
    sha = digest(draft, model_source(ode, ""), source_key(RUNTIME))
    guid = f"{{{sha[:8]}-{sha[8:12]}-{sha[12:16]}-{sha[16:20]}-{sha[20:32]}}}"
    source = {"model.c": model_source(ode, guid)}
    files = {"modelDescription.xml": model_description(ode, entries, guid, tool)}
    slices: dict[str, list[bytes]] = {}
    for name in names:
        target = PLATFORMS[name]
        binary = f"binaries/{binary_folder(name, names)}/{model_identifier(ode.interface.model)}{target.suffix}"
        slices.setdefault(binary, []).append(compile_library(RUNTIME, source, name).read_bytes())
    return files | {name: thin[0] if len(thin) == 1 else universal_binary(thin) for name, thin in slices.items()}
