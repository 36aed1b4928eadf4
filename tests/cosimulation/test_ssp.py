"""Systems as files: SSP 1.0 and 2.0 out and in, also against FMPy's reading; TOML; what a file holds is data."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest
from fmpy.ssp.simulation import simulate_ssp
from fmpy.ssp.ssd import read_ssd, validate_tree
from lxml import etree

import pam_cosim as pam
from pam_cosim.cosimulation import System, ssp_read
from pam_cosim.errors import InputError
from tests.cosimulation.systems import CUT, written
from tests.fmu import models
from tests.tiers import quick

LAG = 'parameter Real tau(unit="s") = 0.5 "tau";\ninput Real u(unit="{0}") "u";\n'
LAG += 'output Real y(unit="{1}", start=0, fixed=true) "y";\nequation\ntau*der(y) = {2}*u - y;'
HEAD = (
    '<ssd:SystemStructureDescription xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription" '
    'xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon" '
    'xmlns:ssv="http://ssp-standard.org/SSP1/SystemStructureParameterValues" version="1.0" name="by hand">'
)
CONNECTORS = (
    '<ssd:Connectors><ssd:Connector name="u" kind="input"><ssc:Real/></ssd:Connector>'
    '<ssd:Connector name="y" kind="output"><ssc:Real/></ssd:Connector></ssd:Connectors>'
)

WIRE = '<ssd:Connection startElement="a" startConnector="y" endElement="a" endConnector="u"/>'


def chain(folder: Path) -> System:
    """Two lags in a row, in different units, with values of their own."""
    parts = {
        "first": written(folder, "First", LAG.format("V", "mm", 1)),
        "second": written(folder, "Second", LAG.format("m", "1", 1)),
    }
    return pam.couple(
        parts, ["first.y -> second.u"], {"first.u": 3.0, "second.tau": "200 ms"}, title="a chain"
    )


def archive(file: Path, description: str, entries: dict[str, bytes] | None = None) -> Path:
    """An SSP archive by hand, with the lag as its FMU."""
    with zipfile.ZipFile(file, "w") as content:
        content.writestr("SystemStructure.ssd", description)
        content.writestr("resources/lag.fmu", models.fmu(models.lag).read_bytes())
        for name, data in (entries or {}).items():
            content.writestr(name, data)
    return file


def component(name: str, source: str = "resources/lag.fmu", inside: str = CONNECTORS) -> str:
    return f'<ssd:Component name="{name}" source="{source}">{inside}</ssd:Component>'


def system(elements: str, connections: str = "", before: str = "") -> str:
    wires = f"<ssd:Connections>{connections}</ssd:Connections>" if connections else ""
    inside = f"{before}<ssd:Elements>{elements}</ssd:Elements>{wires}"
    return f'{HEAD}<ssd:System name="top">{inside}</ssd:System></ssd:SystemStructureDescription>'


@pytest.mark.parametrize("version", quick(["1.0", "2.0"], "2.0"))
def test_written_and_read_again_runs_alike(version: str, tmp_path: Path) -> None:
    made = chain(tmp_path)
    again = pam.read_system(pam.write_system(made, tmp_path / "chain.ssp", ssp=version))
    assert again.title == "a chain" and [str(c) for c in again.connections] == [
        "first.y -> second.u"
    ]
    assert again.values == {"first": {"u": 3.0}, "second": {"tau": 0.2}}
    here, there = (one.simulate(1, step=0.05).trajectory for one in (made, again))
    assert here["second.y"].tolist() == there["second.y"].tolist() and here["second.y"][-1] > 0.001
    assert (tmp_path / "chain.ssp").read_bytes() == pam.write_system(
        again, tmp_path / "twice.ssp", ssp=version
    ).read_bytes()


def test_a_written_system_says_what_others_need(tmp_path: Path) -> None:
    """Identifiers, connectors that drive and show the system, bound values, an experiment, drawings, readable files."""
    lag = str(models.fmu(models.lag))
    made = pam.couple(
        {"a": lag, "b": lag}, ["a.y -> b.u"], {"a.u": 2.0, "b.tau": 0.2}, title="two lags, in a row"
    )
    file = pam.write_system(made, tmp_path / "lags.ssp")
    read = read_ssd(str(file), validate=True)
    assert read.system.name == "two_lags_in_a_row"
    assert [(c.kind, c.name) for c in read.system.connectors] == [
        ("input", "u"), ("output", "a_y"), ("output", "a_feed"), ("output", "b_y"), ("output", "b_feed"),
    ]  # fmt: skip
    with zipfile.ZipFile(file) as content:
        assert {entry.external_attr >> 16 for entry in content.infolist()} == {0o644}
        root = etree.fromstring(content.read("SystemStructure.ssd"))
        bound = etree.fromstring(content.read("SystemStructure.ssv"))
    names = {etree.QName(one).localname for one in root.iter()}
    assert {"SystemGeometry", "ElementGeometry", "ConnectorGeometry", "DefaultExperiment"} <= names
    assert root.get("description") == "two lags, in a row"
    assert [
        (one.get("name"), one[0].get("value")) for one in bound.iter() if one.get("name") == "u"
    ] == [("u", "2.0")]
    driven = simulate_ssp(str(file), stop_time=1.0, step_size=0.01, input={"u": lambda t: 1.0})
    assert driven["b_y"][-1] > 0.5
    plain = pam.write_system(made, tmp_path / "plain.ssp", connectors=False)
    assert not read_ssd(str(plain)).system.connectors
    again = [pam.read_system(one).values for one in (file, plain)]
    assert again[0] == again[1] == {"a": {"u": 2.0}, "b": {"tau": 0.2}}


def later(description: str) -> str:
    """The same of SSP 2.0."""
    return description.replace('version="1.0"', 'version="2.0"').replace("ssc:Real", "ssc:Float64")


def test_version_2_is_valid_by_its_own_schema_and_not_by_the_first(tmp_path: Path) -> None:
    file = pam.write_system(chain(tmp_path), tmp_path / "chain.ssp", ssp="2.0")
    with zipfile.ZipFile(file) as content:
        description = etree.fromstring(content.read("SystemStructure.ssd"))
        values = etree.fromstring(content.read("resources/second.ssv"))
    assert description.get("version") == values.get("version") == "2.0"
    folder = Path(ssp_read.__file__).parent / "ssp_schema"
    for root, name in ((description, "Description"), (values, "ParameterValues")):
        etree.XMLSchema(file=str(folder / f"SystemStructure{name}.xsd")).assertValid(root)
        with pytest.raises(Exception, match="version"):
            validate_tree(root, f"SystemStructure{name}.xsd")
    assert {etree.QName(one).localname for one in values.iter() if one.get("value")} == {"Real"}
    with pytest.raises(InputError, match="no SSP 3.0"):
        pam.write_system(chain(tmp_path), tmp_path / "later.ssp", ssp="3.0")


@pytest.mark.parametrize(
    ("description", "message"),
    [
        (later(system(component("a"), before="<ssd:Nothing/>")), "not valid by SSP 2.0: .*Nothing"),
        (
            later(system(component("a"))).replace(
                "</ssd:Connector>", '<ssc:Dimension size="3"/></ssd:Connector>'
            ),
            "arrays",
        ),
        (
            later(system(component("a"))).replace('version="2.0"', 'version="3.0"'),
            "not valid by SSP 1.0",
        ),
    ],
)
def test_version_2_that_cannot_be_read(description: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=message):
        pam.read_system(archive(tmp_path / "bad.ssp", description))


def test_fmpy_reads_the_same_and_its_master_comes_to_the_same(tmp_path: Path) -> None:
    lag = str(models.fmu(models.lag))
    made = pam.couple({"a": lag, "b": lag}, ["a.y -> b.u"], {"a.x_start": 2.0})
    file = pam.write_system(made, tmp_path / "lags.ssp")
    read = read_ssd(str(file), validate=True)
    assert {c.name: c.source for c in read.system.elements} == {
        "a": "resources/a.fmu",
        "b": "resources/b.fmu",
    }
    wire = read.system.connections[0]
    assert (wire.startElement, wire.startConnector, wire.endElement, wire.endConnector) == (
        "a",
        "y",
        "b",
        "u",
    )
    connectors = {(c.name, k.name, k.kind) for c in read.system.elements for k in c.connectors}
    assert connectors == {
        (c, *k) for c in "ab" for k in (("u", "input"), ("y", "output"), ("feed", "output"))
    }
    bound = read.system.elements[0].parameterBindings[0].parameterValues[0].parameters
    assert [(p.name, p.type, p.value) for p in bound] == [("x_start", "Real", "2.0")]


def test_nested_systems_and_transformations(tmp_path: Path) -> None:
    inner = (
        '<ssd:System name="inner">'
        + CONNECTORS
        + f"<ssd:Elements>{component('lag')}</ssd:Elements><ssd:Connections>"
        '<ssd:Connection startConnector="u" endElement="lag" endConnector="u"><ssc:LinearTransformation factor="2"/>'
        '</ssd:Connection><ssd:Connection startElement="lag" startConnector="y" endConnector="y"/>'
        "</ssd:Connections></ssd:System>"
    )
    wires = (
        '<ssd:Connection startElement="first" startConnector="y" endElement="inner" endConnector="u">'
        '<ssc:LinearTransformation factor="3" offset="1"/></ssd:Connection>'
        '<ssd:Connection startElement="inner" startConnector="y" endElement="last" endConnector="u"/>'
    )
    file = archive(
        tmp_path / "n.ssp", system(component("first") + inner + component("last"), wires)
    )
    read = pam.read_system(file)
    assert {str(c): (c.factor, c.offset) for c in read.connections} == {
        "first.y -> inner_lag.u": (6.0, 2.0),
        "inner_lag.y -> last.u": (1.0, 0.0),
    }
    assert list(read.inputs) == ["first.u"]
    again = pam.read_system(pam.write_system(read, tmp_path / "again.ssp"))
    assert again.connections == read.connections


def test_parameter_values_of_systems_go_to_their_components(tmp_path: Path) -> None:
    def values(name: str, value: str) -> str:
        return (
            "<ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>"
            '<ssv:ParameterSet version="1.0" name="set"><ssv:Parameters>'
            f'<ssv:Parameter name="{name}"><ssv:Real value="{value}"/></ssv:Parameter>'
            "</ssv:Parameters></ssv:ParameterSet></ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>"
        )

    elements = component("a", inside=CONNECTORS + values("tau", "7")) + component("b")
    file = archive(tmp_path / "p.ssp", system(elements, before=values("a.x_start", "5")))
    assert pam.read_system(file, parameters={"b.u": 2.0}).values == {
        "a": {"tau": 7.0, "x_start": 5.0},
        "b": {"u": 2.0},
    }
    outer = archive(tmp_path / "o.ssp", system(elements, before=values("a.tau", "8")))
    assert pam.read_system(outer).values == {"a": {"tau": 8.0}}  # the outermost wins
    unknown = archive(tmp_path / "u.ssp", system(elements, before=values("c.tau", "8")))
    with pytest.raises(InputError, match="parameter 'c.tau' is of no component"):
        pam.read_system(unknown)


MAPPING = (
    '<ssm:ParameterMapping xmlns:ssm="http://ssp-standard.org/SSP1/SystemStructureParameterMapping" '
    'xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon" version="1.0">'
    '<ssm:MappingEntry source="rig.delay" target="a.tau"/><ssm:MappingEntry source="rig.delay" target="b.tau">'
    '<ssc:LinearTransformation factor="2" offset="1"/></ssm:MappingEntry></ssm:ParameterMapping>'
)


@pytest.mark.parametrize("inline", [True, False])
def test_parameter_mapping(tmp_path: Path, inline: bool) -> None:
    place = f">{MAPPING}</ssd:ParameterMapping>" if inline else ' source="resources/names.ssm"/>'
    values = (
        '<ssd:ParameterBindings><ssd:ParameterBinding prefix="rig."><ssd:ParameterValues>'
        '<ssv:ParameterSet version="1.0" name="set"><ssv:Parameters><ssv:Parameter name="delay"><ssv:Real value="3"/>'
        '</ssv:Parameter><ssv:Parameter name="other"><ssv:Real value="9"/></ssv:Parameter></ssv:Parameters>'
        f"</ssv:ParameterSet></ssd:ParameterValues><ssd:ParameterMapping{place}"
        "</ssd:ParameterBinding></ssd:ParameterBindings>"
    )
    description = system(component("a") + component("b"), before=values)
    file = archive(tmp_path / "m.ssp", description, {"resources/names.ssm": MAPPING.encode()})
    assert pam.read_system(file).values == {"a": {"tau": 3.0}, "b": {"tau": 7.0}}


BOMB = '<!DOCTYPE x [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]>'


@pytest.mark.parametrize(
    ("description", "message"),
    [
        (system(component("a", "../../outside.fmu")), "which is not in the archive"),
        (system(component("a", "/etc/hostname")), "which is not in the archive"),
        (system(component("a", "file:///etc/hostname")), "which is not in the archive"),
        (system(component("a", "resources/../../lag.fmu")), "which is not in the archive"),
        (system(component("a", "resources/none.fmu")), "which is not in the archive"),
        (system(component("a", "SystemStructure.ssd")), r"component 'a' \(SystemStructure.ssd\): this is not an FMU"),
        (system(component("a").replace("source=", 'type="application/x-ssp-package" source=')), "'a' is not an FMU"),
        (system(component("a") + component("a")), "two components 'a'|not valid"),
        (system(component("a"), WIRE.replace('endElement="a"', 'endElement="b"')),
         "names 'b', which is no component"),
        (system(component("a"), WIRE.replace('"y"', '"z"')),
         "no output 'z'"),
        (system(""), "not valid by SSP 1.0: .*Elements"),
        (system(component("a")).replace('version="1.0"', 'version="9"'), "not valid by SSP 1.0"),
        *((system(component("a")).replace("</ssd:System>", f'</ssd:System><ssd:DefaultExperiment stopTime="{end}"/>'),
           "no time after the start") for end in ("-5", "NaN", "INF")),
        ("<not xml", "is not XML"),
        (BOMB + system(component("a")).replace("by hand", "&b;"), "declares a document type"),
        ('<!DOCTYPE x SYSTEM "file:///etc/hostname">' + "<x/>", "declares a document type"),
    ],
)  # fmt: skip
def test_archive_that_cannot_be_read(tmp_path: Path, description: str, message: str) -> None:
    before = sorted(tmp_path.rglob("*"))
    file = archive(tmp_path / "bad.ssp", description)
    with pytest.raises(InputError, match=message) as caught:
        pam.read_system(file)
    assert caught.value.file == file
    assert sorted(tmp_path.rglob("*")) == [*before, file]


def test_python_controllers_are_not_written(tmp_path: Path) -> None:
    lift = pam.Controller(lambda time, x: 0.0, {"x": "m"}, {"u_in": "A"})
    parts = {
        "gas": "CoSimulation.ValveAndGas",
        "muscle": "CoSimulation.MuscleAndLoad",
        "lift": lift,
    }
    with pytest.raises(
        InputError, match="'lift' is a function in Python, which an SSP archive cannot hold"
    ):
        pam.write_system(pam.couple(parts, CUT), tmp_path / "x.ssp")
    assert not (tmp_path / "x.ssp").exists()


# --- TOML ----------------------------------------------------------------------------------------------------


def test_toml_names_files_of_its_folder(tmp_path: Path) -> None:
    chain(tmp_path)
    file = tmp_path / "system.toml"
    file.write_text(
        'title = "a chain"\nstop_time = "500 ms"\nconnections = ["first.y -> second.u"]\n'
        '[components]\nfirst = "First.mo"\nsecond = "Second.mo"\n[parameters]\n"first.u" = 3\n"second.tau" = "200 ms"\n'
    )
    read = pam.read_system(file)
    assert read.stop_time == 0.5 and read.values == {"first": {"u": 3.0}, "second": {"tau": 0.2}}
    assert read.simulate(step=0.05).trajectory.time[-1] == 0.5


ONE = "[components]\na = 'Isotonic'\n"


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("[components]\na = 'Isotonic'\n[conections]", 3, "unknown key 'conections'; did you mean 'connections'"),
        ("title = 'x'", None, "name the components under"),
        ("[components]\na = 5", 2, "component 'a' must name a model"),
        ("[components]\na = '../x.fmu'", 2, "must lie in the folder of this file"),
        ("[components]\na = '/tmp/x.fmu'", 2, "must lie in the folder of this file"),
        ("[components]\na = 'x.fmu'", 2, "there is no file 'x.fmu'"),
        ("[components]\na = 'Isotonik'", 2, "Isotonik"),
        ("[components]\nb = 'Isotonic'\n'a b' = 'Isotonic'", 3, "'a b' cannot name a component"),
        ("connections = 'a'\n[components]\na = 'Isotonic'", 1, "connections must be a list"),
        ("connections = ['a.x -> b.u']\n[components]\na = 'Isotonic'", 1, "no component 'b'"),
        (f"connections = [\n  'a.p -> a.p_supply',\n  \"a.p -> a.u_on\",\n]\n{ONE}", 3, "no input 'u_on'"),
        (f"connections = [\n'a.p -> a.p_supply',\n'a.T -> a.p_supply',\n]\n{ONE}", 3, "connection 'a.T -> a.p_supply'"),
        (f"connections = [\n'b.p -> a.p_supply',\n'a.p -> a.p_supply',\n]\n{ONE}b = 'Isotonic'", 3, "than one source"),
        (f"{ONE}[parameters]\n'a.load.m' = '3 kg'\n'a.load.mm' = '3 kg'", 5, "did you mean 'load.m'"),
        (f"{ONE}[parameters]\n'a.load.m' = '3 s'", 4, "load.m"),
        (f"connections = ['a.p -> a.p_supply']\n{ONE}[parameters]\n'a.p_supply' = '3 bar'", 5, "more than one source"),
        (f"{ONE}[samples]\nb = '10 ms'", 4, "there is no FMU 'b'"),
        (f"{ONE}b = 'Isotonic'\n[samples]\na = '10 kg'", 5, "the interval of a controller"),
        ("stop_time = '5 kg'\n[components]\na = 'Isotonic'", 1, "stop_time"),
        ("stop_time = true\n[components]\na = 'Isotonic'", 1, "stop_time: True is no time"),
        ("[components\na = 'Isotonic'", 1, "not valid TOML"),
    ],
)  # fmt: skip
def test_toml_that_cannot_be_read(
    tmp_path: Path, text: str, line: int | None, message: str
) -> None:
    file = tmp_path / "system.toml"
    file.write_text(text)
    with pytest.raises(InputError, match=message) as caught:
        pam.read_system(file)
    if line is not None:
        assert (caught.value.file, caught.value.line) == (file, line)
