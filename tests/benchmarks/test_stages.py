"""Every stage that the benchmark switches off is there, and a diagnosis says which of them did something."""

from __future__ import annotations

import subprocess
import sys

PROGRAM = """
from benchmarks.hidden_effects import stages
from pam_cosim.diagnosis.judgement import evidence

active = stages.note()
stages.leave_out(stages.STAGES)
assert not active and not evidence._may_be_drift(None)
"""


def test_stages_can_be_watched_and_left_out() -> None:
    subprocess.run([sys.executable, "-c", PROGRAM], check=True)
