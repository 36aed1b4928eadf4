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
def test_an_invalid_fmu_name_is_refused(
    command: Command, place: Path, content: bytes | str
) -> None:
    source = place / "x.fmu"
    if content == "a bomb":
        with zipfile.ZipFile(source, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("modelDescription.xml", b" " * 30_000_000)
    elif content == "an FMU cut off":
        assert command("build TankFilling -o x.fmu").status == 0
        source.write_bytes(source.read_bytes()[:-100])
    else:
        assert isinstance(content, bytes)
        source.write_bytes(content)
    refused(command("build x.fmu -o made/y.fmu"), ["x.fmu"])
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


VALUES: dict[str, tuple[str, list[str]]] = {
    "beyond the range": ('{"orifice.C_d": 1e300}', ["orifice.C_d=1e+300", "must be"]),
    "of no parameter": ('{"tank.W": 1}', ["tank.W"]),
    "twice": ('{"tank.n": 1.1, "tank.n": 1.2}', ["the key 'tank.n' appears twice"]),
    "none": ("{}", ["must hold an object with parameter names"]),
    "in another unit": (
        '{"parameters": {"tank.V": {"value": 16.2, "unit": "l"}}}',
        ["tank.V is stated in 'l'", "'m3'"],
    ),
}


@pytest.mark.parametrize("name", VALUES)
@pytest.mark.parametrize("words", [["compare", "data", "--params"], ["add", "--from"]], ids=str)
def test_values_in_a_file(command: Command, data: Path, words: list[str], name: str) -> None:
    text, said = VALUES[name]
    Path("p.json").write_text(text)
    more = ["--to", "VesselOrifice", "-o", "Made.mo"] if words[0] == "add" else []
    refused(command(*words, "p.json", *more), ["p.json", *said])
    assert sorted(p.name for p in data.parent.iterdir()) == ["data", "p.json"]
