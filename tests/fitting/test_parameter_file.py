"""Fitted parameters go through a file without loss, and a bad file is one clear message."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest
from fmpy.ssp.ssd import read_ssv

from pam_cosim.errors import InputError
from pam_cosim.fitting import Estimate, Fit, read_parameters, write_parameters

VALUES = {
    "orifice.C_d": 0.1 + 0.2,
    "tank.gas.h": 7.874133972542709,
    "leak.G": 1.2345678901234567e-12,
}
FOUND = Fit(
    "Test.Vessel",
    {
        n: Estimate(v, v / 2, v * 2, "W/(m2.K)" if n == "tank.gas.h" else "1")
        for n, v in VALUES.items()
    },
    SimpleNamespace(),  # type: ignore[arg-type]
    {},
    1,
)


@pytest.mark.parametrize("name", ["found.json", "found.ssv", "FOUND.SSV", "found"])
def test_round_trip_to_the_last_bit(tmp_path: Path, name: str) -> None:
    write_parameters(tmp_path / name, FOUND)
    assert read_parameters(tmp_path / name) == VALUES
    assert [p.name for p in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize("name", ["better.mo", "p.CSV", "p.npz"])
def test_a_name_of_something_else_is_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError, match="'pam-cosim add --from' writes a model"):
        write_parameters(tmp_path / name, FOUND)
    assert not list(tmp_path.iterdir())


def test_json_carries_intervals_and_units(tmp_path: Path) -> None:
    write_parameters(tmp_path / "p.json", FOUND)
    content = json.loads((tmp_path / "p.json").read_text())
    assert content["model"] == "Test.Vessel"
    entry = content["parameters"]["tank.gas.h"]
    assert entry["low"] == VALUES["tank.gas.h"] / 2 and entry["unit"] == "W/(m2.K)"


def test_ssv_is_valid_and_read_by_another_tool(tmp_path: Path) -> None:
    """FMPy validates against the schemas of SSP 1.0; every unit that is used is defined."""
    write_parameters(tmp_path / "p.ssv", FOUND)
    read = read_ssv(str(tmp_path / "p.ssv"))
    assert {p.name: float(p.value) for p in read.parameters} == VALUES
    root = ElementTree.parse(tmp_path / "p.ssv").getroot()
    space = "{http://ssp-standard.org/SSP1/SystemStructureCommon}"
    units = {u.attrib["name"]: u[0].attrib for u in root.iter(f"{space}Unit")}
    assert units == {"1": {}, "W/(m2.K)": {"kg": "1", "s": "-3", "K": "-1"}}


SSV = '<P xmlns:s="http://ssp-standard.org/SSP1/SystemStructureParameterValues">{}</P>'
BAD = [
    ("p.json", "", "not JSON", 1),
    ("p.json", '{"a": 1,\n "b" 2}', "not JSON", 2),
    ("p.json", "[1, 2]", "must hold an object", None),
    ("p.json", '{"parameters": [1]}', "must hold an object", None),
    ("p.json", '{"a": "5 kg"}', "parameter 'a' has no number", None),
    ("p.json", '{"a": NaN}', "parameter 'a' is not a finite number", None),
    ("p.json", '{"a": 1' + "0" * 400 + "}", "parameter 'a' is not a finite number", None),
    ("p.json", "[" * 100_000, "not JSON", None),
    ("p.ssv", "", "is not an SSV file", None),
    (
        "p.ssv",
        SSV.format('<s:Parameter name="a"><s:Real value="x"/></s:Parameter>'),
        "is not an SSV file",
        None,
    ),
    (
        "p.ssv",
        SSV.format('<s:Parameter><s:Real value="1"/></s:Parameter>'),
        "is not an SSV file",
        None,
    ),
    (
        "p.ssv",
        SSV.format('<s:Parameter name="a"><s:Real value="nan"/></s:Parameter>'),
        "not a finite number",
        None,
    ),
]


@pytest.mark.parametrize(
    ("name", "text", "words", "line"), BAD, ids=[f"{c[0]}-{c[2]}-{i}" for i, c in enumerate(BAD)]
)
def test_bad_file_is_one_clear_message(
    tmp_path: Path, name: str, text: str, words: str, line: int | None
) -> None:
    file = tmp_path / name
    file.write_text(text)
    with pytest.raises(InputError) as caught:
        read_parameters(file)
    assert words in caught.value.message
    assert (caught.value.file, caught.value.line) == (file, line)
