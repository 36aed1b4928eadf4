"""The parts of a diagnosis that say where it fails, what describes it, and what to measure next."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pam_cosim.diagnosis import LearnedModel, NextExperiment
from pam_cosim.diagnosis.description.explanation import disagreement
from pam_cosim.diagnosis.description.learning import LearnedTerm
from pam_cosim.ledger import BalanceEntry, Ledger, TermSeries
from pam_cosim.reporting import diagnosis_report, diagnosis_text
from pam_cosim.reporting.figures.layer import Layer
from pam_cosim.reporting.figures.residual_map import binned_residual
from pam_cosim.study.tables import write_next_run
from tests.reporting.html_checks import checked
from tests.reporting.synthetic import (
    SIGNALS,
    make_candidate,
    make_comparison,
    make_data,
    make_diagnosis,
)

PLAN = NextExperiment(
    run="run-2",
    change="load.m times 1.5",
    separation=2.5,
    evidence=1250.0,
    between=("elasticity", "end_shape"),
    parameters={"load.m": 3.0},
    interpolation="previous",
    table={"time": [0.0, 0.5, 10.0], "u_in": [0.35, 0.0, 0.0], "p_supply": [2e5, 2e5, 2e5]},
    units={"u_in": "A", "p_supply": "Pa", "load.m": "kg"},
)


def make_ledger(
    failing=("force", "energy"), closed=True, notes=("mass and heat cannot be told apart <here>",)
):
    t = np.linspace(0, 10, 101)
    x = 0.03 + 0.02 * np.sin(t)
    against = {"x": x, "v": 0.02 * np.cos(t), "p_gauge": 1e5 + 1e4 * np.cos(t)}
    course = TermSeries("run-1", "fit", t, np.full_like(t, -4.0), np.full_like(t, 0.3), against)
    units = {"x": "m", "v": "m/s", "p_gauge": "Pa"}
    force = BalanceEntry("force", 100.0, 0.9, 0.75, "N", "what pulls the load down", (course,), units,
                  same_as=("mass",))  # fmt: skip
    entries = (
        force,
        BalanceEntry("energy", 10.0, 0.1, 0.25),
        BalanceEntry("mass", -3.0, 0.0, 0.0),
    )
    return Ledger("Isotonic", entries, failing, closed, 50.0, 1.02, {}, notes)


def make_learned(data):
    term = LearnedTerm("LearnedForce", "force", "missing force = 5.1 N (exp(x/(40 mm)) - 1)",
                       "model LearnedForce\nend LearnedForce;\n", "N", 0.97, 0.98)  # fmt: skip
    return LearnedModel(term, make_candidate(data, "LearnedForce", "learned", "force", 0.5))


@pytest.mark.full
def test_which_balance_fails_is_said_drawn_and_tabled():
    ledger = make_ledger()
    html = diagnosis_report(make_diagnosis("identified", ledger=ledger))
    text = checked(html).text
    assert "The base model fails in the force balance and the energy balance." in text
    assert "meets the samples to the noise (mean square error 50.0 → 1.02 noise variances)" in text
    assert "force 75 % 90 % 4.00 N 100 % the balance of mass may be meant as well" in text
    assert "Force: what pulls the load down." in text
    assert "cannot be told apart <here>" in text
    plain = checked(diagnosis_report(make_diagnosis("identified")))
    assert "Which balance fails" not in plain.text
    assert checked(html).tags.count("img") == plain.tags.count("img") + 1
    assert html == diagnosis_report(make_diagnosis("identified", ledger=ledger))


@pytest.mark.parametrize(
    ("balance", "failing", "said"),
    [
        ("force", ("force",), ""),
        ("force", (), ""),
        ("mass", ("force",), ""),  # in this model a force term does the same
        ("energy", ("force",), "The ledger disagrees: a free term in the force balance"),
        ("energy", ("force", "energy"), ""),
        ("sensor", ("force",), "The ledger has no instruments and no stated values"),
    ],
)
def test_a_verdict_says_where_the_ledger_fails_elsewhere(balance, failing, said):
    candidate = make_candidate(make_data(), "Own", "own", balance, 1.0)
    sentence = disagreement((candidate,), make_ledger(failing=failing))
    assert sentence.startswith(said) and bool(sentence) == bool(said)


@pytest.mark.usefixtures("without_pictures")
def test_the_next_run_is_ready_to_make():
    text = checked(diagnosis_report(make_diagnosis("ambiguous", next_experiment=PLAN))).text
    assert "Start from run run-2 Change load.m times 1.5 Set load.m = 3.000 kg" in text
    assert "To tell apart elasticity and end shape" in text
    assert "time [s] u_in [A] p_supply [kPa] 0 0.35 200 0.5 0 200 10 0 200" in text
    assert "each value holds until the next row" in text
    assert "after each is also refitted to this run (chi-square 1250;" in text


def test_the_terminal_gets_the_way_the_place_the_ledger_and_the_next_run():
    lines = diagnosis_text(
        make_diagnosis("ambiguous", ledger=make_ledger(), next_experiment=PLAN)
    ).splitlines()
    assert lines[0] == "Verdict: ambiguous: elasticity and end_shape (StiffWall, RoundEnds)"

    def line(start):
        (only,) = [x.strip() for x in lines if x.strip().startswith(start)]
        return only

    assert line("Step by step: base model ").endswith("(reduced chi-square, holdout runs)")
    assert "→ + StiffWall" in line("Step by step")
    assert (
        "Where the base model is wrong: x, filling, 40 kPa < p < 120 kPa: 71 % of its error in 22 %"
        in str(lines)
    )
    assert "the force balance 75 %, the energy balance 25 %" in line("Ledger of the base model:")
    assert line("Next experiment:").startswith(
        "Next experiment: run run-2, load.m times 1.5; with load.m = 3.000 kg; "
    )
    quiet = diagnosis_text(make_diagnosis("none_missing"))
    assert "Where the base model" not in quiet and "Step by step" not in quiet


@pytest.mark.parametrize("interpolation", ["previous", "linear"])
def test_the_file_of_the_next_run_has_steps_where_inputs_are_held(tmp_path, interpolation):
    write_next_run(tmp_path / "n.csv", replace(PLAN, interpolation=interpolation))
    lines = (tmp_path / "n.csv").read_text().splitlines()
    assert lines[:3] == [
        "# run run-2, load.m times 1.5",
        "# set load.m = 3 kg",
        "time [s],u_in [A],p_supply [kPa]",
    ]
    step = ["0.5,0.35,200"] if interpolation == "previous" else []
    assert lines[3:] == ["0,0.35,200", *step, "0.5,0,200", "10,0,200"]


def test_the_residual_map_is_the_mean_residual_where_the_run_was():
    data = make_data()
    comparison = make_comparison(data, 10.0)
    layer = Layer("base model", comparison, "black")
    mean, x_edges, y_edges = binned_residual(layer, SIGNALS["p"], SIGNALS["p"], SIGNALS["x"])
    assert mean.shape == (14, 14) and len(x_edges) == len(y_edges) == 15
    error = np.concatenate([r.residual("p") for r in comparison.runs]) / SIGNALS["p"].sigma
    model = np.concatenate([r.model["p"] for r in comparison.runs])
    x = np.concatenate([r.model["x"] for r in comparison.runs])
    cell = (model >= x_edges[0]) & (model < x_edges[1]) & (x >= y_edges[0]) & (x < y_edges[1])
    assert cell.any() and mean[0, 0] == pytest.approx(error[cell].mean())
    assert np.isnan(mean[-1, 0])  # never at a low pressure and a large travel
