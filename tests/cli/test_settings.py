"""Inputs held constant are set and varied wherever parameters are; an FMU can be one file; help says what it says."""

from __future__ import annotations

import zipfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import typer

import pam_cosim as pam
from pam_cosim.cli.app import app
from pam_cosim.simulation import IsolatedSimulator, Simulator
from tests.cli.conftest import Outcome, everything
from tests.cli.test_bad_input import refused
from tests.cli.test_commands import done, rows
from tests.fmu import models
from tests.trajectories import read_trajectory

Command = Callable[..., Outcome]
BENCH = "TankFilling"


def over_time(values: dict[str, float]) -> pam.Inputs:
    return pam.Inputs([0.0, 60.0], {name: [value, value] for name, value in values.items()})


def test_the_sweep_that_a_newcomer_tries(command: Command, place: Path) -> None:
    words = ["--vary", "u_in=0.2:0.35:4", "--vary", "p_supply=138e3,207e3"]
    outcome = done(command("sweep", BENCH, *words, "--stop-time", "5", "-o", "s.csv"))
    assert "8 of 8 runs done" in outcome.out
    lines = rows(place / "s.csv")
    assert list(lines[0]) == ["u_in [A]", "p_supply [Pa]", "time [s]", "p [Pa]", "T [K]", "failure"]
    points = dict.fromkeys((float(r["u_in [A]"]), float(r["p_supply [Pa]"])) for r in lines)
    assert list(points) == [
        (pytest.approx(u), p) for u in (0.2, 0.25, 0.3, 0.35) for p in (138e3, 207e3)
    ]
    # each run is the one that inputs over time with the same values give
    for u, p in [(0.25, 138e3), (0.35, 207e3)]:
        want = pam.simulate(BENCH, inputs=over_time({"u_in": u, "p_supply": p}), stop_time=5.0)
        own = [
            float(r["p [Pa]"])
            for r in lines
            if r["u_in [A]"] == repr(u) and r["p_supply [Pa]"] == repr(p)
        ]
        assert own == want["p"].tolist()


def test_set_with_a_unit(command: Command, place: Path) -> None:
    outcome = done(
        command(
            "simulate", BENCH, "--set", "p_supply=138 kPa", "--set", "tank.V=0.35 l", "-o", "t.csv"
        )
    )
    assert "p: from 0 kPa to 138 kPa" in outcome.out
    done(
        command(
            "simulate", BENCH, "--set", "p_supply=138e3", "--set", "tank.V=0.35e-3", "-o", "s.csv"
        )
    )
    text, number = (read_trajectory(place / name)["p"] for name in ("t.csv", "s.csv"))
    assert text == pytest.approx(number, rel=1e-9)


@pytest.mark.parametrize("own", [True, False], ids=["ours", "isolated"])
def test_an_fmu_takes_them_alike(own: bool) -> None:
    fmu = models.fmu(models.lag, "3.0")
    opened = Simulator(fmu) if own else IsolatedSimulator(fmu)
    times = np.linspace(0.0, 2.0, 5)
    with opened as simulator:
        moved = simulator.run(times, inputs=pam.Inputs([0.0, 2.0], {"u": [0.0, 2.0]}))["y"]
        held = simulator.run(times, parameters={"u": 2.0}, tolerance=1e-9)["y"]
        again = simulator.run(times, inputs=pam.Inputs([0.0, 2.0], {"u": [0.0, 2.0]}))["y"]
    assert held == pytest.approx(2.0 * (1.0 - np.exp(-times / 0.5)), abs=1e-6)
    assert moved.tolist() == again.tolist()  # nothing of one run is left in the next


@pytest.mark.parametrize(
    ("words", "message"),
    [

        (["sweep", BENCH, "--vary", "u_inn=1,2", "-o", "s.csv"], ["u_inn", "did you mean 'u_in'?"]),
        (["simulate", BENCH, "--set", "p_supply=2 kg"], ["p_supply=2 kg", "kPa"]),
        (["simulate", BENCH, "--set", "p=1"], ["'p' is an output"]),
        (["simulate", BENCH, "--set", "u_in=0.1", "--set", "u_in=0.2"], ["'u_in' is given twice"]),
        (["simulate", BENCH, "--set", "u_in=0.1", "--input", "u.csv"], ["'u_in' is given over time and as a constant"]),
        (["sweep", BENCH, "--vary", "u_in=0.1,0.2", "--input", "u.csv", "-o", "s.csv"],
         ["'u_in' is given over time and varied"]),

        (["sweep", BENCH, "--vary", "p_supply=138,207 kPa", "-o", "s.csv"], ["p_supply=138,207 kPa", "each of them"]),

        (["sweep", BENCH, "--vary", "u_in=0.1,0.2", "--scalar", "u_in=max(T)", "-o", "s.csv"], ["'u_in'", "is varied"]),
        (["sweep", BENCH, "--vary", "u_in=0.1,0.2", "--scalar", "failure=max(T)", "-o", "s.csv"], ["'failure'"]),

        (["build", "TankFilling", "Isotonic", "-o", "One.fmu"], ["One.fmu", "2 models"]),
        (["build", "-o", "All.fmu"], ["All.fmu", "models"]),
        (["build", "TankFilling", "My.TankFilling", "-o", "out"], ["TankFilling.fmu"]),
    ],
    ids=lambda v: " ".join(v) if isinstance(v, list) else None,
)  # fmt: skip
def test_what_cannot_be_set(
    command: Command, place: Path, words: list[str], message: list[str]
) -> None:
    (place / "u.csv").write_text("time [s],u_in [A]\n0,0\n5,0.3\n")
    before = everything(place)
    refused(command(*words), message)
    assert everything(place) == before


# --- the same in a data set: an input that was held and not recorded


# --- build -o


def test_a_name_that_ends_in_fmu_is_a_file(command: Command, place: Path) -> None:
    outcome = done(command("build VesselOrifice -o sub/Mine.fmu"))
    assert outcome.out.split() == ["sub/Mine.fmu"]
    assert [p.name for p in (place / "sub").iterdir()] == ["Mine.fmu"] and zipfile.is_zipfile(
        place / "sub/Mine.fmu"
    )
    done(command("build VesselOrifice -o sub"))
    assert sorted(p.name for p in (place / "sub").iterdir()) == ["Mine.fmu", "VesselOrifice.fmu"]


# --- help

COMMANDS = typer.main.get_command(app).commands  # type: ignore[attr-defined]


@pytest.mark.parametrize("name", COMMANDS)
def test_help_lists_the_declared_settings(
    command: Command, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "100")
    said = "".join(done(command(name, "--help")).out.split())
    declared = [COMMANDS[name].help, *(p.help for p in COMMANDS[name].params if not p.hidden)]
    assert len(declared) > 1
    for text in declared:
        assert text and "".join(text.split()) in said, text
