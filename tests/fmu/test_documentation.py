"""What an FMU says of itself to people and their tools: attributes, the page, pictures, terminals, units."""

from __future__ import annotations

import zipfile
from pathlib import Path

import fmpy
import pytest
from fmpy.validation import validate_fmu
from lxml import etree
from lxml import html as trees

import pam_cosim as pam

_SCHEMA = Path(fmpy.__file__).parent / "schema" / "fmi3" / "fmi3TerminalsAndIcons.xsd"
_PNG = b"\x89PNG"


@pytest.mark.parametrize("fmi", ["2.0", pytest.param("3.0", marks=pytest.mark.full)])
def test_a_built_fmu_states_its_author_and_model(fmi: str) -> None:
    path = pam.build("CoSimulation.ValveAndGas", fmi=fmi)
    assert validate_fmu(str(path)) == []
    with zipfile.ZipFile(path) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    root = etree.fromstring(files["modelDescription.xml"])
    assert all(root.get(key) for key in ("author", "version", "license", "copyright"))
    assert str(root.get("generationDateAndTime")).endswith("Z")
    page = trees.fromstring(files["documentation/index.html"])
    text = page.text_content()
    for part in (
        "PneumaticMuscle.CoSimulation.ValveAndGas",
        "Polytropic exponent",
        "may change in a run",
        "Doumit",
    ):
        assert part in text, part
    assert not page.xpath("//a[starts-with(@href, 'modelica')]") and not page.xpath("//script")
    assert files["documentation/diagram.png"][:4] == _PNG
    displays = {one.get("name") for one in root.iter("DisplayUnit")}
    assert {"kPa", "degC", "mm2", "l", "g/s"} <= displays
    categories = {one.get("name") for one in root.iter("Category")}
    assert {"logEvents", "logStatusWarning", "logStatusError", "logAll"} <= categories
    if fmi == "2.0":
        assert files["model.png"][:4] == _PNG
        return
    assert files["terminalsAndIcons/icon.png"][:4] == _PNG
    terminals = etree.fromstring(files["terminalsAndIcons/terminalsAndIcons.xml"])
    etree.XMLSchema(file=str(_SCHEMA)).assertValid(terminals)
    members = [one.get("memberName") for one in terminals.iter("TerminalMemberVariable")]
    assert members == ["p", "V", "V_flow", "A"]


@pytest.mark.full
def test_the_two_halves_fit_plug_to_plug() -> None:
    plugs = []
    for half in ("ValveAndGas", "MuscleAndLoad"):
        with zipfile.ZipFile(pam.build(f"CoSimulation.{half}", fmi="3.0")) as archive:
            terminals = etree.fromstring(archive.read("terminalsAndIcons/terminalsAndIcons.xml"))
            model = etree.fromstring(archive.read("modelDescription.xml"))
        kinds = {one.get("name"): one.get("causality") for one in model.iter("Float64")}
        members = terminals.iter("TerminalMemberVariable")
        plugs.append(
            {one.get("memberName"): kinds[str(one.get("variableName"))] for one in members}
        )
    assert plugs[0].keys() == plugs[1].keys()
    assert all({plugs[0][name], plugs[1][name]} == {"input", "output"} for name in plugs[0])


def test_what_a_user_writes_in_a_documentation_does_not_run(tmp_path: Path) -> None:
    info = '<p onclick=\\"x()\\">The page</p><script>alert(1)</script>'
    file = tmp_path / "Own.mo"
    file.write_text(
        f'model Own "Mine"\nReal x(start=1, fixed=true);\noutput Real y = x;\nequation\nder(x) = -x;\n'
        f'annotation(Documentation(info="<html>{info}</html>"));\nend Own;\n'
    )
    with zipfile.ZipFile(pam.build(str(file))) as archive:
        page = archive.read("documentation/index.html").decode()
        root = etree.fromstring(archive.read("modelDescription.xml"))
    assert "The page" in page and "alert" not in page and "onclick" not in page
    assert root.get("author") is None
