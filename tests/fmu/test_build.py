"""Archives: valid, complete, the same every time; the interface reads back as it was written."""

from __future__ import annotations

import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

import casadi as ca
import pytest
from fmpy.validation import validate_fmu

from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import InputError, ModelError
from pam_cosim.fmu import (
    build_fmu,
    build_model,
    build_source,
    cached_fmu,
    description_of,
    read_interface,
)
from pam_cosim.fmu import library as fmu_library
from pam_cosim.model.interface import Variable
from pam_cosim.simulation import Simulator
from tests.fmu import models

ALL = [
    models.van_der_pol,
    models.lag,
    models.ramp_driven,
    models.algebraic,
    models.forced,
    models.oscillator,
]


@pytest.mark.parametrize("make", ALL, ids=lambda make: make.__name__)
def test_fmpy_finds_no_problem(make) -> None:  # type: ignore[no-untyped-def]
    assert validate_fmu(str(models.fmu(make))) == []


@pytest.mark.parametrize("make", ALL, ids=lambda make: make.__name__)
def test_interface_reads_back_exactly(make) -> None:  # type: ignore[no-untyped-def]
    written, read = make().interface, read_interface(models.fmu(make))
    assert read.model == written.model
    assert read.inputs == written.inputs
    assert read.parameters == written.parameters
    assert list(read.outputs) == list(written.outputs)
    assert set(written.locals) <= set(read.locals) | set(read.outputs)
    assert (read.stop_time, read.interval, read.tolerance) == (
        written.stop_time,
        written.interval,
        written.tolerance,
    )


def _tree(path: Path) -> Xml.Element:
    with zipfile.ZipFile(path) as archive:
        return Xml.fromstring(archive.read("modelDescription.xml"))


def _dependencies(path: Path, part: str) -> dict[str, list[str]]:
    tree = _tree(path)
    names = [v.attrib["name"] for v in tree.iter("ScalarVariable")]
    unknowns = tree.find(f"ModelStructure/{part}")
    assert unknowns is not None
    return {
        names[int(u.attrib["index"]) - 1]: [
            names[int(i) - 1] for i in u.attrib["dependencies"].split()
        ]
        for u in unknowns
    }


def test_dependencies_are_exact() -> None:
    path = models.fmu(models.lag)
    assert _dependencies(path, "Outputs") == {"y": ["x"], "feed": ["x", "u"]}
    assert _dependencies(path, "Derivatives") == {"der(x)": ["x", "u"]}
    assert _dependencies(path, "InitialUnknowns") == {
        "x": ["x_start"],
        "der(x)": ["u", "tau", "x_start"],
        "y": ["x_start"],
        "feed": ["u", "x_start"],
    }
    assert _dependencies(models.fmu(models.algebraic), "Outputs") == {"y": ["u"]}


def _kinds(path: Path, part: str) -> dict[str, dict[str, str]]:
    tree = _tree(path)
    names = [v.attrib["name"] for v in tree.iter("ScalarVariable")]
    unknowns = tree.find(f"ModelStructure/{part}")
    assert unknowns is not None
    return {
        names[int(u.attrib["index"]) - 1]: {
            names[int(i) - 1]: kind
            for i, kind in zip(
                u.attrib["dependencies"].split(), u.attrib["dependenciesKind"].split(), strict=True
            )
        }
        for u in unknowns
    }


def test_kinds_of_dependencies_are_exact(tmp_path: Path) -> None:
    path = models.fmu(models.lag)
    assert _kinds(path, "Outputs") == {
        "y": {"x": "constant"},
        "feed": {"x": "constant", "u": "constant"},
    }
    assert _kinds(path, "Derivatives") == {"der(x)": {"x": "fixed", "u": "fixed"}}
    assert _kinds(path, "InitialUnknowns")["der(x)"] == {
        "u": "dependent",
        "tau": "dependent",
        "x_start": "dependent",
    }
    assert _kinds(path, "InitialUnknowns")["feed"] == {"u": "constant", "x_start": "constant"}
    assert _kinds(models.fmu(models.van_der_pol), "Derivatives")["der(v)"] == {
        "x": "dependent",
        "v": "dependent",
    }


def test_what_a_condition_depends_on_has_no_constant_factor(tmp_path: Path) -> None:
    x, u, k = ca.SX.sym("x"), ca.SX.sym("u"), ca.SX.sym("k")
    switched = models.ode(
        "Switched",
        {"x": (x, -x, 1.0)},
        {"a": ca.if_else(x > 0, u, 2 * u) + 3 * x, "b": ca.sign(x) + k * u, "c": ca.fmod(x, 2) + u},
        inputs={"u": u},
        parameters={"k": (k, 1.0)},
    )
    assert _kinds(build_fmu(switched, tmp_path / "x.fmu"), "Outputs") == {
        "a": {"x": "dependent", "u": "dependent"},
        "b": {"x": "dependent", "u": "fixed"},
        "c": {"x": "dependent", "u": "constant"},
    }


def test_unknown_version_of_fmi(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no FMI version '4.0' to build; choose from 2.0, 3.0"):
        build_fmu(models.lag(), tmp_path / "x.fmu", fmi="4.0")


def test_units_in_the_description() -> None:
    units = {u.attrib["name"]: u for u in _tree(models.fmu(models.oscillator)).iter("Unit")}
    assert units["N"][0].attrib == {"kg": "1", "m": "1", "s": "-2"}
    degrees = units["K"].find("DisplayUnit")
    assert degrees is not None and float(degrees.attrib["offset"]) == -273.15


def _with_parameter(variable: Variable) -> Ode:
    made = models.lag()
    return replace(
        made,
        interface=replace(
            made.interface, parameters={**made.interface.parameters, "tau": variable}
        ),
    )


@pytest.mark.parametrize(
    ("variable", "message"),
    [
        (Variable("tau"), "parameter 'tau' has no value"),
        (Variable("tau", start=float("nan")), "not a finite number"),
        (Variable("tau", unit="wibble", start=1.0), "variable 'tau': unit 'wibble'"),
        (
            Variable("tau", unit="s", display_unit="m", start=1.0),
            "variable 'tau': display unit 'm'",
        ),
        (Variable("u", start=1.0), "'u' is the name of two variables"),
    ],
)
def test_faulty_models_are_named_and_nothing_is_written(
    tmp_path: Path, variable: Variable, message: str
) -> None:
    with pytest.raises(ModelError, match=message):
        build_fmu(_with_parameter(variable), tmp_path / "x.fmu")
    assert list(tmp_path.iterdir()) == []


def test_cached_fmu_compiles_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pam_cosim.cache.cache_dir", lambda: tmp_path)
    made = []

    def make() -> Ode:
        made.append(1)
        return models.lag()

    first = cached_fmu("key", make)
    assert cached_fmu("key", make) == first and len(made) == 1
    assert cached_fmu("other", make) != first and len(made) == 2


def test_a_description_needs_no_compiler_and_is_that_of_the_fmu(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    built = read_interface(build_model("TankFilling"))
    monkeypatch.setattr("pam_cosim.cache.cache_dir", lambda: tmp_path)
    monkeypatch.setattr("pam_cosim.fmu.build.compile_library", None)
    assert read_interface(description_of("TankFilling")) == built
    with pytest.raises(InputError, match="no such file"):
        description_of(str(tmp_path / "missing.fmu"))


def test_foreign_files_are_refused(tmp_path: Path) -> None:
    text = tmp_path / "x.fmu"
    text.write_text("no archive")
    with pytest.raises(InputError, match="not an FMU"):
        read_interface(text)
    with pytest.raises(InputError, match="no such file"):
        read_interface(tmp_path / "missing.fmu")
    with pytest.raises(InputError, match="no such file"):
        build_model(str(tmp_path / "missing.fmu"))


def test_modelica_source_to_fmu() -> None:
    source = "model Decay parameter Real k = 2; output Real y; Real x(start = 1, fixed = true);\n"
    path = build_source("Decay", source + "equation der(x) = -k*x; y = x; end Decay;")
    assert read_interface(path).parameters["k"].start == 2.0
    assert validate_fmu(str(path)) == []


def test_a_model_that_changes_while_it_is_compiled_is_not_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It was kept under the hash of the text before, and found again when that text came back."""
    monkeypatch.setattr("pam_cosim.cache.cache_dir", lambda: tmp_path)
    file, before = tmp_path / "A.mo", "model A output Real y = time; end A;"
    file.write_text(before)
    compile_now = fmu_library.compile_model

    def changed_first(*arguments: Any, **named: Any) -> Ode:
        file.write_text(before.replace("time", "2*time"))
        return compile_now(*arguments, **named)

    with monkeypatch.context() as within:
        within.setattr(fmu_library, "compile_model", changed_first)
        with pytest.raises(InputError, match="changed since this began"):
            build_model(str(file))
    file.write_text(before)
    with Simulator(build_model(str(file))) as simulator:
        assert simulator.run([0.0, 1.0])["y"][-1] == 1.0
