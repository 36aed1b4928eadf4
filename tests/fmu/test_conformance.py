"""Both versions of FMI in others' tools: schemas, FMPy, CasADi, SSP, a container, compilation from sources."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path
from xml.etree import ElementTree as Xml

import casadi as ca
import fmpy
import numpy as np
import pytest
from attrs import evolve
from fmpy.container_fmu.cli import create_container_fmu
from fmpy.container_fmu.config import Component, Configuration, Connection
from fmpy.model_description import (
    CoSimulation,
    DefaultExperiment,
    ModelDescription,
    ModelVariable,
    Unknown,
)
from fmpy.ssp.simulation import simulate_ssp
from fmpy.validation import validate_fmu
from lxml import etree

from pam_cosim.cache import cache_dir
from pam_cosim.compiler import compile_model
from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu import build_fmu, build_model
from pam_cosim.fmu.platforms import PLATFORMS, native_platform
from pam_cosim.resources import modelica_root
from pam_cosim.simulation import Inputs, Simulator
from pam_cosim.study import add
from tests.fmu import models

VERSIONS = ["2.0", "3.0"]
_SCHEMAS = Path(fmpy.__file__).parent / "schema"


def _schema(fmi: str, name: str) -> etree.XMLSchema:
    return etree.XMLSchema(file=str(_SCHEMAS / f"fmi{fmi[0]}" / f"fmi{fmi[0]}{name}.xsd"))


def _read(path: Path, name: str) -> etree._ElementTree:
    with zipfile.ZipFile(path) as archive:
        return etree.ElementTree(etree.fromstring(archive.read(name)))


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize(
    "make", [models.van_der_pol, models.lag, models.algebraic, models.oscillator, models.delayed_mix],
    ids=lambda make: make.__name__,
)  # fmt: skip
def test_small_models_are_valid(make, fmi: str) -> None:  # type: ignore[no-untyped-def]
    path = models.fmu(make, fmi)
    assert validate_fmu(str(path)) == []
    if fmi == "3.0":
        _schema(fmi, "BuildDescription").assertValid(_read(path, "sources/buildDescription.xml"))


def test_both_versions_give_the_same_numbers() -> None:
    inputs = Inputs(
        np.array([0.0, 0.4, 0.4, 1.0]), {"u": [0.0, 1.0, 2.0, 0.5], "v": [1.0, 1.0, -1.0, 0.0]}
    )
    times = np.linspace(0.0, 1.0, 21)
    runs = []
    for fmi in VERSIONS:
        with Simulator(models.fmu(models.delayed_mix, fmi)) as simulator:
            simulator.run(times, inputs=inputs, parameters={"T": 0.1})
            runs.append(simulator.run(times, inputs=inputs).values)
    assert all(runs[0][name].tolist() == runs[1][name].tolist() for name in runs[0])


@pytest.mark.parametrize("fmi", VERSIONS)
def test_effects_and_library_version_are_annotated(fmi: str, tmp_path: Path) -> None:
    bench = "PneumaticMuscle.Benches.Isotonic"
    plain = _read(build_model(bench, fmi=fmi), "modelDescription.xml")
    version = (
        (modelica_root() / "PneumaticMuscle" / "package.mo")
        .read_text()
        .split('version="')[1]
        .split('"')[0]
    )
    assert [dict(e.attrib) for e in plain.iter("Library")] == [
        {"name": "PneumaticMuscle", "version": version}
    ]
    assert list(plain.iter("Effect")) == []
    add(["LinearBladder", "EnergyGas"], bench, tmp_path / "Extended.mo")
    tree = _read(build_model(str(tmp_path / "Extended.mo"), fmi=fmi), "modelDescription.xml")
    holder = "VendorAnnotations/Tool" if fmi == "2.0" else "Annotations/Annotation"
    annotation = tree.find(holder)
    assert (
        annotation is not None and annotation.get("name" if fmi == "2.0" else "type") == "pam-cosim"
    )
    annotated = {e.attrib["name"] for e in annotation.iter("Effect")}
    assert annotated == {
        "PneumaticMuscle.Effects.Elasticity.LinearBladder",
        "PneumaticMuscle.Effects.GasEnergy.EnergyGas",
    }
    _schema(fmi, "ModelDescription").assertValid(tree)


LINUX = ["x86_64-linux", "aarch64-linux"]


@pytest.mark.parametrize(
    ("fmi", "platforms", "folders"),
    [
        ("2.0", LINUX, {"linux64", "aarch64-linux"}),
        ("3.0", LINUX, {"x86_64-linux", "aarch64-linux"}),
        # for Windows the C compiler first makes libraries of its own, once a machine: most of a minute
        pytest.param(
            "2.0",
            ["all"],
            {"linux64", "aarch64-linux", "win64", "darwin64"},
            marks=pytest.mark.full,
        ),
        pytest.param(
            "3.0",
            ["all"],
            {"x86_64-linux", "aarch64-linux", "x86_64-windows", "x86_64-darwin", "aarch64-darwin"},
            marks=pytest.mark.full,
        ),
    ],
)
def test_same_model_same_bytes_and_platform_folders(
    fmi: str, platforms: list[str], folders: set[str], tmp_path: Path
) -> None:
    first = build_fmu(models.lag(), tmp_path / "a.fmu", platforms=platforms, fmi=fmi)
    again = build_fmu(models.lag(), tmp_path / "b.fmu", platforms=platforms, fmi=fmi)
    assert first.read_bytes() == again.read_bytes()
    with zipfile.ZipFile(first) as archive:
        names = archive.namelist()
    assert {name.split("/")[1] for name in names if name.startswith("binaries/")} == folders


def _listed_sources(folder: Path, fmi: str) -> list[str]:
    """The C files that the FMU itself says are to be compiled."""
    if fmi == "3.0":
        tree = Xml.parse(folder / "sources" / "buildDescription.xml")
        return [element.attrib["name"] for element in tree.iter("SourceFile")]
    tree = Xml.parse(folder / "modelDescription.xml")
    return [element.attrib["name"] for element in tree.findall("CoSimulation/SourceFiles/File")]


@pytest.mark.full
@pytest.mark.parametrize("fmi", VERSIONS)
def test_rebuilt_from_its_own_sources_it_gives_the_same_numbers(fmi: str, tmp_path: Path) -> None:
    path = models.fmu(models.van_der_pol, fmi)
    folder = Path(fmpy.extract(str(path), unzipdir=str(tmp_path / "fmu")))
    binary = next(folder.glob("binaries/*/*"))
    original = binary.read_bytes()
    binary.unlink()
    target = PLATFORMS[native_platform()].target
    shared = ["-shared", "-fPIC"] if not binary.name.endswith(".dll") else ["-shared"]
    command = [sys.executable, "-m", "ziglang", "cc", "-target", target, "-O2", *shared,
               f"-DFMI{fmi[0]}_OVERRIDE_FUNCTION_PREFIX", "-I.", "-o", str(binary),
               *_listed_sources(folder, fmi), "-lm"]  # fmt: skip
    zig = str(cache_dir() / "zig")
    environment = os.environ | {"ZIG_GLOBAL_CACHE_DIR": zig, "ZIG_LOCAL_CACHE_DIR": zig}
    subprocess.run(command, cwd=folder / "sources", check=True, env=environment)
    assert binary.read_bytes() != original
    for kind in ("CoSimulation", "ModelExchange"):
        ours = fmpy.simulate_fmu(str(path), fmi_type=kind, relative_tolerance=1e-6)
        theirs = fmpy.simulate_fmu(str(folder), fmi_type=kind, relative_tolerance=1e-6)
        assert ours["y"] == pytest.approx(theirs["y"], rel=1e-9)


def _exact(ode: Ode, point: tuple[ca.DM, ca.DM]) -> np.ndarray:
    """Jacobian of derivatives and outputs with respect to states and inputs, from the equations themselves."""
    defaults = [p.start for p in ode.interface.parameters.values()]
    matrix = ca.jacobian(ca.vertcat(ode.derivatives, ode.outputs), ca.vertcat(ode.x, ode.u))
    function = ca.Function("f", [ode.x, ode.u, ode.p, ode.t], [matrix])
    return np.array(function(*point, defaults, 0.0))


@pytest.mark.parametrize("fmi", VERSIONS)
def test_casadi_imports_it_with_exact_derivatives(fmi: str, tmp_path: Path) -> None:
    ode = compile_model("PneumaticMuscle.Benches.Isotonic")
    path = build_fmu(ode, tmp_path / "x.fmu", fmi=fmi)
    folder = str(fmpy.extract(str(path), unzipdir=str(tmp_path / "fmu")))
    dae = ca.DaeBuilder("model", folder)
    assert dae.x() == [v.name for v in ode.states] and dae.u() == list(ode.interface.inputs)
    function = dae.create("f", ["x", "u"], ["ode", "y"])
    x, u = [v.start for v in ode.states], [0.3, 0.1, 207e3]
    x[0] = 1.8e5
    jacobian = function.jacobian()
    blocks = [np.array(block) for block in jacobian(x, u, ca.DM(3, 1), ca.DM(3, 1))]
    ours = np.block([[blocks[0], blocks[1]], [blocks[2], blocks[3]]])
    exact = _exact(ode, (ca.DM(x), ca.DM(u)))
    assert np.count_nonzero(exact) > 8
    assert ours == pytest.approx(
        exact, rel=1e-9, abs=1e-9 * np.abs(exact).min(where=exact != 0, initial=1.0)
    )


_SSD = """<?xml version="1.0" encoding="UTF-8"?>
<ssd:SystemStructureDescription xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon"
  xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription" version="1.0" name="Chain">
  <ssd:System name="Chain">
    <ssd:Connectors>
      <ssd:Connector name="u" kind="input"><ssc:Real/></ssd:Connector>
      <ssd:Connector name="y" kind="output"><ssc:Real/></ssd:Connector>
    </ssd:Connectors>
    <ssd:Elements>{components}</ssd:Elements>
    <ssd:Connections>
      <ssd:Connection startConnector="u" endElement="a" endConnector="u"/>
      <ssd:Connection startElement="a" startConnector="y" endElement="b" endConnector="u"/>
      <ssd:Connection startElement="b" startConnector="y" endConnector="y"/>
    </ssd:Connections>
  </ssd:System>
</ssd:SystemStructureDescription>"""
_COMPONENT = """<ssd:Component name="{0}" type="application/x-fmu-sharedlibrary" source="resources/lag.fmu">
  <ssd:Connectors>
    <ssd:Connector name="u" kind="input"><ssc:Real/></ssd:Connector>
    <ssd:Connector name="y" kind="output"><ssc:Real/></ssd:Connector>
  </ssd:Connectors></ssd:Component>"""


def _chain(t: np.ndarray) -> np.ndarray:
    """Step response of two lags of 0.5 s in a row."""
    s = t / 0.5
    return 1.0 - (1.0 + s) * np.exp(-s)


def test_two_in_a_row_as_ssp(tmp_path: Path) -> None:
    """FMPy's SSP runs FMI 2.0 alone."""
    path = tmp_path / "chain.ssp"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(
            "SystemStructure.ssd",
            _SSD.format(components=_COMPONENT.format("a") + _COMPONENT.format("b")),
        )
        archive.write(models.fmu(models.lag), "resources/lag.fmu")
    result = simulate_ssp(str(path), stop_time=2.0, step_size=0.01, input={"u": lambda t: 1.0})
    name = next(n for n in result.dtype.names if n.endswith("b.y"))
    after = result["time"] + 0.01  # FMPy writes the values after a step beside the time before it
    assert result[name] == pytest.approx(_chain(after), abs=0.03)


@pytest.mark.parametrize("fmi", VERSIONS)
def test_two_in_a_row_in_a_container(fmi: str, tmp_path: Path) -> None:
    inner = models.fmu(models.lag, fmi)
    description = fmpy.read_model_description(str(inner))
    by_name = {v.name: v for v in description.modelVariables}
    kind = "Real" if fmi == "2.0" else "Float64"
    u = ModelVariable(type=kind, name="u", causality="input", variability="continuous", start="0")
    y = ModelVariable(
        type=kind, name="y", causality="output", variability="continuous", initial="calculated"
    )
    time = ModelVariable(type=kind, name="time", causality="independent", variability="continuous")
    outer = ModelDescription(
        fmiVersion=fmi,
        modelName="Chain",
        instantiationToken="{chain}",
        coSimulation=CoSimulation(modelIdentifier="container_fmu", fixedInternalStepSize=0.01),
        defaultExperiment=DefaultExperiment(startTime="0", stopTime="2", stepSize="0.01"),
        modelVariables=[time, u, y],  # the container takes reference 0 for the time
        outputs=[Unknown(variable=y)],
        initialUnknowns=[Unknown(variable=y)],
    )
    start = evolve(
        by_name["y"], type="Float64"
    )  # FMPy hands the type on to a program that knows FMI 3.0's names only
    a, b = (Component(name=n, filename=inner, modelDescription=description) for n in "ab")
    configuration = Configuration(
        parallelDoStep=False,
        modelDescription=outer,
        components=[a, b],
        connections=[Connection(a, [start], b, [by_name["u"]])],
        variableMappings={u: [(a, by_name["u"])], y: [(b, by_name["y"])]},
    )
    (tmp_path / "unzipped").mkdir()
    path = tmp_path / "Chain.fmu"
    create_container_fmu(configuration, tmp_path / "unzipped", path)
    result = fmpy.simulate_fmu(
        str(path), start_values={"u": 1.0}, stop_time=2.0, output_interval=0.01
    )
    assert result["y"] == pytest.approx(_chain(result["time"]), abs=0.03)
