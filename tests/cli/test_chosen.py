"""Which parameters are free, where they start, and which runs are held out: said on the command line."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome, everything

Command = Callable[..., Outcome]


def fitted(place: Path, name: str = "p.json") -> dict[str, float]:
    return {n: e["value"] for n, e in json.loads((place / name).read_text())["parameters"].items()}


def test_only_what_is_named_is_fitted_and_the_rest_held(
    command: Command, data: Path, place: Path
) -> None:
    choice = ("--free", "orifice.C_d", "--start", "tank.n=1.3")
    done = command("fit", data, *choice, "-o", "p.json", "--json", "fit.json")
    assert done.status == 0, done.err
    assert list(fitted(place)) == ["orifice.C_d"]
    held = command(
        "compare", data, "--params", "p.json", "--set", "tank.n=1.3", "--json", "held.json"
    )
    assert held.status == 0, held.err
    reached = json.loads((place / "held.json").read_text())["signals"]["p"]["rmse"]
    assert reached == pytest.approx(
        json.loads((place / "fit.json").read_text())["comparison"]["signals"]["p"]["rmse"], rel=1e-4
    )
    assert command("fit", data, "-o", "all.json").status == 0
    assert set(fitted(place, "all.json")) == {"orifice.C_d", "tank.n"}


def test_parameters_of_an_effect_can_be_fitted(command: Command, data: Path, place: Path) -> None:
    """They have the bounds of their class; the data set knows nothing of them."""
    bench = "PneumaticMuscle.Benches.VesselOrifice"
    assert command("add OrificeLeak --to", bench, "-o", "Leaking.mo").status == 0
    done = command(
        "fit",
        data,
        "--model",
        "Leaking.mo",
        "--free",
        "orifice.C_d",
        "--free",
        "leak.A",
        "-o",
        "p.json",
    )
    assert done.status == 0, done.err
    assert list(fitted(place)) == ["orifice.C_d", "leak.A"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["fit", "--free", "orifice.C_x"], "did you mean 'orifice.C_d'"),
        (["fit", "--start", "orifice.C_d=1 kPa"], "leave it out"),
        (["fit", "--start", "orifice.C_d"], "NAME=VALUE"),
        (["fit", "--output", "better.mo"], "'pam-cosim add --from' writes a model"),
        (["fit", "--role", "one=judge"], "no role"),
        (["compare", "--role", "one=holdout"], "no run would be left"),
        (["compare", "--role", "o*=holdout"], "no run would be left"),
        (["compare", "--set", "orifice.C_x=1"], "did you mean 'orifice.C_d'"),
        (["compare", "--cut", "one=5"], "write RUN=FROM:TO"),
        (["compare", "--begin", "one=soon"], "rest, steady, measured, estimated"),
        (["diagnose", "--expect", "leek"], "did you mean 'leak'"),
        (["diagnose", "--exclude", "leak", "--expect", "leak"], "leak is both excluded"),
    ],
)
def test_unknown_choices_are_refused(
    command: Command, data: Path, place: Path, words: list[str], said: str
) -> None:
    before = everything(place)
    refused = command(words[0], data, *words[1:])
    assert refused.status == 2 and said in refused.err, refused.err
    assert everything(place) == before
