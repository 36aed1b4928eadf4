"""The run that is designed separates the models that a verdict leaves."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from pam_cosim import study
from pam_cosim.cli.app import main
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.planning import RunPlan, limits_of
from pam_cosim.diagnosis.planning.rivals import Rivals
from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, further_run, read_data_set, read_recording
from pam_cosim.study.tables import write_planned_runs
from rig.short import write_light_data
from tests.diagnosis.test_next_experiment import rival
from tests.reporting.synthetic import make_diagnosis


@pytest.fixture(scope="module")
def diagnosis(tmp_path_factory: pytest.TempPathFactory) -> Diagnosis:
    """A spring and a creep are left."""
    folder = write_light_data(tmp_path_factory.mktemp("rig") / "d")
    data: DataSet = read_data_set(folder, lambda name: study.describe(name))
    spring = rival("LinearBladder", "elasticity", data, k=250.0)
    creep = rival("MaxwellCreep", "creep", data, k=250.0, tau=1.5)
    effects = (spring.effects, creep.effects)
    return replace(
        make_diagnosis("ambiguous"),
        data=data,
        model=data.model,
        candidates=(spring, creep),
        path=(),
        rivals=effects,
    )


@pytest.fixture(scope="module")
def plan(diagnosis: Diagnosis) -> RunPlan:
    return study.plan(diagnosis, limits={"load.m": ("2 kg", "4 kg")}, seconds="3 s", seed=1)


def test_it_separates_the_rivals_better_than_chance(plan: RunPlan) -> None:
    (run,) = plan.runs
    assert plan.rivals == ("LinearBladder", "MaxwellCreep") and plan.families == (
        "elasticity",
        "creep",
    )
    assert plan.decides and run.chi2 > 2 * run.at_random > 0
    assert "should decide between LinearBladder, MaxwellCreep" in plan.expectation
    assert run.table["time"][-1] == 3.0 and 2.0 <= run.parameters["load.m"] <= 4.0
    assert min(run.table["u_in"]) >= 0.0 and max(run.table["u_in"]) <= 0.35
    frame = plan.to_frame()
    assert list(frame["u_in"]) == list(run.table["u_in"]) and set(frame.index) == {1}
    assert frame.attrs["units"] == {
        "run": "", "time": "s", "u_in": "A", "u_out": "A", "p_supply": "Pa"
    }  # fmt: skip


def test_the_table_alone_gives_the_run(diagnosis: Diagnosis, plan: RunPlan) -> None:
    """What a rig plays from the table separates the rivals as was said."""
    limits = limits_of(diagnosis.data, {"load.m": (2.0, 4.0)}, 3.0)
    (run,) = plan.runs
    with Rivals([[one] for one in diagnosis.rival_models], diagnosis.data, limits) as rivals:
        course = further_run(diagnosis.data, run.time, run.inputs, run.parameters)
        predictions = rivals.predictions(course)
        assert predictions is not None
        assert rivals.separations(predictions)[0] == pytest.approx(run.chi2, rel=1e-3)


def test_it_is_saved_as_the_table_that_a_rig_plays(plan: RunPlan, tmp_path: Path) -> None:
    write_planned_runs(tmp_path / "command.csv", plan)
    assert study.save(plan, tmp_path / "python.csv") == tmp_path / "python.csv"
    assert (tmp_path / "python.csv").read_bytes() == (tmp_path / "command.csv").read_bytes()
    assert str(study.load(study.save(plan, tmp_path / "plan.npz"))) == str(plan)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"limits": {"u_inn": (0, 1)}}, "did you mean 'u_in'"),
        ({"limits": {"u_in": ("0 kg", "1 kg")}}, "kg"),
        ({"limits": {"u_in": (0.0,)}}, "two values"),
        ({"seconds": "0 s"}, "above 0 s"),
        ({"runs": 0}, "one run at least"),
    ],
)
def test_what_cannot_be_planned(diagnosis: Diagnosis, options: dict, message: str) -> None:
    with pytest.raises(InputError, match=message):
        study.plan(diagnosis, **options)


def test_a_verdict_without_rivals_leaves_nothing_to_decide(diagnosis: Diagnosis) -> None:
    with pytest.raises(InputError, match="the verdict is ambiguous: there are no rivals"):
        study.plan(replace(diagnosis, rivals=diagnosis.rivals[:1]))


def test_the_command_writes_what_a_rig_can_play(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    diagnosis: Diagnosis,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(study, "load", lambda path: diagnosis)
    words = ["plan", "d.npz", "--limit", "load.m=2 kg:4 kg", "--seconds", "3 s", "--seed", "1"]
    files = {name: tmp_path / name for name in ("next.csv", "next.png", "plan.json")}
    outputs = ["-o", files["next.csv"], "--plot", files["next.png"], "--json", files["plan.json"]]
    assert main([*words, *map(str, outputs)]) == 0
    assert "LinearBladder against MaxwellCreep: chi-square" in capsys.readouterr().out
    text = files["next.csv"].read_text()
    assert text.startswith("# This run should decide") and "# set load.m = " in text
    recording = read_recording(files["next.csv"], study.describe("Isotonic"))
    assert set(recording.inputs) == {"u_in", "u_out", "p_supply"}
    assert (
        files["next.png"].read_bytes()[:4] == b"\x89PNG"
        and '"decides": true' in files["plan.json"].read_text()
    )
    assert main(["plan", "d.npz", "--limit", "load.m=2 kg"]) == 2
    assert "write NAME=FROM:TO" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "said"),
    [(["--limit", "u_in=1:0"], "'u_in' begin above their end"), (["--limit", "spring=0:1"], "no 'spring' to limit"),
     (["--seconds", "0 s"], "above 0 s"), (["--hold", "u_inn"], "no input 'u_inn' to hold")],
)  # fmt: skip
def test_what_is_wrong_is_said_before_a_data_set_is_diagnosed(
    words: list[str],
    said: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def diagnosed(*_: object, **__: object) -> None:
        raise AssertionError("was diagnosed first")

    monkeypatch.setattr(study, "diagnose", diagnosed)
    folder = write_light_data(tmp_path / "d")
    assert main(["plan", str(folder), *words]) == 2
    assert said in capsys.readouterr().err
