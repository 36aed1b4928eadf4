"""A wheel carries all it needs: library, C runtime and templates; it works without the repository."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from hatchling.builders.wheel import WheelBuilder

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built as a build front end would."""
    folder = tmp_path_factory.mktemp("wheel")
    (built,) = WheelBuilder(str(ROOT)).build(directory=str(folder), versions=["standard"])
    return Path(built)


def test_contents(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        held = dict.fromkeys(archive.namelist())
    inside = "pam_cosim/_resources"
    for folder, pattern in (("modelica", "*.mo"), ("modelica", "package.order"), ("fmu", "*.c"), ("fmu", "*.h")):
        files = sorted((ROOT / folder).rglob(pattern))
        assert files
        for file in files:
            if "build" not in file.relative_to(ROOT).parts:
                assert f"{inside}/{file.relative_to(ROOT).as_posix()}" in held
    for file in (ROOT / "pam_cosim").rglob("*"):
        if file.is_file() and "__pycache__" not in file.parts:
            assert file.relative_to(ROOT).as_posix() in held
    assert not [n for n in held if n.endswith((".fmu", ".so", ".o", ".pyc")) or n.startswith("tests/")]
    assert any(n.endswith("entry_points.txt") for n in held)
    assert "pam_cosim/py.typed" in held, "type checkers take the annotations only with it (PEP 561)"


def test_metadata(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        [name] = [n for n in archive.namelist() if n.endswith(".dist-info/METADATA")]
        lines = archive.read(name).decode().splitlines()
    assert "License-Expression: MIT" in lines
    assert {"Classifier: Typing :: Typed", "Provides-Extra: docs"} <= set(lines)


@pytest.mark.full
def test_works_from_elsewhere(wheel: Path, tmp_path: Path) -> None:
    """Unpacked, from another folder, with a cache of its own: the catalogue, and a run that compiles a model."""
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "site")
    work = tmp_path / "work"
    work.mkdir()
    environment = {**os.environ, "PYTHONPATH": str(tmp_path / "site"), "PAM_COSIM_CACHE": str(tmp_path / "cache")}

    def run(*words: str) -> str:
        start = (
            "import sys, pam_cosim; from pam_cosim.cli.process import run; "
            "print(pam_cosim.__file__, file=sys.stderr); run()"
        )
        completed = subprocess.run(
            [sys.executable, "-c", start, *words], cwd=work, env=environment, capture_output=True, text=True
        )
        assert completed.returncode == 0, completed.stderr
        assert str(tmp_path / "site") in completed.stderr
        return completed.stdout

    assert "EnergyGas" in run("effects")
    assert "p: from 0 kPa to 207 kPa" in run("simulate", "TankFilling", "-o", "t.csv")
    assert (work / "t.csv").exists()
    assert list((tmp_path / "cache").rglob("*.fmu"))
