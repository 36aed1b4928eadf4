"""The same diagnosis elsewhere gives the same JSON to the byte: other hash seeds, processes, languages and folders."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from pam_cosim import study
from rig.named import effect_of
from rig.short import write_light_data

TRIED = ("elasticity", "creep")  # families: enough for ranking, pairs and a verdict
WAYS = (
    {"PYTHONHASHSEED": "0", "LC_ALL": "C", "TZ": "UTC", "workers": "1"},
    {"PYTHONHASHSEED": "4711", "LC_ALL": "tr_TR.UTF-8", "TZ": "Asia/Tokyo", "workers": "2"},
)


@pytest.mark.full
def test_a_diagnosis_is_the_same_everywhere(tmp_path: Path) -> None:
    recorded = write_light_data(tmp_path / "a", [effect_of("elasticity:linear")], 1)
    families = {effect.family for effect in study.effects()} | {"wrong_parameter"}
    excluded = [word for family in sorted(families - set(TRIED)) for word in ("--exclude", family)]
    told = []
    for number, way in enumerate(WAYS):
        folder = tmp_path / f"{number}" / "other place"
        shutil.copytree(recorded, folder)
        words = [
            "diagnose",
            str(folder),
            "--json",
            str(tmp_path / f"{number}.json"),
            "--workers",
            way["workers"],
        ]
        environment = os.environ | {key: value for key, value in way.items() if key != "workers"}
        command = [sys.executable, "-m", "pam_cosim", *words, *excluded]
        made = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=folder)
        assert made.returncode == 0, made.stderr
        told.append((tmp_path / f"{number}.json").read_bytes())
    assert b"other place" not in told[0] and b'"candidates"' in told[0]
    assert told[0] == told[1]
