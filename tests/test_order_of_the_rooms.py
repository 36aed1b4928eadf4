"""Every room of the package imports only from those before it, also within functions and for type checkers."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "pam_cosim"
# From the ground to the roof; the rooms of a line know nothing of each other.
FLOORS = (
    ("arrays", "criteria", "lazy_names", "resources", "wording"),
    ("errors",),
    ("files", "counts", "processes", "toml_text"),
    ("cache", "store"),
    ("units",),
    ("exports", "model"),
    ("compiler",),
    ("catalogue",),
    ("fmu",),
    ("simulation",),
    ("measurement", "analysis", "sweeps"),
    ("starts",),
    ("cosimulation", "comparison", "drafting"),
    ("fitting", "ledger"),
    ("problems",),
    ("diagnosis",),
    ("reporting",),
    ("study",),
    ("workbench",),
    ("cli",),
)
FLOORS_OF_THE_DIAGNOSIS = ("judgement", "search", "description", "diagnose", "planning")
FLOOR = {room: floor for floor, rooms in enumerate(FLOORS) for room in rooms}
ROOMS = sorted(
    {path.name for path in PACKAGE.iterdir() if any(path.glob("*.py"))} - {"__pycache__"}
    | {path.stem for path in PACKAGE.glob("*.py") if path.name[0] != "_"}
)  # not what an older version left behind


def imported_parts(file: Path) -> list[list[str]]:
    """The parts of the names of what a module takes something from, of this package."""
    names: list[str] = []
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module == "pam_cosim":
            names += [f"pam_cosim.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.append(node.module)
    parts = [name.split(".") for name in names]
    return [part for part in parts if part[0] == "pam_cosim" and len(part) > 1]


def imported_rooms(file: Path) -> set[str]:
    """The rooms that a module takes something from."""
    return {part[1] for part in imported_parts(file)}


def imported_from(file: Path, room: str) -> set[str]:
    """The parts of a room that a module takes something from."""
    return {part[2] for part in imported_parts(file) if part[1] == room and len(part) > 2}


def test_every_room_has_a_floor() -> None:
    assert sorted(FLOOR) == ROOMS


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_imports_only_from_those_before_it(room: str) -> None:
    place = PACKAGE / room
    files = sorted(place.rglob("*.py")) if place.is_dir() else [place.with_suffix(".py")]
    assert files
    others = {other for file in files for other in imported_rooms(file)} - {room}
    assert {other for other in others if FLOOR[other] >= FLOOR[room]} == set()


@pytest.mark.parametrize("part", FLOORS_OF_THE_DIAGNOSIS)
def test_a_part_of_the_diagnosis_imports_only_from_those_before_it(part: str) -> None:
    place = PACKAGE / "diagnosis" / part
    files = sorted(place.glob("*.py")) if place.is_dir() else [place.with_suffix(".py")]
    below = FLOORS_OF_THE_DIAGNOSIS[: FLOORS_OF_THE_DIAGNOSIS.index(part)]
    others = {other for file in files for other in imported_from(file, "diagnosis")} - {part}
    assert others <= set(below)


def test_every_part_of_the_diagnosis_has_a_floor() -> None:
    place = PACKAGE / "diagnosis"
    folders = {path.parent.name for path in place.glob("*/*.py")}
    modules = {path.stem for path in place.glob("*.py") if path.name[0] != "_"}
    assert folders | modules == set(FLOORS_OF_THE_DIAGNOSIS)
