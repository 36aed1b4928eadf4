"""Every room of the package keeps to its budget and imports only from those before it, also within functions."""

from __future__ import annotations

import ast
import tokenize
from collections.abc import Iterable
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "pam_cosim"
# From the ground to the roof; the rooms of a line know nothing of each other. Each has a budget in tokens, of
# which comments are none: its size and 5 %, so that a commit which lets a room grow says so here.
FLOORS = (
    {"arrays": 20, "criteria": 850, "lazy_names": 250, "resources": 120, "wording": 790},
    {"errors": 190},
    {"libraries": 160},
    {"files": 2300, "counts": 280, "processes": 4150, "toml_text": 800},
    {"cache": 720, "store": 1200},
    {"units": 3500},
    {"exports": 790, "model": 2900},
    {"compiler": 62900},
    {"catalogue": 15700},
    {"fmu": 27700},
    {"simulation": 23300},
    {"measurement": 48700, "analysis": 15500, "sweeps": 10600},
    {"starts": 10600},
    {"cosimulation": 19500, "comparison": 18600, "drafting": 40700},
    {"fitting": 26400, "ledger": 20900},
    {"problems": 5200},
    {"diagnosis": 63300},
    {"reporting": 25000},
    {"study": 19900},
    {"workbench": 28900},
    {"cli": 16000},
)
TESTS = 346500  # budget of tests/ as a whole
FLOORS_OF_THE_DIAGNOSIS = ("judgement", "search", "description", "diagnose", "planning")
FLOOR = {room: floor for floor, rooms in enumerate(FLOORS) for room in rooms}
BUDGET = {room: budget for rooms in FLOORS for room, budget in rooms.items()}
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


def files_of(room: str) -> list[Path]:
    """The modules of a room, or the one that it is."""
    place = PACKAGE / room
    return sorted(place.rglob("*.py")) if place.is_dir() else [place.with_suffix(".py")]


def size(files: Iterable[Path]) -> int:
    """Tokens without layout and comments."""
    layout = {"NL", "NEWLINE", "INDENT", "DEDENT", "COMMENT", "ENDMARKER"}
    return sum(
        tokenize.tok_name[token.type] not in layout
        for file in files
        for token in tokenize.generate_tokens(file.open(encoding="utf-8").readline)
    )


def test_every_room_has_a_floor() -> None:
    assert sorted(FLOOR) == ROOMS


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_keeps_to_its_budget(room: str) -> None:
    assert 0 < size(files_of(room)) <= BUDGET[room]


def test_the_tests_keep_to_their_budget() -> None:
    assert size(Path(__file__).parent.rglob("*.py")) <= TESTS


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_imports_only_from_those_before_it(room: str) -> None:
    others = {other for file in files_of(room) for other in imported_rooms(file)} - {room}
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
