"""Effects stand in packages by family: each says its family once, and what its members have in common."""

from __future__ import annotations

from pathlib import Path

import pytest

from pam_cosim.catalogue import EffectClass, effect_classes
from pam_cosim.compiler import read_library
from pam_cosim.errors import ModelError
from pam_cosim.resources import modelica_root
from tests.library.catalogue import effects, tree

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


ANNOTATED = """model Drag "A drag"
  extends PneumaticMuscle.Effects.RateFriction.FamilyMember(final absent="c=0, d=0");
  parameter Real c(min=0, max=10) = 1 "Drag"
    annotation (Dialog(group="Effect"), __PamCosim({entry}));
  parameter Real d(min=0, max=10) = 1 "Drag";
equation
  f = c*v;
end Drag;
"""


def annotated(entry: str, folder: Path) -> EffectClass:
    file = folder / "Drag.mo"
    file.write_text(ANNOTATED.replace("{entry}", entry))
    return next(e for e in effect_classes(read_library(files=[file])) if e.name == "Drag")


@pytest.mark.parametrize(
    ("entry", "field", "value"),
    [
        ("typical={-0.5, 2}", "typical", (-0.5, 2.0)),
        ('at_min="", at_max="ViscousFriction"', "simpler", ("", "ViscousFriction")),
        ('at_max="ViscousFriction"', "simpler", (None, "ViscousFriction")),
        ('above="x"', "limits", ("above", "x")),
        ('below="p"', "limits", ("below", "p")),
    ],
)
def test_an_effect_says_of_its_parameters_what_is_known_of_them(
    entry: str, field: str, value: object, tmp_path: Path
) -> None:
    assert getattr(annotated(entry, tmp_path), field) == {"c": value}


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        *((f"typical={text}", "typical of c must be two numbers in braces")
          for text in ("{2, 1}", "{1}", "0.5", "{0.5, k}", '"0.5"')),
        ("at_min={0.5}", "at_min of c must be the name of an effect in quotes"),
        ("above=x", "above of c must be the name of a signal in quotes"),
        ('at_max="Nothing"', "at_max of c names Nothing, which is no effect of PneumaticMuscle"),
    ],
)  # fmt: skip
def test_what_is_annotated_wrongly_is_named_with_its_place(
    entry: str, said: str, tmp_path: Path
) -> None:
    with pytest.raises(ModelError, match=said) as caught:
        annotated(entry, tmp_path)
    assert (caught.value.file, caught.value.line) == (tmp_path / "Drag.mo", 3)
