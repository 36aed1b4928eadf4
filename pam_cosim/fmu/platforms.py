"""The platforms that FMUs are built for, and the places of their binaries in an archive."""

from __future__ import annotations

import platform
import sys
from collections.abc import Sequence
from typing import NamedTuple

from pam_cosim.errors import InputError


class Platform(NamedTuple):
    """A platform that FMUs are built for.

    Attributes:
        target: the compiler's name of it; a glibc version makes the binary run on old systems too.
        folder: directory of the binary inside an FMI 2.0 archive.
        tuple: the same inside an FMI 3.0 archive.
        suffix: of a shared library.
    """

    target: str
    folder: str
    tuple: str
    suffix: str


PLATFORMS: dict[str, Platform] = {
    "x86_64-linux": Platform("x86_64-linux-gnu.2.17", "linux64", "x86_64-linux", ".so"),
    "aarch64-linux": Platform("aarch64-linux-gnu.2.17", "aarch64-linux", "aarch64-linux", ".so"),
    "x86_64-windows": Platform("x86_64-windows-gnu", "win64", "x86_64-windows", ".dll"),
    "x86_64-macos": Platform("x86_64-macos", "darwin64", "x86_64-darwin", ".dylib"),
    "aarch64-macos": Platform("aarch64-macos", "darwin64", "aarch64-darwin", ".dylib"),
}


def native_platform() -> str:
    """Name in ``PLATFORMS`` of the machine this runs on.

    Raises:
        InputError: FMUs cannot be built for it.
    """
    machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(
        platform.machine().lower(), platform.machine().lower()
    )
    system = {"win32": "windows", "darwin": "macos"}.get(sys.platform, sys.platform)
    name = f"{machine}-{system}"
    if name not in PLATFORMS:
        raise InputError(f"FMUs cannot be built on {name}; supported are {', '.join(PLATFORMS)}")
    return name


def binary_folder(name: str, names: Sequence[str], fmi: str = "2.0") -> str:
    """Directory of a platform's binary in an archive for ``names``.

    FMI 2.0 knows one 64-bit Linux, and tools on an ARM machine look there too: ARM alone takes that place.
    """
    if fmi == "3.0":
        return PLATFORMS[name].tuple
    return (
        "linux64"
        if name == "aarch64-linux" and "x86_64-linux" not in names
        else PLATFORMS[name].folder
    )
