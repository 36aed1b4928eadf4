"""Classes that have moved keep their former names: models of users that say them mean the same classes."""

from __future__ import annotations

from pathlib import Path

import pytest

from pam_cosim.catalogue import full_name
from pam_cosim.compiler import Ode, compile_model
from pam_cosim.compiler.library import Library
from pam_cosim.compiler.syntax import ClassDefinition, TypeName
from pam_cosim.resources import modelica_root
from tests.library.shelf import check_each, tree

ROOT = "PneumaticMuscle"
LIBRARY = Library(modelica_root())
OWN = LIBRARY.top[ROOT].classes

HOMES = {
    "Muscles": ("Muscle", "ButylMuscle", "EmpiricalMuscle", "ReviewedMuscle", "HeldMuscle"),
    "Mechanics": ("Load", "Fixed", "Stop", "ImposedPosition", "Held", "Pulley"),
    "Pneumatics": (
        "Supply", "Atmosphere", "Orifice", "PlainOrifice", "Droop", "Regulator", "ValvePair", "ReviewedValves", "Tank",
    ),
}  # fmt: skip
MOVED = {
    f"Components.{name}": f"{home}.Components.{name}"
    for home, names in HOMES.items()
    for name in names
} | {
    "Sensors.GaugePressure": "Instruments.Sensors.GaugePressure",
    "Sources.Step": "Examples.Sources.Step",
    "Data.Butyl": "Muscles.Data.Butyl",
    "Validation.TankCurves": "Examples.Validation.TankCurves",
}
BENCH = """model Former "A bottle that empties, and a muscle that is held"
  inner {Ambient} ambient;
  {Tank} bottle(p_start=690e3, startIsReference=true);
  {PlainOrifice} hole(d=2.71e-3);
  {Atmosphere} room;
  {GaugePressure} manometer;
  output Real p(unit="Pa") = manometer.p;
equation
  connect(bottle.port, hole.port_a);
  connect(hole.port_b, room.port);
  connect(bottle.port, manometer.port);
end Former;
"""


@pytest.mark.parametrize("former", MOVED)
def test_a_former_name_means_the_class_that_moved(former: str) -> None:
    assert tree().resolve("", f"{ROOT}.{former}") == f"{ROOT}.{MOVED[former]}"


@pytest.mark.parametrize("name", ["Ambient", "Excitation"])
def test_what_stands_around_a_bench_is_of_its_class_under_its_former_name(name: str) -> None:
    former = tree().resolve("", f"{ROOT}.Components.{name}")
    assert former is not None and tree().is_subtype(former, f"{ROOT}.{name}")


def test_a_model_is_found_by_its_former_short_name() -> None:
    assert full_name("Validation.TankCurves") == f"{ROOT}.Examples.Validation.TankCurves"
    assert full_name("Validation.NoSuchModel") == "Validation.NoSuchModel"


def test_a_bench_of_former_names_has_the_equations_of_one_of_present_names(tmp_path: Path) -> None:
    moved = {name.partition(".")[2]: (name, now) for name, now in MOVED.items()}
    moved["Ambient"] = ("Components.Ambient", "Ambient")
    former, present = (
        _compiled({name: both[i] for name, both in moved.items()}, tmp_path) for i in (0, 1)
    )
    assert str(former.derivatives) == str(present.derivatives) and len(former.states) == 1
    assert former.interface.parameters.keys() == present.interface.parameters.keys()


def _compiled(names: dict[str, str], folder: Path) -> Ode:
    file = folder / "Former.mo"
    file.write_text(BENCH.format(**{name: f"{ROOT}.{written}" for name, written in names.items()}))
    return compile_model(str(file))


def test_the_library_itself_says_no_former_name() -> None:
    """Not every tool finds the first part of a name among what a package around inherits."""
    former = {name.partition(".")[0] for name in MOVED}
    assert not former & OWN.keys()
    assert former <= LIBRARY.top[ROOT].classes["UsersGuide"].classes["FormerNames"].classes.keys()
    check_each(_says_present_names, (node.qualified_name for node in LIBRARY.walk()))


def _says_present_names(name: str) -> None:
    node = LIBRARY.find(name)
    assert node is not None
    former = {name.partition(".")[0] for name in MOVED}
    for written in _written_names(node):
        first, *rest = written.names
        if first == ROOT:
            assert rest[0] in OWN, written.text
        elif first in former:
            assert _is_declared_around(node, first), written.text


def _written_names(node: ClassDefinition) -> list[TypeName]:
    clauses = [*node.extends, *([] if node.alias is None else [node.alias])]
    return [clause.type for clause in clauses] + [
        component.type for component in node.components.values()
    ]


def _is_declared_around(node: ClassDefinition, first: str) -> bool:
    around: ClassDefinition | None = node
    while around is not None:
        if first in around.classes:
            return True
        around = around.parent
    return False
