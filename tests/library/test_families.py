"""Effects stand in packages by family: each says its family once, and what its members have in common."""

from __future__ import annotations

from pathlib import Path

import pytest

from pam_cosim.catalogue import effect_classes
from pam_cosim.compiler import compile_model, read_library
from pam_cosim.errors import ModelError
from pam_cosim.resources import modelica_root
from tests.library.shelf import effects, tree

EFFECTS = "PneumaticMuscle.Effects"
PACKAGES = sorted(
    p.parent.name for p in (modelica_root() / "PneumaticMuscle" / "Effects").glob("*/package.mo")
)


def test_a_package_holds_a_family() -> None:
    places = {
        effect.family: {
            e.qualified_name.split(".")[2] for e in effects() if e.family == effect.family
        }
        for effect in effects()
    }
    assert places == {
        family: {"".join(map(str.capitalize, family.split("_")))} for family in places
    }
    assert sorted(p for (p,) in places.values()) == PACKAGES and len(PACKAGES) == 22


@pytest.mark.parametrize("package", PACKAGES)
def test_family_and_balance_are_said_once(package: str) -> None:
    folder = modelica_root() / "PneumaticMuscle" / "Effects" / package
    assert [f.name for f in folder.glob("*.mo") if "family=" in f.read_text()] == [
        "FamilyMember.mo"
    ]
    assert not [
        f.name
        for f in folder.glob("*.mo")
        if "balance=" in f.read_text() and f.name != "FamilyMember.mo"
    ]
    assert "Fingerprint:" in tree().classes[f"{EFFECTS}.{package}"].documentation


def test_an_effect_of_ones_own_joins_a_family_by_its_member(tmp_path: Path) -> None:
    file = tmp_path / "Drag.mo"
    file.write_text(f"""model Drag "A drag" extends {EFFECTS}.RateFriction.FamilyMember(final absent="c=0");
      parameter Real c(min=0, max=10) = 1 "Drag"; equation f = c*v; end Drag;""")
    (own,) = (e for e in effect_classes(read_library(files=[file])) if e.name == "Drag")
    assert (own.family, own.balance, own.parameters) == ("rate_friction", "force", ("c",))


TYPICAL = """model Drag "A drag"
  extends {family}.FamilyMember(final absent="c=0");
  parameter Real c(min=0, max=10) = 1 "Drag"
    annotation (Dialog(group="Effect"), __PamCosim(typical={range}));
equation
  f = c*v;
end Drag;
"""


def test_an_effect_says_what_is_typical_of_its_parameters(tmp_path: Path) -> None:
    file = tmp_path / "Drag.mo"
    file.write_text(
        TYPICAL.replace("{family}", f"{EFFECTS}.RateFriction").replace("{range}", "{-0.5, 2}")
    )
    (own,) = (e for e in effect_classes(read_library(files=[file])) if e.name == "Drag")
    assert own.typical == {"c": (-0.5, 2.0)}


@pytest.mark.parametrize("text", ["{2, 1}", "{1}", "0.5", "{0.5, k}"])
def test_what_is_no_typical_range_is_named_with_its_place(text: str, tmp_path: Path) -> None:
    file = tmp_path / "Drag.mo"
    file.write_text(TYPICAL.replace("{family}", f"{EFFECTS}.RateFriction").replace("{range}", text))
    with pytest.raises(ModelError, match="typical of c wants two numbers in braces") as caught:
        effect_classes(read_library(files=[file]))
    assert (caught.value.file, caught.value.line) == (file, 3)


def test_a_class_that_has_moved_is_named_with_its_place(tmp_path: Path) -> None:
    file = tmp_path / "Mine.mo"
    file.write_text(f"model Mine\n  extends {EFFECTS}.LinearBladder;\nend Mine;")
    with pytest.raises(
        ModelError, match=rf"did you mean {EFFECTS}\.Elasticity\.LinearBladder\?"
    ) as caught:
        read_library(files=[file])
    assert (caught.value.file, caught.value.line, caught.value.column) == (file, 2, 11)


def test_a_law_that_has_moved_is_named_where_it_is_redeclared(tmp_path: Path) -> None:
    file = tmp_path / "Mine.mo"
    file.write_text("""model Mine
  extends PneumaticMuscle.Benches.Isotonic(muscle(redeclare model Wall = PneumaticMuscle.Components.PrintedWall));
end Mine;""")
    with pytest.raises(
        ModelError, match=r"did you mean PneumaticMuscle\.Laws\.Heat\.PrintedWall\?"
    ):
        compile_model(str(file))
