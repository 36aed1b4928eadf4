"""Sweeps and fits, stopped anywhere, their files damaged: they end as the uninterrupted ones, or with one sentence."""

from __future__ import annotations

import random
import shutil
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.sweeps import same
from tests.fitting.models import vessel_data

Study = Callable[[Path, Callable[..., None] | None], Any]
RUNS = 60


class Stopped(Exception):
    """The moment of a power failure."""


def swept(file: Path, progress: Callable[..., None] | None) -> pam.Sweep:
    """Of which the file is what a stop leaves."""
    vary = {"u_in": np.linspace(0.25, 0.35, RUNS)}
    words: dict[str, Any] = {"scalars": ["max(p)"], "trajectories": True, "stop_time": 1.0}
    with ThreadPoolExecutor(1) as pool:
        return pam.sweep(
            "TankFilling",
            vary,
            **words,
            output=file.with_suffix(""),
            executor=pool,
            progress=progress,
        )


def fitted(file: Path, progress: Callable[..., None] | None) -> dict[str, float]:
    """With many starts, so that it asks often."""
    made = pam.fit(vessel_data(), method="multi-start", starts=3, resume=file, progress=progress)
    return dict(made.values)


@cache
def whole(study: Study, place: Path) -> Any:
    """What the uninterrupted study comes to."""
    return study(place / f"{study.__name__}.csv.partial", None)


def equal(one: Any, other: Any) -> bool:
    """To the last bit."""
    return same(one, other) if isinstance(one, pam.Sweep) else bool(one == other)


def stopped(study: Study, file: Path, after: int) -> None:
    """Leaves what a study that is killed at its report of that number leaves on the disk."""
    reports = count()
    left = file.parent / "left"

    def progress(*_: object) -> None:
        if next(reports) == after:
            left.mkdir()
            for one in file.parent.glob(f"{file.name}*"):
                shutil.copy(one, left)
            raise Stopped

    try:
        study(file, progress)
    except Stopped:
        for one in file.parent.glob(f"{file.name}*"):
            one.unlink()
        for one in left.iterdir():
            shutil.move(one, file.parent)
        left.rmdir()


def zeroed(content: bytearray, chance: random.Random) -> bytes:
    """The end was never written."""
    size = chance.randrange(1, len(content) + 1)
    return bytes(content[:-size]) + bytes(size)


def flipped(content: bytearray, chance: random.Random) -> bytes:
    """Some bits."""
    for _ in range(chance.choice((1, 1, 10, 1000))):
        content[chance.randrange(len(content))] ^= 1 << chance.randrange(8)
    return bytes(content)


def cut(content: bytearray, chance: random.Random) -> bytes:
    """Shorter."""
    return bytes(content[: chance.randrange(len(content))])


def grown(content: bytearray, chance: random.Random) -> bytes:
    """With zeros after its end."""
    return bytes(content) + bytes(chance.randrange(1, 10_000))


def exchanged(content: bytearray, chance: random.Random) -> bytes:
    """Two sectors of the disk."""
    a, b = (512 * chance.randrange(len(content) // 512 + 1) for _ in range(2))
    first, second = content[a : a + 512], content[b : b + 512]
    content[a : a + len(second)], content[b : b + len(first)] = second, first
    return bytes(content)


def untouched(content: bytearray, chance: random.Random) -> bytes:
    """As it was left."""
    return bytes(content)


DAMAGES = (untouched, zeroed, flipped, cut, grown, exchanged)


def attack(study: Study, chance: random.Random, place: Path, reference: Any) -> str:
    """Interrupts a study up to three times with damages between, and says how it ended: ``equal`` or the sentence."""
    place.mkdir()
    file = place / "result.csv.partial"
    for _ in range(chance.randrange(1, 4)):
        try:
            stopped(study, file, chance.randrange(1, 20))
        except pam.InputError as problem:
            return _sentence(problem, file)
        for one in place.glob(f"{file.name}*"):
            if chance.random() < 0.7 and (content := bytearray(one.read_bytes())):
                one.write_bytes(chance.choice(DAMAGES)(content, chance))
    try:
        assert equal(study(file, None), reference)
    except pam.InputError as problem:
        return _sentence(problem, file)
    return "equal"


def _sentence(problem: pam.InputError, file: Path) -> str:
    said = str(problem)
    assert "\n" not in said and str(file) in said and "remove it or name another file" in said
    return said


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    yield tmp_path_factory.mktemp("whole")
    whole.cache_clear()


@pytest.mark.parametrize("times", [6, pytest.param(30, marks=pytest.mark.full)])
@pytest.mark.parametrize("study", [swept, fitted])
def test_damaged_and_stopped_it_ends_equal_or_in_a_sentence(
    study: Study, times: int, place: Path, tmp_path: Path
) -> None:
    chance = random.Random(f"{study.__name__} {times}")
    ends = [attack(study, chance, tmp_path / str(i), whole(study, place)) for i in range(times)]
    assert ends.count("equal") > times // 3
