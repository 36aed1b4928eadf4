"""What is known beforehand of what may be missing."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from pam_cosim import study
from pam_cosim.diagnosis.judgement.model_space import ModelSpace, effects_named
from pam_cosim.errors import InputError
from pam_cosim.measurement import write_data_set
from pam_cosim.simulation import Simulator
from rig.short import write_light_data
from tests.diagnosis.linear_world import CATALOGUE


def test_expected_effects_are_chosen_from_among_themselves() -> None:
    model_space = ModelSpace(100, frozenset({"a", "b"}))
    assert model_space.cost(()) == 0.0
    assert model_space.cost(("c",)) == pytest.approx(2 * math.log(100))
    assert model_space.cost(("a",)) == pytest.approx(2 * math.log(2))
    assert model_space.cost(("a", "c")) == pytest.approx(2 * math.log(2 * 100))
    assert ModelSpace(10).cost(("x", "y")) == pytest.approx(2 * math.log(45))


def test_a_family_or_an_effect_is_meant_by_its_name() -> None:
    leaks = {e.name for e in CATALOGUE if e.family == "leak"}
    assert effects_named(CATALOGUE, "leak") == leaks
    assert effects_named(CATALOGUE, "ThermocoupleLag") == {"ThermocoupleLag"}
    assert effects_named(CATALOGUE, "wrong_parameter") == frozenset()
    with pytest.raises(ValueError, match=r"no effect 'leek'; did you mean 'leak'"):
        effects_named(CATALOGUE, "leek")


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ('exclude = ["leak"]\nexpect = ["leak"]', {}),
        ('expect = ["leak"]', {"exclude": ["leak"]}),
        ('exclude = ["leak"]', {"expect": ["leak"]}),
    ],
)
def test_an_effect_both_excluded_and_expected_is_refused_where_it_stands(
    tmp_path: Path, table: str, words: dict[str, list[str]]
) -> None:
    write_light_data(tmp_path / "d", seed=3)
    file = tmp_path / "d" / "experiment.toml"
    file.write_text(f"{file.read_text()}\n[effects]\n{table}\n")
    with pytest.raises(InputError, match="leak is both excluded, .* keep one of them") as refused:
        study.diagnose(study.read(tmp_path / "d"), workers=0, explain=False, **words)
    assert (refused.value.file, refused.value.line) == (file, len(file.read_text().splitlines()))


def test_what_is_excluded_or_expected_is_read_and_written(
    tmp_path: Path, bench: Callable[[str], Path]
) -> None:
    write_light_data(tmp_path / "d", seed=3)
    file = tmp_path / "d" / "experiment.toml"
    text = file.read_text()
    file.write_text(
        text + '\n[effects]\nexclude = ["creep", "OrificeLeak"]\nexpect = ["elasticity"]\n'
    )
    data = study.read(tmp_path / "d")
    assert (data.excluded, data.expected) == (("creep", "OrificeLeak"), ("elasticity",))
    with Simulator(bench("Isotonic")) as simulator:
        again = write_data_set(tmp_path / "again", data, simulator.interface)
    assert (again.excluded, again.expected) == (data.excluded, data.expected)


def test_an_unknown_family_is_refused_where_it_stands(tmp_path: Path) -> None:
    write_light_data(tmp_path / "d", seed=3)
    file = tmp_path / "d" / "experiment.toml"
    file.write_text(file.read_text() + '\n[effects]\nexclude = ["crepe"]\n')
    with pytest.raises(InputError) as refused:
        study.diagnose(study.read(tmp_path / "d"), workers=0)
    assert "did you mean 'creep'" in str(refused.value)
    assert (
        refused.value.file == file
        and refused.value.line == file.read_text().splitlines().index('exclude = ["crepe"]') + 1
    )
    with pytest.raises(InputError, match="expect: there is no family"):
        study.diagnose(
            replace(study.read(tmp_path / "d"), excluded=()), workers=0, expect=["crepe"]
        )
