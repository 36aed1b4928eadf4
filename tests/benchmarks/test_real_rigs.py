"""What is fetched from others becomes data sets; a file that is not the one that was used is refused."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from benchmarks.real_rigs import at_hand, hoses, sources
from benchmarks.real_rigs.fluidic import LEAK, free_course
from benchmarks.real_rigs.folders import read_columns, write_rig

LOG = b"""=~=~= PuTTY log =~=~=
12, 0.1, 0.1, 903, 306
0, 0.0, 0.01, 903, 306
27, 1.0, 0.2, 903, 306
146278, 0.056012, 03, 0.019355, 0.007136, 904, 306
40, 1.5, 0.6, 903, 306
80, 2.0, 1.6, 903, 306
1, 0.0, 0.03, 903, 306
29, 1.2, 0.4, 903, 306
42, 1.7, 0.8, 903, 306
82, 2.0, 1.8, 903, 306
0, 0.0, 0.0, 903, 306
"""


def test_a_log_is_divided_into_whole_passes_without_garbled_lines():
    parts = hoses.passes(LOG)
    assert [len(p) for p in parts] == [4, 4]
    assert parts[0][:, 0] == pytest.approx([0, 0.027, 0.040, 0.080])
    assert parts[1][-1, 1:] == pytest.approx([2.0, 1.8])


def test_passes_are_pooled_into_means_of_time_and_pressure():
    table = hoses.pooled(hoses.passes(LOG))
    assert table[:, 0] == pytest.approx([0.0005, 0.028, 0.041, 0.081])
    assert table[:, 2] == pytest.approx([0.02, 0.3, 0.7, 1.7])


def test_a_free_course_is_fitted_down_to_a_part_and_scored_below_it(tmp_path: Path):
    time = np.linspace(0, 100, 201)
    rig = free_course("leak", "a leak", time, 600 * np.exp(-time / 50), LEAK)
    write_rig(tmp_path, rig)
    described = json.loads((tmp_path / "leak" / "rig.json").read_text())
    first = read_columns(tmp_path / "leak" / "fitted" / "first.csv")
    assert first["p"].min() >= 450 > described["runs"]["outside"]["whole"] > 10
    assert described["runs"]["outside"]["whole"] == pytest.approx(50 * np.log(4 / 3), abs=0.5)
    assert pam.read(tmp_path / "leak" / "outside").runs[0].measurements["p"].min() < 100e3


def test_the_rigs_at_hand_are_data_sets_that_can_be_read(tmp_path: Path):
    for rig in (at_hand.robot(), at_hand.vessel(), at_hand.chamber(), at_hand.printed_map()):
        write_rig(tmp_path, rig)
        for role in rig.runs:
            assert len(pam.read(tmp_path / rig.name / role).runs) >= 1


def test_a_file_that_is_not_the_one_that_was_used_is_refused(tmp_path: Path):
    def git(*arguments: str) -> str:
        done = subprocess.run(
            ["git", "-C", str(tmp_path / "o+n"), *arguments], capture_output=True, check=True
        )
        return done.stdout.decode().strip()

    (tmp_path / "o+n").mkdir()
    git("init", "--quiet")
    (tmp_path / "o+n" / "a.csv").write_text("1\n")
    git("add", "a.csv")
    git("-c", "user.name=t", "-c", "user.email=t@t", "commit", "--quiet", "-m", "x")
    source = sources.Source("o", "n", git("rev-parse", "HEAD"), "none")
    store = sources.opened(source, tmp_path, tmp_path)
    assert store.paths(".") == ["a.csv"]
    with pytest.raises(sources.FetchError, match=r"o\+n/a.csv: SHA-256 is"):
        store.read("a.csv")
    with pytest.raises(sources.FetchError, match="no git directory"):
        sources.opened(source, tmp_path, tmp_path / "elsewhere")
