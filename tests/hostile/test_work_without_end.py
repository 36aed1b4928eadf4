"""A model that chatters is legal and never done: its runs end after a while, with a sentence, and the others go on."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from pam_cosim import study
from pam_cosim.cli.app import main
from pam_cosim.errors import InputError
from pam_cosim.simulation.models import opened
from pam_cosim.simulation.simulator import LONGEST_RUN

CHATTERING = """model Chatter "Changes its mind k times a second"
  parameter Real k = 1e7;
  Real x(start = 0, fixed = true);
  output Real y = x;
equation
  der(x) = if sin(k*time) > 0 then 1 else -1;
end Chatter;
"""
LIMIT = 0.5  # s
LONG = ["--stop-time", "100", "--interval", "0.01", "--timeout", str(LIMIT)]
REASON = "the run takes longer than it may, 0.5 s of processor time"


@pytest.fixture
def model(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "Chatter.mo").write_text(CHATTERING)
    return "Chatter.mo"


def test_a_run_says_how_far_it_came_and_what_to_do(
    model: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    study.build(model)
    before = time.process_time()
    assert main(["simulate", model, *LONG, "-o", "x.csv"]) == 1
    assert time.process_time() - before < 60 * LIMIT  # the whole run takes hours
    said = capfd.readouterr().err
    assert said.count("\n") == 1 and f"pam-cosim: the simulation failed: {REASON}" in said
    assert "(--timeout)" in said and "(simulated up to " in said
    assert [p.name for p in tmp_path.iterdir()] == ["Chatter.mo"]


@pytest.mark.full
def test_a_sweep_goes_on(model: str, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["sweep", model, "--vary", "k=1,1e7,2", *LONG, "-o", "x.csv"]) == 0
    out, err = capfd.readouterr()
    assert "2 of 3 runs done" in out and REASON in err


def test_every_run_has_a_limit(model: str) -> None:
    with opened(model) as simulator:
        assert simulator.limit == LONGEST_RUN
    with (
        pytest.raises(InputError, match="a time limit must be larger than zero"),
        opened(model, timeout=-1.0),
    ):
        pass
