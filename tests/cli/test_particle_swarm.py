"""``fit --method particle-swarm`` says what the swarm did, apart from what the descent made of it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome


@pytest.mark.full
def test_swarm_is_reported_by_itself(
    process: Callable[..., Outcome], data: Path, place: Path
) -> None:
    outcome = process(
        "fit",
        data,
        "--method",
        "particle-swarm",
        "--json",
        place / "fit.json",
        "-o",
        place / "best.json",
    )
    assert outcome.status == 0, outcome.err
    for part in (
        "swarm of 50 particles",
        "in 10 generations, 550 simulations",
        "its own best point",
        "the descent from there comes to",
    ):
        assert part in outcome.out
    written = json.loads((place / "fit.json").read_text())
    own = written["search"]
    assert len(own["chi2_by_generation"]) == 11 and own["generations"] == 10
    assert own["chi2_by_generation"] == sorted(own["chi2_by_generation"], reverse=True)
    assert own["chi2_reduced"] >= written["chi2_reduced"]
    assert set(own["best_point"]) == {"orifice.C_d", "tank.n"}
    fitted = json.loads((place / "best.json").read_text())["parameters"]
    assert (
        fitted["tank.n"]["value"]
        == written["parameters"]["tank.n"]["value"]
        != own["best_point"]["tank.n"]["value"]
    )


@pytest.mark.full
def test_product_that_alone_is_determined_is_said(
    process: Callable[..., Outcome], place: Path
) -> None:
    """Of a and b in DY (10)-(11) no measurement tells more than the product."""
    folder = place / "rig"
    folder.mkdir()
    (folder / "experiment.toml").write_text(
        'title = "loops"\nmodel = "VerticalLoad"\n[signals.x]\nsigma = "0.1 mm"\n[parameters]\n"load.m" = "20 kg"\n'
        'frequency = "2 Hz"\n[fit]\n"muscle.friction.a" = { min = "0.01 s", max = "10 s" }\n'
        '"muscle.friction.b_f" = { min = "0.01 s", max = "10 s" }\n[[runs]]\nfile = "one.csv"\nrole = "fit"\n'
    )
    made = process(
        "simulate",
        "VerticalLoad",
        "--set",
        "load.m=20 kg",
        "--set",
        "frequency=2 Hz",
        "-o",
        place / "out.csv",
    )
    assert made.status == 0, made.err
    lines = (place / "out.csv").read_text().splitlines()
    names = lines[0].split(",")
    at = [
        next(i for i, n in enumerate(names) if n.split(" ")[0] == wanted)
        for wanted in ("time", "x")
    ]
    rows = [[line.split(",")[i] for i in at] for line in lines[1:]]
    table = [f"{t},200,{1e3 * float(x)}" for t, x in rows]
    (folder / "one.csv").write_text("\n".join(["time [s],p [kPa],x [mm]", *table, ""]))
    outcome = process("fit", folder, "--json", place / "fit.json")
    assert outcome.status == 0, outcome.err
    assert "only the product is determined: muscle.friction.a * muscle.friction.b_f" in outcome.out
    (pair,) = json.loads((place / "fit.json").read_text())["combinations"]
    assert pair["kind"] == "product" and pair["unit"] == "s2" and abs(pair["value"] - 0.15) < 0.02
