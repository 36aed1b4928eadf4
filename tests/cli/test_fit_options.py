"""``fit``: interrupted and gone on with, many starts; one message for what cannot be."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Callable
from pathlib import Path

from tests.cli.conftest import Outcome

Command = Callable[..., Outcome]


def test_a_resumed_command_prints_the_same(command: Command, data: Path, place: Path) -> None:
    first = command("fit", data, "--resume", "fit.progress", "-o", "p.json")
    assert first.status == 0, first.err
    with sqlite3.connect(place / "fit.progress") as kept:  # as when a fit is killed early
        kept.execute("DELETE FROM records WHERE key > x'70'")
    kept.close()
    again = command("fit", data, "--resume", "fit.progress", "-o", "q.json")
    assert again.status == 0 and again.out == first.out
    assert (place / "p.json").read_bytes() == (place / "q.json").read_bytes()


def test_pictures_and_profiles(command: Command, data: Path, place: Path) -> None:
    done = command(
        "fit", data, "--plot", "fit.png", "--profile", "profile.png", "--json", "fit.json"
    )
    assert done.status == 0, done.err
    assert (
        "How well these data determine each parameter:" in done.out
        and "orifice.C_d lies between" in done.out
    )
    for name in ("fit.png", "profile.png"):
        assert (place / name).read_bytes().startswith(b"\x89PNG")
    written = json.loads((place / "fit.json").read_text())
    assert (
        set(written["profiles"]) == {"orifice.C_d", "tank.n"} and len(written["correlation"]) == 2
    )


def test_a_width_is_refused_before_the_fit(command: Command, data: Path, place: Path) -> None:
    before = {*place.iterdir()}
    done = command("fit", data, "-o", "p.json", "--plot", "fit.pdf", "--width", "88 kg")
    assert done.status == 2 and "width of a picture" in done.err
    assert not done.out and {*place.iterdir()} == before
