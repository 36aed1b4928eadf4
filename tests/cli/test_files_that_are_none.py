"""What is no package, no FMU, or of something else than the command asks for: one line, and nothing written."""

from __future__ import annotations

import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome
from tests.cli.test_bad_input import refused

Command = Callable[..., Outcome]


@pytest.mark.parametrize("content", [b"", b"{}", "a bomb", "an FMU cut off"], ids=str)
def test_what_is_no_fmu_is_not_built(command: Command, place: Path, content: bytes | str) -> None:
    source = place / "x.fmu"
    if content == "a bomb":
        with zipfile.ZipFile(source, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("modelDescription.xml", b" " * 30_000_000)
    elif content == "an FMU cut off":
        assert command("build", "TankFilling", "-o", "x.fmu").status == 0
        source.write_bytes(source.read_bytes()[:-100])
    else:
        assert isinstance(content, bytes)
        source.write_bytes(content)
    refused(command("build", "x.fmu", "-o", "made/y.fmu"), ["x.fmu"])
    assert [p.name for p in place.iterdir()] == ["x.fmu"]


@pytest.mark.parametrize(
    "words",
    [
        ["describe", "TankFilling"],
        ["simulate", "TankFilling"],
        ["compare", "data"],
        ["effects"],
    ],
    ids=lambda words: words[0],
)
def test_a_folder_that_is_no_package(command: Command, data: Path, words: list[str]) -> None:
    (data.parent / "folder").mkdir()
    refused(command(*words, "--file", "folder"), ["folder", "has no package.mo"])
