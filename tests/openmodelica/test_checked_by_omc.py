"""OpenModelica's ``checkModel`` of every class and every composition, where ``omc`` is on the path (README.md)."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterable, Sequence
from pathlib import Path

import pytest

from pam_cosim import study
from pam_cosim.resources import modelica_root
from tests.library.catalogue import BENCH, benches, composed, effects, tree
from tests.library.test_effects_in_series import SIX
from tests.openmodelica.compiler import OMC, WHY_NOT

pytestmark = pytest.mark.skipif(OMC is None, reason=WHY_NOT)

KINDS = (
    "model",
    "block",
    "class",
    "connector",
    "record",
    "function",
)  # it refuses packages and types
PASSED = "completed successfully"
EXPECTED = (  # of a component that is meant to stand in a bench
    "An inner declaration for outer component",
    "due to top-level outer element",
)
WRONG = """model Wrong "A bottle of a class that is not there"
  inner PneumaticMuscle.Ambient ambient;
  PneumaticMuscle.Pneumatics.Components.Tonk bottle(p_start=690e3);
end Wrong;
"""


def checked(names: Sequence[str], files: Iterable[Path], folder: Path) -> dict[str, str]:
    """What the compiler says of each class, in the words of Modelica 3.6 and with units."""
    assert OMC is not None
    loaded = [modelica_root() / "PneumaticMuscle" / "package.mo", *files]
    script = ['setCommandLineOptions("--std=3.6 --unitChecking");']
    script += [
        f'if not loadFile("{file.as_posix()}") then print(getErrorString()); end if;'
        for file in loaded
    ]
    script += [
        f'print("@@ {name}\\n" + checkModel({name}) + getErrorString() + "\\n");' for name in names
    ]
    (folder / "check.mos").write_text("\n".join(script))
    run = subprocess.run(
        [OMC, "check.mos"], cwd=folder, capture_output=True, text=True, timeout=900, check=True
    )
    answers = re.split(r"^@@ (\S+)$", run.stdout, flags=re.MULTILINE)
    assert "Error" not in answers[0], answers[0]
    return dict(zip(answers[1::2], answers[2::2], strict=True))


def refused(answers: dict[str, str]) -> dict[str, str]:
    """The classes that did not pass, or of which there is a warning that is not expected."""
    return {name: text for name, text in answers.items() if PASSED not in text or _warned(text)}


def _warned(text: str) -> bool:
    lines = (line for line in text.splitlines() if "Warning:" in line or "Error:" in line)
    return any(not any(words in line for words in EXPECTED) for line in lines)


def test_every_class(tmp_path: Path) -> None:
    names = [name for name, info in tree().classes.items() if info.kind in KINDS]
    answers = checked(names, [], tmp_path)
    assert len(answers) == len(names) > 500
    assert refused(answers) == {}


@pytest.mark.parametrize("everywhere", [False, pytest.param(True, marks=pytest.mark.full)])
def test_every_composition(everywhere: bool, tmp_path: Path) -> None:
    """Of each effect with the first bench that has a place for it, or with all of them."""
    texts: dict[str, str] = {}
    for effect in effects():
        places = [
            c for bench in (BENCH, *benches()) if (c := composed(bench, effect.name)) is not None
        ]
        assert places, effect.name
        for one in places if everywhere else places[:1]:
            name = f"{one.base.rpartition('.')[2]}With{effect.name}"
            texts[name] = re.sub(rf"\b{re.escape(one.name)}\b", name, one.text)
    (tmp_path / "Composed.mo").write_text("\n".join(texts.values()))
    answers = checked(list(texts), [tmp_path / "Composed.mo"], tmp_path)
    assert len(answers) == len(texts) >= len(effects())
    assert refused(answers) == {}


def test_effects_in_series(tmp_path: Path) -> None:
    """In a bench, and once more in what came of it."""
    first, further = tmp_path / "First.mo", tmp_path / "Further.mo"
    study.add(SIX, "Isotonic", first)
    study.add(["PositionFloor", "PressureGain"], str(first), further)
    answers = checked(["First", "Further"], [further], tmp_path)
    assert refused(answers) == {}


def test_a_class_that_is_wrong_is_refused(tmp_path: Path) -> None:
    (tmp_path / "Wrong.mo").write_text(WRONG)
    assert refused(checked(["Wrong"], [tmp_path / "Wrong.mo"], tmp_path)).keys() == {"Wrong"}
