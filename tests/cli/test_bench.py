"""The command ``bench``: what it writes is read, run and compared like any other bench."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from tests.cli.conftest import Outcome, everything
from tests.cli.test_commands import done
from tests.documentation.pages import blocks, commands

PAGE = "benches.md#From a set point to a comparison"

WINDER = """\
model Winder "A drum that the muscle turns against a weight"
  extends PneumaticMuscle.Interfaces.Mechanics(shows="x", final F_start=m*9.80665);
  extends PneumaticMuscle.Icons.Load;
  PneumaticMuscle.Interfaces.Flange flange "Load end of the muscle";
  parameter PneumaticMuscle.Types.Mass m(min=0.1, max=10) = 2 "Weight";
  parameter PneumaticMuscle.Types.Mass drum(min=0, max=10) = 0.5 "Inertia of the drum at its rim";
  PneumaticMuscle.Types.Length s(start=x_start, fixed=true) "Position";
  PneumaticMuscle.Types.Velocity v(start=0, fixed=true) "Speed";
equation
  flange.s = s;
  v = der(s);
  (m + drum)*der(v) = flange.f - m*9.80665;
end Winder;
"""
SHORT = """\
model Short "A muscle of 10 cm"
  extends PneumaticMuscle.Muscles.Physical(L0=0.1, turns=0.8);
end Short;
"""


def test_it_lists_the_parts(command: Callable[..., Outcome], place: Path) -> None:
    (place / "Winder.mo").write_text(WINDER)
    said = done(command("bench --list")).out
    assert all(
        name in said
        for name in ("imposed-pressure", "hanging-load", "physical (usual)", "p_set", "droop")
    )
    assert "winder" not in said
    assert "winder" in done(command("bench --list --file Winder.mo")).out


def test_the_written_bench_is_simulated(command: Callable[..., Outcome], place: Path) -> None:
    words = (
        "--pneumatics",
        "regulator",
        "--mechanics",
        "spring",
        "--measure",
        "p,x",
        "-o",
        "MyRig.mo",
    )
    written = done(command("bench", *words))
    text = (place / "MyRig.mo").read_text()
    assert (
        written.out
        == text
        == pam.bench("regulator", "spring", measure=["p", "x"], output=place / "Again.mo").replace(
            "Again", "MyRig"
        )
    )
    assert text.startswith('model MyRig "') and "connect(muscle.port, regulator.port)\n" in text
    said = done(command("simulate MyRig.mo --set 'p_set=300 kPa' --set 'spring.k=3 N/mm'")).out
    assert re.search(r"x: from .* at the end 4\d\.\d mm", said)
    assert "LinearBladder" in done(command("add LinearBladder --to MyRig.mo -o Better.mo")).out


def test_a_part_of_ones_own_is_a_choice(command: Callable[..., Outcome], place: Path) -> None:
    (place / "Winder.mo").write_text(WINDER)
    (place / "Short.mo").write_text(SHORT)
    own = ("--file", "Winder.mo", "--file", "Short.mo")
    words = (
        "--pneumatics",
        "imposed-pressure",
        "--mechanics",
        "winder",
        "--muscle",
        "short",
        "-o",
        "Mine.mo",
    )
    written = done(command("bench", *words, *own))
    assert "--file Winder.mo --file Short.mo" in written.err
    run = pam.simulate(
        "Mine.mo", {"p": "200 kPa"}, files=["Winder.mo", "Short.mo"], outputs=["muscle.L0"]
    )
    assert run["muscle.L0"][0] == 0.1 and 0.01 < run["x"][-1] < 0.035


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--mechanics", "spring", "-o", "R.mo"), "a bench needs --pneumatics"),
        (("--pneumatics", "regulator", "--mechanics", "spring"), "a bench needs -o FILE.mo"),
        (("--list", "-o", "R.mo"), "--list prints the parts and writes no bench"),
        (("--list", "--static"), "--list prints the parts and writes no bench"),
        (("--pneumatics", "regulator", "--mechanics", "spring", "-o", "R.txt"), "ends in .mo"),
        (
            ("--pneumatics", "regulater", "--mechanics", "spring", "-o", "R.mo"),
            "did you mean 'regulator'",
        ),
        (
            ("--pneumatics", "regulator", "--mechanics", "spring", "--measure", "y", "-o", "R.mo"),
            "no signal 'y'",
        ),
        (
            (
                "--pneumatics",
                "imposed-pressure",
                "--mechanics",
                "spring",
                "--measure",
                "p",
                "-o",
                "R.mo",
            ),
            "is imposed",
        ),
    ],
)
def test_a_bad_choice_writes_nothing(
    command: Callable[..., Outcome], place: Path, words: tuple[str, ...], said: str
) -> None:
    outcome = command("bench", *words)
    assert outcome.status == 2 and said in outcome.err and outcome.err.count("\n") == 1
    assert everything(place) == []


def test_the_page_as_it_stands(command: Callable[..., Outcome], place: Path) -> None:
    """From a set point in a CSV file to a comparison; the measurement is of an independent static balance."""
    (toml,) = blocks(PAGE, "toml")
    folder = place / "my-rig"
    folder.mkdir()
    (folder / "experiment.toml").write_text(toml)
    (folder / "steps.csv").write_text(steps())
    ran = [done(command(*words[1:])).out for words in commands(PAGE)]
    assert len(ran) >= 3 and "x" in ran[-1]
    score = pam.compare(pam.read(folder))
    assert "p" in str(score) and (folder / "MyRig.mo").is_file()


def steps() -> str:
    """Set point, pressure behind a lag, and the contraction of a muscle that stretches a spring, slowly, with noise."""
    time = np.arange(0, 20, 0.05)
    target = 50e3 * (1 + np.minimum(time // 5, 3))
    p = np.zeros_like(time)
    for i in range(1, time.size):
        p[i] = p[i - 1] + (target[i - 1] - p[i - 1]) * (1 - np.exp(-0.05 / 0.15))
    length, turns = 0.24, 2.0
    fibre = length**2 + (turns * np.pi * 0.02) ** 2
    x = np.zeros_like(time)
    for _ in range(200):
        force = p * (3 * (length - x) ** 2 - fibre) / (4 * np.pi * turns**2)
        x += 0.05 * ((force - 5) / 3000 - x)
    noise = np.random.default_rng(1).standard_normal((2, time.size))
    rows = zip(
        time,
        target / 1e3,
        (p + 500 * noise[0]) / 1e3,
        (np.maximum(x, 0) + 2e-4 * noise[1]) * 1e3,
        strict=True,
    )
    return "\n".join(
        [
            "time [s],p_set [kPa],p [kPa],x [mm]",
            *(",".join(f"{v:.4f}" for v in row) for row in rows),
            "",
        ]
    )
