"""Counts and ends beyond reason are refused in one sentence, before any work."""

from __future__ import annotations

import math
import time
from pathlib import Path

import pytest

from pam_cosim.cli.app import main
from pam_cosim.counts import LONGEST, checked_time, checked_workers
from pam_cosim.errors import InputError
from tests.hostile.reading import make

SWEEP = [
    "sweep",
    "TankFilling",
    "--vary",
    "tank.V=1e-3:2e-3",
    "--design",
    "random",
    "-o",
    "out.csv",
]
WORDS = {
    "a sweep with -1 workers": [*SWEEP, "--runs", "2", "--workers", "-1"],
    "a sweep with 100000 workers": [*SWEEP, "--runs", "2", "--workers", "100000"],


    "a sweep with a seed of 30 digits": [*SWEEP, "--runs", "2", "--seed", "9" * 30],
    "a sweep of 1e12 runs": [*SWEEP, "--runs", "1000000000000"],

    "a sweep of 1e8 runs": ["sweep", "TankFilling", "--vary=u_in=0:1:9999", "--vary=u_out=0:1:9999", "-oo.csv"],
    "a fit with 1e9 starts": ["fit", "data", "--method", "multi-start", "--starts", "1000000000"],


    "a diagnosis with 100000 workers": ["diagnose", "data", "--workers", "100000"],
    "a diagnosis for no time": ["diagnose", "data", "--time-limit", "0 s"],

    "a run to 1e300 s": ["simulate", "TankFilling", "--stop-time", "1e300"],

    "a run in steps of 1e-300 s": ["simulate", "TankFilling", "--interval", "1e-300"],


    "a port of a million": ["workbench", "data", "--port", "1000000", "--no-browser"],
    "1e9 samples": ["predict", "data", "--samples", "1000000000", "--stop-time", "1"],
    "1e12 frequencies": ["bode", "TankFilling", "--by", "u_in", "--amplitude", "20 mA", "--frequencies",
                         "1:2:1000000000000"],
}  # fmt: skip


@pytest.mark.parametrize("words", WORDS.values(), ids=WORDS.keys())
def test_what_nobody_means_is_refused(
    words: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    make(tmp_path / "data", {})
    before = time.process_time()
    assert main(words) == 2
    said = capfd.readouterr().err
    assert "Traceback" not in said and 20 < len(said) < 1000, said
    assert [p.name for p in tmp_path.iterdir()] == ["data"]
    assert time.process_time() - before < 30  # what was asked for would take hours


def test_a_limit_that_is_none() -> None:
    assert checked_time(1e308) == math.inf and checked_time(LONGEST) == LONGEST
    assert checked_workers(None) is None and checked_workers(0) == 0
    with pytest.raises(InputError, match="larger than zero"):
        checked_time(math.nan)
    with pytest.raises(InputError, match="whole number from 0"):
        checked_workers(True)
