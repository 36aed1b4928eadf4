"""Every room of the package imports only from those before it, also within functions and for type checkers."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "pam_cosim"
# From the ground to the roof; the rooms of a line know nothing of each other.
FLOORS = (
    ("errors", "arrays", "criteria", "renamed", "resources", "wording"),
    ("files", "counts", "units", "processes"),
    ("exports", "model"),
    ("compiler",),
    ("catalogue",),
    ("fmu",),
    ("simulation",),
    ("measurement", "analysis", "sweeps"),
    ("cosimulation", "comparison", "drafting"),
    ("fitting", "ledger"),
    ("diagnosis",),
    ("reporting",),
    ("study",),
    ("workbench",),
    ("cli",),
)
FLOOR = {room: floor for floor, rooms in enumerate(FLOORS) for room in rooms}
ROOMS = sorted(
    {path.name for path in PACKAGE.iterdir() if any(path.glob("*.py"))} - {"__pycache__"}
    | {path.stem for path in PACKAGE.glob("*.py") if path.name[0] != "_"}
)  # not what an older version left behind


def imported_rooms(file: Path) -> set[str]:
    """The rooms that a module takes something from."""
    names: list[str] = []
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module == "pam_cosim":
            names += [f"pam_cosim.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.append(node.module)
    parts = [name.split(".") for name in names]
    return {part[1] for part in parts if part[0] == "pam_cosim" and len(part) > 1}


def test_every_room_has_a_floor() -> None:
    assert sorted(FLOOR) == ROOMS


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_imports_only_from_those_before_it(room: str) -> None:
    place = PACKAGE / room
    files = sorted(place.rglob("*.py")) if place.is_dir() else [place.with_suffix(".py")]
    assert files
    others = {other for file in files for other in imported_rooms(file)} - {room}
    assert {other for other in others if FLOOR[other] >= FLOOR[room]} == set()
