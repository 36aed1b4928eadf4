"""The rig is independent: it imports nothing of the software, tests and benchmarks, and the software nothing of it."""

import ast
from pathlib import Path

import pytest

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
    [("rig", OUTSIDE), ("pam_cosim", ("rig", "tests", "benchmarks", "examples")), ("benchmarks", ("tests",))],
)
def test_a_package_does_not_import_what_stands_on_it(package: str, barred: tuple[str, ...]) -> None:
    files = sorted((ROOT / package).rglob("*.py"))
    assert len(files) > 15
    assert {
        str(f.relative_to(ROOT)): sorted(imported(f) & set(barred)) for f in files if imported(f) & set(barred)
    } == {}


def test_the_rig_is_no_part_of_the_wheel() -> None:
    import tomllib

    wheel = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]["targets"]["wheel"]
    assert "rig" not in wheel["only-include"]
