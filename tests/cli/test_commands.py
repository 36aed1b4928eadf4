"""Each command does its work: files, numbers and exit status."""

from __future__ import annotations

import csv
import json
import xml.dom.minidom
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from pam_cosim import study
from pam_cosim.fitting import read_parameters
from tests.cli.conftest import Outcome
from tests.fitting.models import TRUE_C_D, TRUE_N
from tests.trajectories import read_trajectory

Command = Callable[..., Outcome]


def done(outcome: Outcome) -> Outcome:
    assert (outcome.status, "Traceback" in outcome.err) == (0, False), outcome.err
    return outcome


def rows(path: Path) -> list[dict[str, str]]:
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def test_build_names_and_platforms(command: Command, place: Path) -> None:
    outcome = done(command("build TankFilling PneumaticMuscle.Benches.VesselOrifice -o out"))
    names = ["out/TankFilling.fmu", "out/VesselOrifice.fmu"]
    assert outcome.out.split() == names
    for name in names:
        with zipfile.ZipFile(place / name) as archive:
            assert archive.testzip() is None
            assert "modelDescription.xml" in archive.namelist()
    assert sorted(p.name for p in place.iterdir()) == ["out"]


def test_build_with_sensitivities(command: Command, place: Path) -> None:
    done(
        command(
            "build VesselOrifice --sensitivity tank.n --sensitivity orifice.C_d -o .",
        )
    )
    outcome = done(command("simulate VesselOrifice.fmu"))
    assert "sensitivity.p.tank.n" in outcome.out and "sensitivity.T.orifice.C_d" in outcome.out
    wrong = command("build VesselOrifice --sensitivity tank.m -o other")
    assert wrong.status == 2 and "tank.m" in wrong.err and not (place / "other").exists()


def test_simulate_default(command: Command, place: Path) -> None:
    """Fills the 2.1 L tank from 207 kPa at 0.35 A over 60 s."""
    outcome = done(command("simulate TankFilling -o t.csv --plot t.png"))
    run = read_trajectory(place / "t.csv")
    assert run.time[0] == 0.0 and run.time[-1] == 60.0
    assert run.units == {"p": "Pa", "T": "K"}
    assert run["p"][0] == 0.0 and run["p"][-1] == pytest.approx(207e3, rel=1e-3)
    assert "p: from 0 kPa to 207 kPa" in outcome.out
    assert (place / "t.png").read_bytes().startswith(b"\x89PNG\r\n")
    assert sorted(p.name for p in place.iterdir()) == ["t.csv", "t.png"]


def test_simulate_with_parameters_and_inputs(command: Command, place: Path) -> None:
    (place / "u.csv").write_text(
        "time [s],u_in [A],u_out [A],p_supply [kPa]\n0,0,0,100\n1,0,0,100\n1,0.3,0,100\n5,0.3,0,100\n"
    )
    done(command("simulate TankFilling --input u.csv --set 'tank.V=0.35 l' -o t.csv"))
    run = read_trajectory(place / "t.csv")
    assert run.time[-1] == 5.0
    before, after = run["p"][run.time <= 1.0], run["p"][run.time > 1.1]
    assert abs(before).max() < 1.0 and after.min() > 1e3 and after.max() < 100e3
    done(command("simulate TankFilling --input u.csv --set 'tank.V=0.7 l' -o s.csv"))
    assert read_trajectory(place / "s.csv")["p"][-1] < 0.8 * run["p"][-1]


def test_simulation_that_breaks_down(command: Command, place: Path) -> None:
    model = Path(__file__).parent / "Divider.mo"
    outcome = command("simulate", model, "--set", "a=-1", "-o", "x.csv")
    assert outcome.status == 1
    assert outcome.err.count("\n") == 1 and "a = -1" in outcome.err and "finite" in outcome.err
    assert list(place.iterdir()) == []


def test_sweep_goes_on_after_a_failure(command: Command, place: Path) -> None:
    model = Path(__file__).parent / "Divider.mo"
    outcome = done(command("sweep", model, "--vary", "a=-1,1,4", "-o", "s.csv"))
    assert "2 of 3 runs done" in outcome.out
    table = rows(place / "s.csv")
    assert list(table[0]) == ["a [1]", "time [s]", "y [1]", "failure"]
    failed = [r for r in table if r["failure"]]
    assert [r["a [1]"] for r in failed] == ["-1.0"] and failed[0]["y [1]"] == ""
    last = {float(r["a [1]"]): float(r["y [1]"]) for r in table if r["time [s]"] == "1.0"}
    assert last[4.0] == pytest.approx(2 * last[1.0], rel=1e-9)


def test_sweep_is_the_grid(command: Command, place: Path) -> None:
    done(
        command(
            "sweep TankFilling --vary 'tank.V=0.35 l:2.1 l:3' "
            "--vary tank.n=1,1.4 --stop-time 1 -o s.csv"
        )
    )
    points = dict.fromkeys(
        (float(r["tank.V [m3]"]), float(r["tank.n [1]"])) for r in rows(place / "s.csv")
    )
    assert [v for v, _ in points] == pytest.approx(
        [0.35e-3, 0.35e-3, 1.225e-3, 1.225e-3, 2.1e-3, 2.1e-3]
    )
    assert [n for _, n in points] == [1.0, 1.4] * 3


def test_compare_params_against_json_report(command: Command, place: Path, data: Path) -> None:
    first = done(command("compare data --json first.json"))
    assert "fit      p" in first.out
    (place / "p.json").write_text(json.dumps({"orifice.C_d": TRUE_C_D, "tank.n": TRUE_N}))
    second = done(
        command(
            "compare data --params p.json --against first.json --json second.json --report r.html"
        )
    )
    one, two = (json.loads((place / n).read_text()) for n in ("first.json", "second.json"))
    assert two["signals"]["p"]["rmse"] == pytest.approx(1000.0, rel=0.05)  # the alternating error
    assert one["signals"]["p"]["rmse"] > 3 * two["signals"]["p"]["rmse"]
    change = 100 * (two["signals"]["p"]["rmse"] / one["signals"]["p"]["rmse"] - 1)
    assert "against first: p rms error" in second.out and f"({change:+.0f} %)" in second.out
    for wrong in ("x", None, -5.0, True):
        one["signals"]["p"]["rmse"] = wrong
        (place / "wrong.json").write_text(json.dumps(one))
        refused = command("compare data --against wrong.json")
        assert refused.status == 2 and "wrong.json: signals.p.rmse is" in refused.err
    for content in (one, two):
        keys = {"rmse", "nrmse", "bias", "max", "correlation", "chi2_reduced", "noise_rmse"}
        assert {"signals", "runs", "where"} <= set(content) and keys <= set(content["signals"]["p"])
    page = (place / "r.html").read_text()
    assert page.lstrip().lower().startswith("<!doctype html") and 'http-equiv="refresh"' not in page
    assert 'src="http' not in page and 'href="http' not in page


def test_fit_writes_parameters_that_compare_reads(
    command: Command, place: Path, data: Path
) -> None:
    outcome = done(command("fit data -o p.json --json f.json"))
    assert "\n  orifice.C_d = 0.8" in outcome.out and " to 0.8" in outcome.out
    values = read_parameters(place / "p.json")
    assert values == pytest.approx({"orifice.C_d": TRUE_C_D, "tank.n": TRUE_N}, rel=0.01)
    fit = json.loads((place / "f.json").read_text())
    assert {"value", "low", "high", "unit"} <= set(fit["parameters"]["tank.n"])
    done(command("compare data --params p.json --json c.json"))
    again = json.loads((place / "c.json").read_text())
    assert again["signals"]["p"]["rmse"] == pytest.approx(
        fit["comparison"]["signals"]["p"]["rmse"], rel=1e-4
    )
    done(command("fit data -o p.ssv"))
    xml.dom.minidom.parse(str(place / "p.ssv"))
    assert read_parameters(place / "p.ssv") == pytest.approx(values)


def test_diagnose_writes_what_the_contract_says(
    command: Command, place: Path, data: Path, workers: int | None
) -> None:
    words = [] if workers is None else ["--workers", workers]
    outcome = done(command("diagnose data --json d.json --report d.html", *words))
    content = json.loads((place / "d.json").read_text())
    assert {"base", "where", "balance", "candidates", "verdict", "next_experiment"} <= set(content)
    assert {"chi2_reduced", "signals"} <= set(content["base"])
    assert set(content["balance"]) <= {"force", "mass", "energy", "sensor"}
    for c in content["candidates"]:
        assert {
            "effect",
            "family",
            "delta_bic",
            "probability",
            "fit",
            "holdout",
            "parameters",
        } <= set(c)
        for p in c["parameters"].values():
            assert {"value", "low", "high", "unit"} <= set(p)
    order = [c["delta_bic"] for c in content["candidates"] if c["delta_bic"] is not None]
    assert order == sorted(order)
    assert content["verdict"]["kind"] == "none_missing"
    assert {"kind", "families", "effects"} <= set(content["verdict"])
    assert outcome.out.startswith("Verdict: none_missing")
    assert (place / "d.html").stat().st_size > 5000


def test_effects_lists_the_catalogue(command: Command) -> None:
    outcome = done(command("effects"))
    for effect in study.effects():
        assert effect.name in outcome.out and effect.family in outcome.out
    assert "gain (0.95 to 1.05)" in outcome.out


def test_effects_shows_one_in_full_and_a_family(command: Command, place: Path) -> None:
    shown = done(command("effects MaxwellCreep --json creep.json")).out
    (creep,) = json.loads((place / "creep.json").read_text())["effects"]
    for line in (
        "tau*der(q) = x - q;",
        "f = k*(x - q);",
        "tau = 2 [s], 0.1 to 10000: Time constant of relaxation; at its minimum: ViscousFriction; "
        "at its maximum: LinearBladder",
        "k = 300 [N/m], 0 to 20000: Stiffness of the Maxwell element; at its minimum: nothing",
        "vanishes at k = 0",
        "Source: Maxwell's element",
        f"has a place in: {', '.join(creep['benches'])}",
    ):
        assert line in shown
    assert "<" not in shown and {"Isotonic", "Isometric"} < set(creep["benches"])
    assert "TankFilling" not in creep["benches"]
    assert creep["parameters"]["tau"]["at_max"] == "LinearBladder" and creep["absent"] == {"k": 0}
    assert creep["fingerprint"].startswith("after a fast change")
    assert "s = 8*x/L0 - 1;" in done(command("effects FlexibleBladder")).out
    gas = done(command("effects EnergyGas")).out  # with what its family shares
    assert "p*V = m*Constants.R*T;" in gas and "h_wall = h;" in gas
    neck = done(command("effects ResonantVolume")).out  # with what it inherits
    assert "p_s*V = m*Constants.R*T_s;" in neck and "G = 1e-08 [kg/(s.Pa)], 1e-10 to" in neck
    ceiling = done(command("effects PositionCeiling")).out
    assert "above all that x shows" in ceiling
    family = done(command("effects creep")).out
    assert "PronyCreep" in family and "LinearBladder" not in family
    said = command("effects MaxwelCreep")
    assert said.status == 2 and "did you mean 'MaxwellCreep'?" in said.err


def test_add_writes_a_model_that_simulates(command: Command, place: Path) -> None:
    outcome = done(command("add EnergyGas OrificeLeak --to TankFilling -o Leaky.mo"))
    text = (place / "Leaky.mo").read_text()
    assert outcome.out == text
    assert (
        text.startswith("model Leaky")
        and "extends" in text
        and "EnergyGas" in text
        and "OrificeLeak" in text
    )
    done(command("simulate Leaky.mo -o leaky.csv"))
    done(command("simulate TankFilling -o plain.csv"))
    leaky, plain = (read_trajectory(place / f"{n}.csv") for n in ("leaky", "plain"))
    # a hole of 5 mm2/1000 against a valve that is fifty times as wide: settles (1/50)^2 / 2 of the supply lower
    assert 20.0 < plain["p"][-1] - leaky["p"][-1] < 500.0
    done(command("build Leaky.mo -o ."))
    assert (place / "Leaky.fmu").exists()


def test_own_process_and_module(process: Callable[..., Outcome], place: Path) -> None:
    outcome = process("simulate VesselOrifice -o", place / "t.csv")
    assert outcome.status == 0, outcome.err
    assert (place / "t.csv").exists()


def test_describe_lists_what_can_be_set_and_kept(command: Command) -> None:
    told = done(command("describe TankFilling")).out
    assert "  p_supply = 207000 [Pa], at least -101000: Gauge pressure of the supply" in told
    assert (
        "  tank.V = 0.0021 [m3], 1e-06 to 10: Volume" in told and "valve.inlet.m_flow" not in told
    )
    assert "  valve.inlet.m_flow [kg/s]" in done(command("describe TankFilling --all")).out


def test_version(command: Command) -> None:
    assert done(command("--version")).out.startswith("pam-cosim 0.")
