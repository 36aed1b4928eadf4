"""The class tree, the structure of a model, printing, hashing."""

import shutil

import pytest

from pam_cosim.catalogue import compose
from pam_cosim.compiler import compile_model, flat_hash, read_library, read_structure
from pam_cosim.compiler.expression_parser import ExpressionParser
from pam_cosim.compiler.lexer import tokenise
from pam_cosim.compiler.printing import expression_text
from pam_cosim.compiler.source import SourceText
from tests.compiler.run import MODELS


@pytest.fixture(scope="module")
def tree():
    return read_library(MODELS)


def test_class_info(tree):
    tank = tree.classes["Tanks.Tank"]
    assert (tank.kind, tank.partial, tank.description, tank.line) == ("model", False, "A tank", 12)
    area = next(c for c in tank.components if c.name == "A")
    assert area.type == "Real" and area.value == "2" and "parameter" in area.prefixes
    assert area.modifications["min"] == "0.01" and area.description == "Cross-section"
    assert tree.classes["Tanks.TwoPorts"].partial
    assert tree.classes["Tanks.Valve"].extends[0].name == "Tanks.TwoPorts"
    other = next(c for c in tree.classes["Tanks.Switched"].components if c.name == "other")
    assert (other.type, other.condition, other.modifications) == (
        "Tanks.Valve",
        "second",
        {"k": "0.7"},
    )


def test_inheritance(tree):
    assert tree.bases("Tanks.SwitchedOn") == ["Tanks.Switched", "Tanks.Bench"]
    assert tree.is_subtype("Muscles.Energetic", "Muscles.PartialGas")
    assert tree.subtypes("Muscles.PartialGas") == ["Muscles.Polytropic", "Muscles.Energetic"]
    names = [component.name for component in tree.components("Muscles.Energetic")]
    assert names == ["port", "V", "n", "p_start", "p", "T", "h", "m"]
    assert tree.resolve("Muscles.Bench", "Muscle") == "Muscles.Muscle"
    assert tree.resolve("Muscles.Bench", "Nothing") is None
    assert tree.constant("Language.Big", "a") == 10


@pytest.mark.parametrize(
    "written", ["extends Bench(redeclare {});", "extends Bench; redeclare {};"]
)
def test_a_redeclared_component_has_its_new_class_and_its_old_place(tmp_path, written):
    """An heir of the heir has it so too."""
    file = tmp_path / "Mine.mo"
    file.write_text(
        "package Mine model Old end Old; model New extends Old; end New;"
        ' partial model Bench replaceable Old o constrainedby Old "What stands there"'
        " annotation (Placement(transformation(extent={{10,0},{30,20}}))); Real r; end Bench;"
        f" model Own {written.format('New o')} end Own; model Last extends Own; end Last; end Mine;"
    )
    tree = read_library(root=MODELS, files=[file])
    for name in ("Mine.Own", "Mine.Last"):
        one, other = tree.components(name)
        assert (one.name, one.type, other.name) == ("o", "Mine.New", "r")
        assert (one.description, one.position) == ("What stands there", (20, 10))
    assert [c.type for c in tree.components("Mine.Bench")] == ["Mine.Old", "Real"]


def test_replaceables(tree):
    (gas,) = tree.replaceables("Muscles.Muscle")
    assert (gas.name, gas.default, gas.constraint) == (
        "Gas",
        "Muscles.Polytropic",
        "Muscles.PartialGas",
    )


def test_structure_shows_what_is_redeclared():
    structure = read_structure("Muscles.Redeclared", root=MODELS)
    (slot,) = structure.slots
    assert (slot.path, slot.constraint, slot.current) == (
        "muscle",
        "Muscles.PartialGas",
        "Muscles.Energetic",
    )
    parts = {part.path: part for part in structure.parts}
    assert (
        parts["muscle.gas"].type == "Muscles.Energetic"
        and "Muscles.PartialGas" in parts["muscle.gas"].bases
    )
    assert parts["muscle"].connectors == {"port": "Muscles.Port"}
    assert parts[""].bases == ("Muscles.Redeclared", "Muscles.Bench")


def test_user_file_extends_the_library(tmp_path):
    file = tmp_path / "Mine.mo"
    file.write_text("model Mine extends Tanks.Bench(valve(k=9)); end Mine;")
    ode = compile_model(str(file), root=MODELS)
    assert ode.interface.model == "Mine" and ode.interface.parameters["valve.k"].start == 9
    assert ode.interface.stop_time == 20
    assert compile_model("Mine", files=[file], root=MODELS).interface == ode.interface
    assert read_library(MODELS, [file]).is_subtype("Mine", "Tanks.Bench")


def test_models_of_a_file_stand_in_its_order(tmp_path):
    file = tmp_path / "a.mo"
    file.write_text(
        "model B end B; record R end R; package P model Inner end Inner; end P; model A end A;"
    )
    assert read_library(files=[file]).models_in(file) == ["B", "P.Inner", "A"]


def test_user_class_within_a_library_package(tmp_path):
    file = tmp_path / "More.mo"
    file.write_text("within Tanks; model More extends Bench; Tank third; end More;")
    assert len(compile_model("Tanks.More", files=[file], root=MODELS).states) == 3


def test_hash_changes_with_any_source(tmp_path):
    root = tmp_path / "library"
    shutil.copytree(MODELS, root)
    before = flat_hash("Tanks.Bench", root=root)
    assert before == flat_hash("Tanks.Bench", root=MODELS)
    assert before != flat_hash("Tanks.Short", root=root)
    with (root / "Tanks.mo").open("a") as stream:
        stream.write("// changed\n")
    assert before != flat_hash("Tanks.Bench", root=root)


@pytest.mark.parametrize(
    "text",
    [
        "a - (b - c)*d^2",
        "-(a + b)/c",
        "(a^b)^c",
        "if x > 0 and not y then {1, 2.5} else f(x, n=3)",
        'g("say \\"x\\"", 1:2:n, v[end, :])',
        "sum(x[i]^2 for i in 1:n)",
        "-a^2",
        "2*(if x then 1 else 2)",
        "[a, 2; 3, -b]*x",
        "f(function g(a=1), 2)",
    ],
)
def test_printed_expression_reads_the_same(text):
    source = SourceText("text", text)
    printed = expression_text(ExpressionParser(source, tokenise(source)).expression())
    assert printed == text


def test_each_component_is_modified_once():
    """Two effects that redeclare parts of one component share its modification; Modelica forbids a second one."""
    composition = compose(read_library(), "Isotonic", ["ValveDelay", "UnequalAreas", "EnergyGas"])
    assert composition.text.count("valve(") == composition.text.count("muscle(") == 1
    assert (
        "Drive = PneumaticMuscle.Effects.ValveDynamics.ValveDelay, redeclare model Area"
        in composition.text
    )


def test_what_is_added_has_a_name_that_no_variable_of_the_model_has(tmp_path):
    """Neither one of its own nor one that it inherits."""
    file = tmp_path / "Mine.mo"
    file.write_text(
        "package Mine partial model Named parameter Real deadVolume2 = 1; end Named;"
        " model Bench extends PneumaticMuscle.Benches.Isotonic; extends Named;"
        " parameter Real deadVolume = 1; end Bench; end Mine;"
    )
    composition = compose(read_library(files=[file]), "Mine.Bench", ["DeadVolume"], files=[file])
    assert "DeadVolume deadVolume3 " in composition.text
    assert all(name.startswith("deadVolume3.") for name in composition.parameters["DeadVolume"])
