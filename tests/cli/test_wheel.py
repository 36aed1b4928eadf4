"""A wheel carries all it needs: library, C runtime and templates; it works without the repository."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import venv
import zipfile
from io import StringIO
from pathlib import Path

import numpy as np
import pytest
from hatchling.builders.wheel import WheelBuilder

from rig import measurement
from rig.named import effect_of
from rig.plan import default_plan

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
    for folder, pattern in (
        ("modelica", "*.mo"),
        ("modelica", "package.order"),
        ("fmu", "*.c"),
        ("fmu", "*.h"),
    ):
        files = sorted((ROOT / folder).rglob(pattern))
        assert files
        for file in files:
            if "build" not in file.relative_to(ROOT).parts:
                assert f"{inside}/{file.relative_to(ROOT).as_posix()}" in held
    for file in (ROOT / "examples" / "hidden-spring").iterdir():
        assert f"{inside}/demo/{file.name}" in held
    for file in (ROOT / "pam_cosim").rglob("*"):
        if file.is_file() and "__pycache__" not in file.parts:
            assert file.relative_to(ROOT).as_posix() in held
    assert not [
        n for n in held if n.endswith((".fmu", ".so", ".o", ".pyc")) or n.startswith("tests/")
    ]
    assert any(n.endswith("entry_points.txt") for n in held)
    assert "pam_cosim/py.typed" in held, "type checkers take the annotations only with it (PEP 561)"


@pytest.mark.full
def test_works_from_elsewhere(wheel: Path, tmp_path: Path) -> None:
    """Unpacked, from another folder, with a cache of its own: the catalogue, and a run that compiles a model."""
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "site")
    work = tmp_path / "work"
    work.mkdir()
    environment = {
        **os.environ,
        "PYTHONPATH": str(tmp_path / "site"),
        "PAM_COSIM_CACHE": str(tmp_path / "cache"),
    }

    def run(*words: str) -> str:
        start = (
            "import sys, pam_cosim; from pam_cosim.cli.process import run; "
            "print(pam_cosim.__file__, file=sys.stderr); run()"
        )
        completed = subprocess.run(
            [sys.executable, "-c", start, *words],
            cwd=work,
            env=environment,
            capture_output=True,
            text=True,
        )
        assert completed.returncode == 0, completed.stderr
        assert str(tmp_path / "site") in completed.stderr
        return completed.stdout

    assert "EnergyGas" in run("effects")
    assert "p: from 0 kPa to 207 kPa" in run("simulate", "TankFilling", "-o", "t.csv")
    assert (work / "t.csv").exists()
    assert list((tmp_path / "cache").rglob("*.fmu"))


@pytest.fixture
def installed(wheel: Path, tmp_path: Path) -> Path:
    """The wheel in a new environment that has its dependencies from this one, but nothing of the repository."""
    home = tmp_path / "environment"
    venv.create(home, with_pip=False)
    scripts = home / ("Scripts" if os.name == "nt" else "bin")
    python = scripts / ("python.exe" if os.name == "nt" else "python")
    where = "import sysconfig; print(sysconfig.get_paths()['purelib'])"
    here, there = (
        subprocess.run(
            [one, "-c", where], capture_output=True, text=True, check=True
        ).stdout.strip()
        for one in (sys.executable, python)
    )
    Path(there, "dependencies.pth").write_text(
        f"{here}\n", encoding="utf-8"
    )  # that folder's .pth files are not read
    command = [
        sys.executable,
        "-m",
        "pip",
        "--python",
        str(python),
        "install",
        "--quiet",
        "--no-deps",
        "--no-index",
    ]
    subprocess.run([*command, str(wheel)], check=True, cwd=tmp_path)
    return scripts


def without_repository(tmp_path: Path) -> dict[str, str]:
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return kept | {"PAM_COSIM_CACHE": str(tmp_path / "cache")}


@pytest.mark.full
def test_demo_of_an_installed_wheel(installed: Path, tmp_path: Path) -> None:
    work = tmp_path / "work"
    work.mkdir()

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        words = (str(installed / words[0]), *words[1:])
        return subprocess.run(
            words, cwd=work, env=without_repository(tmp_path), capture_output=True, text=True
        )

    lies = run("python", "-c", "import pam_cosim; print(pam_cosim.__file__)").stdout
    assert lies.startswith(str(tmp_path / "environment"))
    assert run("python", "-c", "import rig").returncode != 0, "the repository is on the path"
    shown = run("pam-cosim", "demo", "shown", "--workers", "1")
    assert shown.returncode == 0, shown.stderr
    page, numbers = (
        work / "shown" / "report.html",
        json.loads((work / "shown" / "report.json").read_text()),
    )
    assert numbers["verdict"]["kind"] == "identified" and numbers["verdict"]["families"] == [
        "elasticity"
    ]
    best = next(c for c in numbers["candidates"] if c["effects"] == numbers["verdict"]["effects"])
    held_out = [c["holdout"]["signals"]["x"]["rmse"] for c in (numbers["base"], best)]
    assert held_out[0] > 5 * held_out[1]
    assert "<html" in page.read_text(encoding="utf-8")[:200]
    for file in ("report.html", "report.png", "report.json", "Better.mo", "data"):
        assert (work / "shown" / file).exists() and str(Path("shown", file)) in shown.stdout
    assert run("pam-cosim", "compare", "shown/data").returncode == 0, (
        "the recordings are a data set like any other"
    )


@pytest.mark.full
def test_demonstration_data_are_the_rigs(tmp_path: Path) -> None:
    """A spring law that no effect of the catalogue has, hidden in the simulated rig."""
    hidden = effect_of("elasticity:exponential")
    title = "Six runs of a muscle on the simulated rig"
    measurement.write_data_set(
        tmp_path, measurement.measure(default_plan(), [hidden], seed=1), title=title
    )
    for file in (ROOT / "examples" / "hidden-spring").iterdir():
        kept, made = file.read_text(), (tmp_path / file.name).read_text()
        if file.suffix == ".csv":  # last digits are those of a processor
            assert kept.splitlines()[0] == made.splitlines()[0]
            numbers = [
                np.genfromtxt(StringIO(t), delimiter=",", skip_header=1) for t in (kept, made)
            ]
            np.testing.assert_allclose(numbers[1], numbers[0], rtol=1e-6, atol=1e-5)
        else:
            assert kept == made, file.name
