"""Commands of a page that no page would send: each is answered, in words, and the study stands as it was."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.workbench import Session
from pam_cosim.workbench.commands import COMMANDS
from tests.hostile.mutations import VALUES
from tests.hostile.reading import make

TRIED = 300
PATIENCE = 120.0  # s for an answer
NAMES = (
    "valve.C_A",
    "run-01",
    "Isotonic",
    "LinearBladder",
    "fit",
    "holdout",
    "least-squares",
    "../x.mo",
    "x.mo",
    "",
)
KEYS = ("values", "effects", "model", "roles", "method", "free", "time_limit", "exclude", "expect", "file", "names",
        "candidate", "learned", "do", "id", "self", "study", "__class__")  # fmt: skip
LONG = ("fit", "diagnose", "check")  # are tried with arguments that are refused, and elsewhere


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Session]:
    with Session(make(tmp_path_factory.mktemp("page") / "data", {})) as session:
        yield session


def value(chance: random.Random, depth: int = 0) -> Any:
    """Anything that JSON can hold."""
    kind = chance.randrange(6 if depth < 3 else 3)
    if kind < 2:
        return chance.choice(VALUES)
    if kind == 2:
        return chance.choice(NAMES)
    if kind == 3:
        return [value(chance, depth + 1) for _ in range(chance.randrange(4))]
    if kind == 4:
        return {
            str(chance.choice(NAMES)): value(chance, depth + 1) for _ in range(chance.randrange(3))
        }
    return chance.uniform(-1, 1) * 10 ** chance.randrange(-300, 300)


def command(chance: random.Random) -> dict[str, Any]:
    """A command with any arguments."""
    names = [name for name in COMMANDS if name not in LONG]
    told: dict[str, Any] = {"do": chance.choice([*names, *names, "nothing", None, ["set"]])}
    fitting = {
        "set": "values",
        "switch": "effects",
        "choose": "model",
        "roles": "roles",
        "add": "file",
        "take": "candidate",
    }
    if told["do"] in fitting.values() or isinstance(told["do"], str) and chance.random() < 0.8:
        told[fitting.get(str(told["do"]), chance.choice(KEYS))] = value(chance)
    for _ in range(chance.choice((0, 0, 1, 3))):
        told[chance.choice(KEYS)] = value(chance)
    if told.get("do") in LONG:
        told["no such argument"] = 1
    return told


def attack(session: Session, chance: random.Random, tries: int) -> int:
    """Sends commands and looks at what comes back."""
    for _ in range(tries):
        told = command(chance)
        try:
            answer = session.do(told).result(PATIENCE)
        except (InputError, SimulationFailure) as problem:
            assert len(str(problem)) < 5000, told
            continue
        json.dumps(answer, default=str)
    return tries


def test_commands_that_no_page_sends(session: Session) -> None:
    folder = session.folder
    before = sorted(p.name for p in Path(folder).iterdir())
    heard: list[str | bytes] = []
    end = session.subscribe(heard.append).result(PATIENCE)
    attack(session, random.Random(0), TRIED)
    end()
    words = [m for m in heard if isinstance(m, str) and "should not" in m]
    assert not words, words[:3]
    made = {p.name for p in Path(folder).iterdir()} - set(before)
    assert all(name == "workbench.json" or name.endswith((".mo", ".npz")) for name in made), made
    assert sorted(p.name for p in Path(folder).parent.iterdir()) == [Path(folder).name]
    session.do({"do": "set", "values": {"valve.C_A": 0.7}}).result(PATIENCE)
