"""C sources to shared libraries with the compiler that the package ``ziglang`` brings."""

from __future__ import annotations

import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import ziglang

from pam_cosim.cache import CAN_BE_MADE_AGAIN, cache_dir, cached, digest
from pam_cosim.errors import InputError
from pam_cosim.fmu.platforms import PLATFORMS, Platform
from pam_cosim.processes.interrupts import run_tool
from pam_cosim.resources import fmu_runtime

# To look for vectors in a model's long straight equations takes a fifth of the compiler's time and finds next to none.
_FLAGS = (
    "-std=c99",
    "-O2",
    "-fno-slp-vectorize",
    "-w",
    "-fvisibility=hidden",
    "-fno-math-errno",
    "-ffp-contract=off",
    "-fno-sanitize=undefined",
    "-fno-trigraphs",
    "-DFMI2_OVERRIDE_FUNCTION_PREFIX",
    "-DFMI3_OVERRIDE_FUNCTION_PREFIX",
)
# Under Linux nothing here needs the compiler's own library of arithmetic, and to build that, once a machine, takes
# longer than a diagnosis; the driver ``zig cc`` cannot leave it out.
_OWN_ARITHMETIC = (
    "build-lib",
    "-dynamic",
    "-fno-compiler-rt",
    "-fstrip",
    "-OReleaseFast",
    "-lc",
    "-lm",
)


_STALE = 3600.0  # [s]
_NO_ROOM = (
    "NoSpaceLeft",
    "ReadOnlyFileSystem",
    "DiskQuota",
    "AccessDenied",
    "No space left",
    "Read-only file system",
)


class CompilerError(RuntimeError):
    """The C compiler refused a generated or shipped source: a defect of this package."""


def _zig() -> Path:
    """The compiler itself: its Python face would cost another interpreter for every model."""
    return Path(ziglang.__file__).parent / ("zig.exe" if sys.platform == "win32" else "zig")


@cache
def _fmi_headers() -> Path:
    package = find_spec("fmpy")  # to load it takes as long as a run
    assert package is not None and package.origin is not None
    return Path(package.origin).parent / "c-code"


def headers(fmi: str) -> list[Path]:
    """The header files that the runtime needs in addition to the C compiler's own, with those of one version of FMI.

    They are those of the releases 2.0.1 and 3.0.1. FMPy changed one of its copies, which has a copy in the runtime.
    """
    files = [*_fmi_headers().glob(f"fmi{fmi[0]}*.h"), *fmu_runtime().glob("pam_*.h")]
    files += fmu_runtime().glob(f"fmi{fmi[0]}*.h")
    return sorted({file.name: file for file in files}.values(), key=lambda file: file.name)


@cache
def _shipped(names: tuple[str, ...]) -> tuple[str, ...]:
    """Contents of the runtime's sources and of every header it may include."""
    files = [fmu_runtime() / name for name in names] + sorted({*headers("2.0"), *headers("3.0")})
    return tuple(f"{path.name}\n{path.read_text(encoding='utf-8')}" for path in files)


def source_key(shipped: Sequence[str]) -> str:
    """Changes whenever the shipped sources, the FMI headers, the flags or the compiler change."""
    return _source_key(tuple(shipped))


@cache
def _source_key(shipped: tuple[str, ...]) -> str:
    return digest(*_shipped(shipped), " ".join((*_FLAGS, *_OWN_ARITHMETIC)), _zig_version())


def _zig_version() -> str:
    """The version, from the name of the folder that ``importlib.metadata`` reads, which takes 20 ms to load."""
    for folder in Path(ziglang.__file__).parents[1].glob("ziglang-*.dist-info"):
        return folder.stem.partition("-")[2]
    from importlib.metadata import version

    return version("ziglang")


def compile_library(
    shipped: Sequence[str],
    generated: Mapping[str, str],
    platform_name: str,
    name: str = "library",
) -> Path:
    """A shared library in the cache, compiled from files of ``fmu/`` and generated sources.

    Args:
        shipped: names of C files in the runtime's directory.
        generated: further C files, name to text.
        platform_name: key of ``PLATFORMS``.
        name: that the library has in itself, without the ending.

    Raises:
        CompilerError: the compiler refused the sources.
    """
    target = PLATFORMS[platform_name]
    texts = [text for item in sorted(generated.items()) for text in item]
    key = digest(source_key(shipped), *texts, target.target, name)
    return cached(
        "binaries", key, target.suffix, lambda: _compile(shipped, generated, target, name)
    )


def _compile(
    shipped: Sequence[str], generated: Mapping[str, str], target: Platform, library: str
) -> bytes:
    with tempfile.TemporaryDirectory(prefix="pam-cosim-") as directory:
        for name, text in generated.items():
            Path(directory, name).write_text(text, encoding="utf-8")
        sources = [str(fmu_runtime() / name) for name in shipped] + sorted(generated)
        output = f"{library}{target.suffix}"
        command = [str(_zig()), *_arguments(target, output, sources)]
        zig = cache_dir() / "zig"
        _clear_stale(zig / "tmp")
        problem = _compiled(command, Path(directory), zig, target)
        if problem:  # its own cache may be damaged
            problem = _compiled(command, Path(directory), Path(directory, "zig"), target)
            if not problem:
                shutil.rmtree(zig, ignore_errors=True)
        if any(reason in problem for reason in _NO_ROOM):
            raise InputError(f"the C compiler has no room for its files; {CAN_BE_MADE_AGAIN}", zig)
        if problem:
            raise CompilerError(f"the C compiler failed for {target.target}:\n{problem}")
        return Path(directory, output).read_bytes()


def _compiled(command: Sequence[str], folder: Path, cache: Path, target: Platform) -> str:
    """Runs the C compiler: what it complains of, if it failed."""
    from pam_cosim.compiler.budget import LIMITS  # loads the compiler of Modelica

    environment = os.environ | {
        "ZIG_GLOBAL_CACHE_DIR": str(cache),
        "ZIG_LOCAL_CACHE_DIR": str(cache),
    }
    try:
        run = run_tool(command, folder, environment, LIMITS.c_seconds)
    except subprocess.TimeoutExpired:
        raise CompilerError(
            f"the C compiler took more than {LIMITS.c_seconds:g} s for {target.target}"
        ) from None
    return "" if run.returncode == 0 else run.stderr.strip() or f"exit status {run.returncode}"


def _arguments(target: Platform, output: str, sources: Sequence[str]) -> list[str]:
    """Words of the command that makes a shared library."""
    common = ["-target", target.target, f"-I{fmu_runtime()}", f"-I{_fmi_headers()}"]
    if target.target.split("-")[1] == "linux":
        names = ["--name", Path(output).stem, f"-fsoname={output}", f"-femit-bin={output}"]
        options = [*names, "-cflags", *_FLAGS, "--"]
        return [*_OWN_ARITHMETIC, *common, *options, *sources]
    pic = [] if target.suffix == ".dll" else ["-fPIC", "-lm"]
    return ["cc", "-shared", "-s", *_FLAGS, *pic, *common, "-o", output, *sources]


def _clear_stale(folder: Path) -> None:
    """Removes what compilers that were ended have left; those at work are younger."""
    for path in folder.glob("*"):
        with suppress(OSError):
            if time.time() - path.stat().st_mtime > _STALE:
                shutil.rmtree(path, ignore_errors=True)
                path.unlink(missing_ok=True)


_FAT_MAGIC = 0xCAFEBABE
_FAT_ALIGNMENT = 14  # power of two: the page size of Apple's arm64


def universal_binary(thin: Sequence[bytes]) -> bytes:
    """One Mach-O file for several architectures (``mach-o/fat.h``: big-endian header, aligned slices)."""
    header = struct.pack(">II", _FAT_MAGIC, len(thin))
    size = 1 << _FAT_ALIGNMENT
    body = b""
    for data in thin:
        kind, subkind = struct.unpack_from("<II", data, 4)
        offset = size + len(body)
        header += struct.pack(">IIIII", kind, subkind, offset, len(data), _FAT_ALIGNMENT)
        body += data + b"\0" * (-len(data) % size)
    return header + b"\0" * (size - len(header)) + body
