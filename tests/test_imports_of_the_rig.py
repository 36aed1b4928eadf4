"""The rig is independent: it imports nothing of the software, tests and benchmarks, and the software nothing of it."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from hatchling.builders.wheel import WheelBuilder

ROOT = Path(__file__).parents[1]
OUTSIDE = ("pam_cosim", "tests", "benchmarks", "examples", "scripts")


def imported(file: Path) -> set[str]:
    """The top-level packages that a module imports."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add((node.module or "rig").partition(".")[0])
    return names


@pytest.mark.parametrize(
    ("package", "barred"),
    [
        ("refsim", OUTSIDE),
        ("pam_cosim", ("rig", "blind_cases", "strangers", "tests", "benchmarks", "examples")),
        ("benchmarks", ("tests",)),
    ],
)
def test_a_package_does_not_import_what_stands_on_it(package: str, barred: tuple[str, ...]) -> None:
    files = sorted((ROOT / package).rglob("*.py"))
    assert len(files) > 15
    assert {
        str(f.relative_to(ROOT)): sorted(imported(f) & set(barred))
        for f in files
        if imported(f) & set(barred)
    } == {}


def test_the_rig_is_no_part_of_the_wheel() -> None:
    import tomllib

    wheel = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"][
        "targets"
    ]["wheel"]
    assert not {"rig", "refsim"} & set(wheel["only-include"])


@pytest.mark.full
def test_the_rig_is_a_distribution_of_its_own(tmp_path: Path) -> None:
    """Its wheel makes data in an empty folder, with nothing of the checkout but what the wheel holds."""
    (wheel,) = WheelBuilder(str(ROOT / "refsim")).build(
        directory=str(tmp_path), versions=["standard"]
    )
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        archive.extractall(tmp_path / "site")
    modules = {
        file.relative_to(ROOT / "refsim").as_posix() for file in (ROOT / "refsim").rglob("*.py")
    }
    assert modules | {"rig/effect_sizes.json"} == {
        name for name in names if ".dist-info/" not in name
    }
    words = [sys.executable, "-m", "rig.short", "data", "--effect", "elasticity:linear"]
    environment = {**os.environ, "PYTHONPATH": str(tmp_path / "site")}
    subprocess.run(words, cwd=tmp_path, env=environment, check=True, capture_output=True)
    assert (tmp_path / "data" / "experiment.toml").exists()
