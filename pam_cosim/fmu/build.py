"""An ODE to an FMU of FMI 2.0 or 3.0 for co-simulation and, without delays, model exchange."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import casadi as ca

from pam_cosim.cache import cached, cached_folder, digest, folder_in_cache, folder_is_whole
from pam_cosim.compiler.budget import check_source
from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import InputError
from pam_cosim.files import make_folder, write_bytes
from pam_cosim.fmu.about import date, identity
from pam_cosim.fmu.built_here import note_built
from pam_cosim.fmu.c_text import c_string
from pam_cosim.fmu.compile import compile_library, headers, source_key, universal_binary
from pam_cosim.fmu.description import model_identifier
from pam_cosim.fmu.generate import model_source
from pam_cosim.fmu.model_description import build_description, model_description
from pam_cosim.fmu.platforms import PLATFORMS, binary_folder, native_platform
from pam_cosim.fmu.read import TOOL
from pam_cosim.fmu.table import table
from pam_cosim.fmu.tape import NoTapeError, TapedModel, tape_files, taped
from pam_cosim.resources import fmu_runtime

FMI_VERSIONS = ("2.0", "3.0")

_CORE = (
    "pam_cosimulation.c",
    "pam_equilibrium.c",
    "pam_exchange.c",
    "pam_history.c",
    "pam_instance.c",
    "pam_lifecycle.c",
    "pam_log.c",
    "pam_sensitivity.c",
    "pam_snapshot.c",
    "pam_solver.c",
    "pam_start.c",
    "pam_statements.c",
    "pam_values.c",
)
_SHELLS = {"2.0": "pam_fmi2.c", "3.0": "pam_fmi3.c"}

_TAPE = "pam_tape.c"
_MODEL = "model.c"
_DESCRIPTION = "modelDescription.xml"
_PREFIX = """#ifndef {macro}
#define {macro} {identifier}_
#endif
#define PAM_PREFIX {macro}
"""
_NO_GUID = "{00000000-0000-0000-0000-000000000000}"
_DATE = (1980, 1, 1, 0, 0, 0)


def runtime(fmi: str = "2.0") -> tuple[str, ...]:
    """Names of the C files that make up the runtime behind one version of FMI."""
    return tuple(sorted((*_CORE, _SHELLS[fmi])))


def build_fmu(
    ode: Ode, path: Path, *, platforms: Sequence[str] = ("native",), fmi: str = "2.0"
) -> Path:
    """Writes the FMU; the same model gives the same bytes. ``path`` is replaced whole or not at all.

    Args:
        ode: the compiled model.
        path: where the archive goes.
        platforms: keys of ``PLATFORMS``, "native", or "all".
        fmi: version of the interface, "2.0" or "3.0".

    Returns:
        ``path``.

    Raises:
        ModelError: the model lacks a value or has an unreadable unit.
        InputError: unknown platform or version, or ``path`` cannot be written.
    """
    content = fmu_bytes(ode, _platform_names(platforms), _version(fmi))
    make_folder(path.parent)
    write_bytes(path, content)
    return path


def cached_fmu(
    key: str,
    make_ode: Callable[[], Ode],
    *,
    platforms: Sequence[str] = ("native",),
    fmi: str = "2.0",
    documented: Sequence[Path] | None = None,
) -> Path:
    """The FMU of a model in the cache; ``make_ode`` is called only when it is not there yet.

    Args:
        key: content that determines the model: sources and the version of what compiles them.
        make_ode: compiles the model.
        platforms: as in ``build_fmu``.
        fmi: as in ``build_fmu``.
        documented: the user's Modelica files, for an FMU with the date, documentation and pictures; None: without.
    """
    names, kind = _platform_names(platforms), "" if documented is None else "documented"
    full = digest(key, source_key(runtime(_version(fmi))), _packaging_key(), fmi, kind, *names)

    def made() -> bytes:
        content = fmu_bytes(make_ode(), names, fmi, documented)
        note_built(content)
        return content

    return cached("fmus", full, ".fmu", made)


def cached_description(key: str, make_ode: Callable[[], Ode]) -> Path:
    """The model description of ``cached_fmu``, alone in a folder of the cache: made without a compiler.

    Args:
        key: as in ``cached_fmu``.
        make_ode: compiles the model.
    """
    full = digest(key, _packaging_key())
    return cached_folder(
        "descriptions", full, lambda: _descriptions(make_ode(), _NO_GUID, "2.0", lean=False)
    )


def cached_lean_model(key: str, make_ode: Callable[[], Ode]) -> Path:
    """A model for fits, in a folder of the cache that has the layout of an unpacked FMU 2.0 for this machine.

    It holds what simulations and their sensitivities need, and is made and loaded in a fraction of the time: no other
    local variables than states, no directional derivatives, no dependencies, no sources.

    Args:
        key: as in ``cached_fmu``.
        make_ode: compiles the model.
    """
    return cached_folder("models", _lean_key(key), lambda: _compiled(_bare(make_ode())))


def cached_taped_model(key: str, make_ode: Callable[[], Ode]) -> Path:
    """As ``cached_lean_model``, for few runs: where there is none, a model as data, made without a compiler.

    Both give the same numbers. What a model as data cannot say is compiled.
    """
    full = _lean_key(key)
    if folder_is_whole("models", full):
        return folder_in_cache("models", full)
    return cached_folder("tapes", full, lambda: _as_data_or_compiled(_bare(make_ode())))


def cached_whole_taped_model(key: str, make_ode: Callable[[], Ode]) -> Path:
    """As ``cached_taped_model``, with all local variables."""
    full = digest(_lean_key(key), "whole")
    return cached_folder("tapes", full, lambda: _as_data_or_compiled(make_ode()))


def _lean_key(key: str) -> str:
    return digest(key, source_key((*runtime(), _TAPE)), _packaging_key(), "lean", native_platform())


def _bare(ode: Ode) -> Ode:
    return replace(ode, locals=ca.SX(0, 1), interface=replace(ode.interface, locals={}))


def _compiled(ode: Ode) -> dict[str, bytes]:
    return _contents(ode, [native_platform()], "2.0", lean=True)


def _as_data_or_compiled(ode: Ode) -> dict[str, bytes]:
    try:
        return _as_data(ode, taped(ode))
    except NoTapeError:
        return _compiled(ode)


def _as_data(ode: Ode, model: TapedModel) -> dict[str, bytes]:
    """The files of a model as data; each has a copy of the library, for a library that is loaded is one model."""
    draft = _descriptions(ode, _NO_GUID, "2.0", lean=True)[_DESCRIPTION]
    guid = _guid(draft, *tape_files(model, _NO_GUID).values())
    platform = native_platform()
    library = compile_library((*runtime(), _TAPE), {}, platform)
    binary = f"binaries/{binary_folder(platform, [platform])}/{model_identifier(ode.interface.model)}{library.suffix}"
    described = {_DESCRIPTION: draft.replace(_NO_GUID.encode(), guid.encode(), 1)}
    return described | tape_files(model, guid) | {binary: library.read_bytes()}


def fmu_bytes(
    ode: Ode,
    names: Sequence[str],
    fmi: str = "2.0",
    documented: Sequence[Path] | None = None,
) -> bytes:
    """The archive for the named platforms; ``documented`` as in ``cached_fmu``."""
    return archived(_contents(ode, names, fmi, documented=documented))


def archived(files: Mapping[str, bytes]) -> bytes:
    """An archive of files by their names in it; the same files give the same bytes."""
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
            choices = ", ".join(["native", "all", *PLATFORMS])
            raise InputError(f"there is no platform '{name}'; choose from {choices}")
    return sorted(chosen)


def _version(fmi: str) -> str:
    if fmi not in FMI_VERSIONS:
        raise InputError(
            f"there is no FMI version '{fmi}' to build; choose from {', '.join(FMI_VERSIONS)}"
        )
    return fmi


def _tool() -> str:
    try:
        return f"{TOOL} {version(TOOL)}"
    except PackageNotFoundError:
        return TOOL


@cache
def _packaging_key() -> str:
    """Changes with this room's own code."""
    return digest(
        _tool(),
        version("casadi"),
        *(f.read_bytes() for f in sorted(Path(__file__).parent.glob("*.py"))),
    )


def _contents(
    ode: Ode,
    names: Sequence[str],
    fmi: str,
    lean: bool = False,
    documented: Sequence[Path] | None = None,
) -> dict[str, bytes]:
    """Files of the archive by name. The GUID stands for the description and the equations."""
    draft = _descriptions(ode, _NO_GUID, fmi, lean)
    source = model_source(ode, _NO_GUID, lean, fmi)
    check_source(source, ode.interface.model, len(ode.states))
    guid = _guid(draft[_DESCRIPTION], source, source_key(runtime(fmi)))
    # The first place is the right one: both files begin with it.
    source = source.replace(c_string(_NO_GUID), c_string(guid), 1)
    dated = {} if documented is None else {"generationDateAndTime": date()}
    described = _descriptions(ode, guid, fmi, lean, dated)
    if documented is not None:
        from pam_cosim.fmu.documentation import documentation

        described |= documentation(ode, documented, fmi)
    identifier = model_identifier(ode.interface.model)
    shipped = {} if lean else _sources(source, identifier, fmi)
    return described | shipped | _binaries(ode, source, names, fmi)


def _guid(*parts: str | bytes) -> str:
    sha = digest(*parts)
    return f"{{{sha[:8]}-{sha[8:12]}-{sha[12:16]}-{sha[16:20]}-{sha[20:32]}}}"


def _descriptions(
    ode: Ode, guid: str, fmi: str, lean: bool, about: Mapping[str, str] | None = None
) -> dict[str, bytes]:
    entries, compiled = table(ode, fmi, lean=lean), () if lean else (_MODEL, *runtime(fmi))
    attributes = {} if lean else identity(ode) | dict(about or {})
    description = model_description(
        ode, fmi, entries, guid, _tool(), attributes, compiled, lean=lean
    )
    if fmi == "2.0":
        return {_DESCRIPTION: description}
    return {
        _DESCRIPTION: description,
        "sources/buildDescription.xml": build_description(ode, compiled),
    }


def _sources(model: str, identifier: str, fmi: str) -> dict[str, bytes]:
    """Everything that the binaries are compiled from, and the prefix of the functions in a program."""
    shipped = [*(fmu_runtime() / name for name in runtime(fmi)), *headers(fmi)]
    prefix = _PREFIX.format(macro=f"FMI{fmi[0]}_FUNCTION_PREFIX", identifier=identifier)
    return {f"sources/{_MODEL}": model.encode(), "sources/model.h": prefix.encode()} | {
        f"sources/{file.name}": file.read_bytes() for file in shipped
    }


def _binaries(ode: Ode, model: str, names: Sequence[str], fmi: str) -> dict[str, bytes]:
    slices: dict[str, list[bytes]] = {}
    for name in names:
        identifier = model_identifier(ode.interface.model)
        file = identifier + PLATFORMS[name].suffix
        binary = f"binaries/{binary_folder(name, names, fmi)}/{file}"
        slices.setdefault(binary, []).append(
            compile_library(runtime(fmi), {_MODEL: model}, name, identifier).read_bytes()
        )
    return {
        name: thin[0] if len(thin) == 1 else universal_binary(thin) for name, thin in slices.items()
    }
