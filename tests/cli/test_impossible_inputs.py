"""What a bench does not allow of an input is refused where it was recorded, too."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from pam_cosim import study
from tests.cli.conftest import Outcome

Command = Callable[..., Outcome]
EXPERIMENT = """\
title = "a muscle held at a length"
model = "QuasiStaticIsometric"
[signals.F]
sigma = "1 N"
[parameters]
branch = 1
x = "0 mm"
[[runs]]
file = "one.csv"
role = "fit"
"""


def data_set(place: Path, sign: float, dip: float = 0.0) -> Path:
    folder = place / "rig"
    folder.mkdir()
    (folder / "experiment.toml").write_text(EXPERIMENT)
    rows = [f"{t},{sign * 50 * t},{20 * t}" for t in range(6)]
    (folder / "one.csv").write_text("\n".join(["time [s],p [kPa],F [N]", f"-1,{dip},0", *rows, ""]))
    return folder


@pytest.mark.parametrize("verb", ["compare", "fit"])
def test_a_pressure_below_a_vacuum_is_refused(command: Command, place: Path, verb: str) -> None:
    outcome = command(verb, data_set(place, -1.0))
    assert outcome.status == 2
    assert "one.csv: p is -150 kPa at 3 s of one, below the least value -101 kPa" in outcome.err
    assert "check the sign, the unit and the zero" in outcome.err


@pytest.mark.parametrize("source", ["one.csv", "p = -150e3"])
def test_inputs_of_a_single_run_are_refused_alike(
    command: Command, place: Path, source: str
) -> None:
    (place / "one.csv").write_text("time [s],p [kPa]\n0,100\n3,-150\n")
    outcome = command(
        "simulate QuasiStaticIsometric --input", source, "--stop-time", "5", "-o", "o.csv"
    )
    assert outcome.status == 2 and "p is -150 kPa at " in outcome.err
    assert "below the least value -101 kPa that the model allows" in outcome.err
    assert ("one.csv: " in outcome.err) is (source == "one.csv")
    assert not (place / "o.csv").exists()


def test_noise_at_the_limit_is_not(place: Path) -> None:
    (run,) = study.read(data_set(place, 1.0, dip=-103.0)).runs
    assert run.inputs["p"][0] == -103e3
