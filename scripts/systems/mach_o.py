"""What a Mach-O library of macOS asks for and gives: load commands and symbols (``mach-o/loader.h``, ``nlist.h``)."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from enum import IntEnum

_FAT, _THIN = 0xCAFEBABE, 0xFEEDFACF
_KINDS = {0x01000007: "x86_64", 0x0100000C: "arm64"}
_DYNAMIC_LIBRARY = 6
_EXTERNAL, _TYPE, _UNDEFINED, _DEBUG = 0x01, 0x0E, 0x0, 0xE0


class _Command(IntEnum):
    """Load commands, without the bit that says that a loader must know them."""

    SYMBOLS, NEEDED, SIGNATURE, OLDEST, BUILD = 0x2, 0xC, 0x1D, 0x24, 0x32


@dataclass(frozen=True)
class Image:
    """One architecture's part of a library.

    Attributes:
        is_library: it is a dynamic library.
        libraries: paths of those that it needs.
        exported: symbols that it gives.
        imported: symbols that it takes, and the library of each; empty: of none that it names.
        oldest_system: lowest version of macOS that loads it.
        signed: it carries a signature.
    """

    is_library: bool
    libraries: tuple[str, ...]
    exported: frozenset[str]
    imported: dict[str, str]
    oldest_system: tuple[int, int] | None
    signed: bool


def read_mach_o(content: bytes) -> dict[str, Image]:
    """The images in a file by architecture.

    Raises:
        ValueError: it is no 64-bit Mach-O file.
    """
    if struct.unpack_from(">I", content)[0] != _FAT:
        return dict([_read(content)])
    count = struct.unpack_from(">I", content, 4)[0]
    parts = (struct.unpack_from(">5I", content, 8 + 20 * k) for k in range(count))
    return dict(_read(content[offset : offset + size]) for _, _, offset, size, _ in parts)


def _read(part: bytes) -> tuple[str, Image]:
    magic, kind, _, filetype, count, _, _, _ = struct.unpack_from("<8I", part)
    if magic != _THIN:
        raise ValueError("no 64-bit Mach-O file")
    place, libraries, oldest, signed = 32, [], None, False
    symbols = (0, 0, 0, 0)
    for _ in range(count):
        command, size = struct.unpack_from("<2I", part, place)
        match command & 0x7FFFFFFF:
            case _Command.NEEDED:
                start = place + struct.unpack_from("<I", part, place + 8)[0]
                libraries.append(part[start : place + size].split(b"\0")[0].decode())
            case _Command.SYMBOLS:
                symbols = struct.unpack_from("<4I", part, place + 8)
            case _Command.SIGNATURE:
                signed = True
            case _Command.OLDEST:
                oldest = _version(part, place + 8)
            case _Command.BUILD:
                oldest = _version(part, place + 12)
        place += size
    exported, imported = _symbols(part, symbols, libraries)
    image = Image(
        filetype == _DYNAMIC_LIBRARY, tuple(libraries), exported, imported, oldest, signed
    )
    return _KINDS.get(kind, hex(kind)), image


def _version(part: bytes, place: int) -> tuple[int, int]:
    (number,) = struct.unpack_from("<I", part, place)
    return number >> 16, number >> 8 & 0xFF


def _symbols(
    part: bytes, table: tuple[int, int, int, int], libraries: list[str]
) -> tuple[frozenset[str], dict[str, str]]:
    """Exported symbols, and imported ones with their libraries (two-level namespace)."""
    first, count, names, _ = table
    exported, imported = set(), {}
    for k in range(count):
        at, kind, _, flags, _ = struct.unpack_from("<IBBHQ", part, first + 16 * k)
        name = part[names + at : part.index(b"\0", names + at)].decode()
        if kind & _DEBUG or not kind & _EXTERNAL:
            continue
        if kind & _TYPE == _UNDEFINED:
            number = flags >> 8
            imported[name] = libraries[number - 1] if 1 <= number <= len(libraries) else ""
        else:
            exported.add(name)
    return frozenset(exported), imported
