"""Scores against numbers computed by hand."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from pam_cosim.comparison import chi2_reduced, compare, score, simulate_run
from pam_cosim.comparison.scores import score_signal
from pam_cosim.errors import InputError
from pam_cosim.files import plain, write_json
from pam_cosim.starts import start_time
from tests.comparison.fake import FakeSimulator, data_set, run

NAN = math.nan
TIME = [0.0, 1.0, 2.0, 3.0]
MEASURED = [1.0, 2.0, NAN, 4.0]
MODEL = [1.0, 1.0, 1.0, 2.0]  # differences 0, 1, -, 2


def _simulator() -> FakeSimulator:
    return FakeSimulator(lambda t, parameters: {"p": np.array(MODEL), "x": np.zeros(len(t))})


def test_numbers_by_hand() -> None:
    data = data_set([run("one", TIME, p=MEASURED)], {"p": 0.5})
    s = compare(_simulator(), data).scores["all"]["p"]
    assert s.samples == 3
    assert s.rmse == pytest.approx(math.sqrt(5 / 3))
    assert s.nrmse == pytest.approx(math.sqrt(5 / 3) / 3)
    assert s.bias == pytest.approx(1.0)
    assert (s.max, s.max_time, s.max_run) == (2.0, 3.0, "one")
    assert s.correlation == pytest.approx(15 / math.sqrt(252))
    assert s.chi2_reduced == pytest.approx(20 / 3)
    assert s.noise_rmse == 0.5


def test_bias_is_measured_minus_model() -> None:
    """A rig that reads less than the model has a negative bias."""
    data = data_set([run("one", TIME, p=[0.0, 0.0, 0.0, 0.0])], {"p": 1.0})
    assert compare(_simulator(), data).scores["all"]["p"].bias == pytest.approx(-1.25)


def test_a_signal_that_does_not_move_has_no_range() -> None:
    data = data_set([run("one", TIME, p=[0.0, 0.0, 0.0, 0.0])], {"p": 1.0})
    assert "(it does not move, noise 0.001 kPa)" in str(compare(_simulator(), data))


def test_recordings_without_a_sample_are_refused() -> None:
    data = data_set([run("one", TIME, p=[NAN] * 4)], {"p": 1.0})
    with pytest.raises(InputError, match="one.csv.*has a sample of an output of Test.Fake: p, x"):
        compare(_simulator(), data)


def test_roles_are_scored_apart_and_together() -> None:
    runs = [run("a", TIME, p=np.array(MODEL) + 1), run("b", TIME, "holdout", p=np.array(MODEL) - 3)]
    comparison = compare(_simulator(), data_set(runs, {"p": 1.0}))
    rmse = {role: scores["p"].rmse for role, scores in comparison.scores.items()}
    assert rmse == pytest.approx({"fit": 1.0, "holdout": 3.0, "all": math.sqrt(5)})
    assert comparison.chi2_reduced("fit") == pytest.approx(1.0)
    assert comparison.chi2_reduced("holdout") == pytest.approx(9.0)
    assert comparison.chi2_reduced() == pytest.approx(5.0)
    assert comparison.scores["all"]["p"].max_run == "b"


def test_chi_square_counts_every_sample_once_and_fitted_signals_only() -> None:
    """p: 3 samples with mean square 20/3; x: 4 samples with mean square 4."""
    one = run("one", TIME, p=MEASURED, x=[0.2, 0.2, -0.2, 0.2])
    both = compare(_simulator(), data_set([one], {"p": 0.5, "x": 0.1}))
    assert both.chi2_reduced() == pytest.approx((20 + 16) / 7)
    only_p = compare(_simulator(), data_set([one], {"p": 0.5, "x": 0.1}, fitted=["p"]))
    assert only_p.chi2_reduced() == pytest.approx(20 / 3)
    assert only_p.scores["all"]["x"].rmse == pytest.approx(0.2)
    assert math.isnan(chi2_reduced({}))


def test_missing_samples_and_signals_that_a_run_lacks() -> None:
    runs = [
        run("a", TIME, p=MEASURED),
        run("b", TIME, x=[1.0, NAN, NAN, NAN]),
        run("c", TIME, p=[NAN] * 4),
    ]
    data = data_set(runs, {"p": 0.5, "x": 0.1})
    comparison = compare(_simulator(), data)
    assert {n: s.samples for n, s in comparison.scores["all"].items()} == {"p": 3, "x": 1}
    assert score([comparison.runs[2]], data.signals) == {}
    assert score_signal(comparison.runs[1:2], data.signals["p"]) is None
    assert comparison.scores["all"]["x"].rmse == 1.0


def test_numbers_that_do_not_exist() -> None:
    """Without range or variance there is no relative error or correlation."""
    data = data_set([run("one", TIME, x=[2.0, 2.0, 2.0, 2.0])], {"x": 0.5})
    s = compare(_simulator(), data).scores["all"]["x"]
    assert s.rmse == 2.0
    shown = plain(s)
    assert [shown[k] for k in ("nrmse", "correlation")] == [None] * 2


def test_start_time_rule() -> None:
    """With inputs the first row starts the run; a free course starts at zero, or earlier when samples do."""
    late, early = [1.0, 2.0], [-0.5, 2.0]
    inputs = {"u": [0.0, 0.0]}
    times = [
        start_time(run("r", late, inputs=inputs, p=late)),
        start_time(run("r", late, p=late)),
        start_time(run("r", early, p=early)),
    ]
    assert times == [1.0, 0.0, -0.5]
    simulator = FakeSimulator(lambda t, _: {"p": t, "x": t})
    for one, begin in ((run("r", late, p=late), 0.0), (run("r", late, inputs=inputs, p=late), 1.0)):
        simulate_run(simulator, data_set([one], {"p": 1.0}), one, {})
        assert simulator.calls[-1]["start_time"] == begin
        assert (simulator.calls[-1]["inputs"] is None) == (begin == 0.0)


def test_stated_values_of_a_run_override_fitted_values() -> None:
    simulator = FakeSimulator(lambda t, q: {"p": np.full(len(t), q["m"] + q["c"]), "x": t})
    runs = [run("a", TIME, p=[3.0] * 4, parameters={"m": 2.0}), run("b", TIME, p=[3.0] * 4)]
    comparison = compare(simulator, data_set(runs, {"p": 1.0}), {"m": 7.0, "c": 1.0})
    assert [c["parameters"] for c in simulator.calls] == [
        {"m": 2.0, "c": 1.0},
        {"m": 7.0, "c": 1.0},
    ]
    assert [float(r.residual("p")[0]) for r in comparison.runs] == [0.0, -5.0]


def test_json_has_the_keys_that_programs_rely_on(tmp_path) -> None:  # type: ignore[no-untyped-def]
    runs = [run("a", TIME, p=MEASURED), run("b", TIME, "holdout", p=MODEL)]
    comparison = compare(_simulator(), data_set(runs, {"p": 0.5}), {"k": 2.0})
    write_json(tmp_path / "c.json", comparison.as_dict())
    content = json.loads((tmp_path / "c.json").read_text())
    keys = {"rmse", "nrmse", "bias", "max", "correlation", "chi2_reduced", "noise_rmse"}
    for place in (content, content["roles"]["fit"], content["roles"]["holdout"], *content["runs"]):
        assert keys <= set(place["signals"]["p"])
    assert [(r["name"], r["role"]) for r in content["runs"]] == [("a", "fit"), ("b", "holdout")]
    assert content["parameters"] == {"k": 2.0}
    assert content["signals"]["p"]["rmse"] == pytest.approx(math.sqrt(5 / 7))
    for rule in content["where"]:
        assert set(rule) == {"signal", "rule", "error_share", "time_share"}


def test_text_shows_readable_units() -> None:
    def model(t, _):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        return {"p": np.zeros(4), "x": np.zeros(4)}

    comparison = compare(
        FakeSimulator(model), data_set([run("a", TIME, p=[3e3, -3e3, 3e3, -3e3])], {"p": 500.0})
    )
    assert "fit      p    rms error      3 kPa (50.0 % of range, noise 0.5 kPa)" in str(comparison)
