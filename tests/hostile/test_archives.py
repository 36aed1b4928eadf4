"""Archives of others: documents that would take all memory, contents that are damaged."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from pam_cosim.fmu.read import MOST_OF_DOCUMENT, read_interface

LARGE = b"<x>" + b" " * MOST_OF_DOCUMENT
SAID = "20 MB; 20 MB can be taken"
DEFLATED, LZMA = zipfile.ZIP_DEFLATED, zipfile.ZIP_LZMA


def archive(file: Path, entries: dict[str, bytes], compression: int = DEFLATED) -> Path:
    with zipfile.ZipFile(file, "w", compression) as content:
        for name, data in entries.items():
            content.writestr(name, data)
    return file


def damaged(file: Path, name: str) -> Path:
    """Nothing of an entry's content is as it was; all about it is."""
    with zipfile.ZipFile(file) as content:
        entry = content.getinfo(name)
    begin = entry.header_offset + 30 + len(name.encode())  # after the entry's own header
    data = bytearray(file.read_bytes())
    keep = 9 if entry.compress_type == LZMA else 0  # its properties
    size = entry.compress_size - keep
    data[begin + keep : begin + keep + size] = b"\xff" * size
    file.write_bytes(bytes(data))
    return file


def test_description_of_an_fmu(tmp_path: Path) -> None:
    file = archive(tmp_path / "large.fmu", {"modelDescription.xml": LARGE})
    with pytest.raises(InputError, match=f"'modelDescription.xml' in it has {SAID}") as caught:
        read_interface(file)
    assert caught.value.file == file


def test_description_of_an_fmu_that_is_a_folder(tmp_path: Path) -> None:
    file = tmp_path / "modelDescription.xml"
    file.write_bytes(LARGE)
    with pytest.raises(InputError, match=SAID) as caught:
        read_interface(tmp_path)
    assert caught.value.file == file


def test_description_of_a_system(tmp_path: Path) -> None:
    file = archive(tmp_path / "large.ssp", {"SystemStructure.ssd": LARGE})
    with pytest.raises(InputError, match=f"'SystemStructure.ssd' in it has {SAID}") as caught:
        pam.read_system(file)
    assert caught.value.file == file


@pytest.mark.parametrize("compression", [DEFLATED, LZMA])
def test_damaged_system(tmp_path: Path, compression: int) -> None:
    name = "SystemStructure.ssd"
    file = archive(tmp_path / "damaged.ssp", {name: b"<description/>" * 50}, compression)
    with pytest.raises(InputError, match="is not an SSP archive"):
        pam.read_system(damaged(file, name))
