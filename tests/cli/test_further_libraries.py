"""Two more libraries of other fields: a bioreactor and a wind tunnel; and no Python is about them."""

from __future__ import annotations

import re
import runpy
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from tests.cli.conftest import ROOT, Outcome
from tests.cli.test_commands import done

GROWTH = ROOT / "examples" / "bioreactor" / "Bioreactor"
TUNNEL = ROOT / "examples" / "wind-tunnel" / "WindTunnel"
RIG = runpy.run_path(str(ROOT / "examples" / "bioreactor" / "rig.py"))


@pytest.mark.parametrize("library", [GROWTH, TUNNEL], ids=lambda p: p.name)
def test_no_python_is_about_it(library: Path) -> None:
    shared = {
        "Effect",
        "Domain",
        "Air",
        "Shaft",
        "Drive",
        "package",
    }  # words of every day, or of every library
    words = {library.name, *(file.stem for file in (library / "Effects").glob("*.mo"))} - shared
    used_by_the_muscle = {file.stem for file in (ROOT / "modelica").rglob("*.mo")}
    source = {file: file.read_text(encoding="utf-8") for file in (ROOT / "pam_cosim").rglob("*.py")}
    words -= used_by_the_muscle
    assert not {
        (f.name, w) for f, text in source.items() for w in words if re.search(rf"\b{w}\b", text)
    }


@pytest.mark.parametrize("feed", [RIG["NO_FEED"], RIG["CAREFUL"]], ids=["batch", "fed"])
def test_the_library_says_what_the_rig_does(
    feed: tuple[np.ndarray, np.ndarray], tmp_path: Path
) -> None:
    RIG["write"](tmp_path / "growth", "monod", [feed])
    data = pam.read(tmp_path / "growth", files=[GROWTH])
    model = tmp_path / "Right.mo"
    model.write_text(
        "model Right extends Bioreactor.Benches.FedBatch(cells("
        "redeclare model Kinetics = Bioreactor.Effects.Monod, mu_max=0.421/3600, kinetics(K_S=4.39)));\nend Right;\n"
    )
    compared = pam.compare(data, str(model), files=[GROWTH])
    seen = np.isfinite(compared.runs[0].run.measurements["C_S"])
    assert compared.runs[0].model["C_S"][seen] == pytest.approx(
        RIG["substrate"](RIG["RATES"]["monod"], feed), abs=1e-4
    )


def test_a_planned_feed_is_played_as_it_is_written(tmp_path: Path) -> None:
    table = tmp_path / "next.csv"
    table.write_text(
        "# a remark\ntime [s],Q_in [m3/s]\n0,0\n3600,2.77777778e-06\n3600,0\n54000,0\n"
    )
    times, flows = RIG["feed_of"](table)
    assert times == pytest.approx([0, 1, 1, 15])
    assert flows == pytest.approx([0, 10, 0, 0])
    fed = RIG["substrate"](lambda s, x: 0.0, (times, flows))
    assert fed[-1] == pytest.approx(
        (7 + 5 * 50) / 12
    )  # 5 l of 50 g/l into 7 l of 1 g/l, and nothing grows


@pytest.mark.full
def test_a_designed_run_finds_the_law_of_growth(
    command: Callable[..., Outcome], place: Path
) -> None:
    RIG["write"](place / "growth")
    library = ("--file", str(GROWTH))
    assert (
        "Verdict: ambiguous: monod and tessier"
        in done(command("diagnose", "growth", *library, "--save", "g.npz")).out
    )
    done(command("plan", "g.npz", *library, "--limit", "Q_in=0 l/h:10 l/h", "-o", "next.csv"))
    RIG["write"](
        place / "growth", feeds=[RIG["NO_FEED"], RIG["CAREFUL"], RIG["feed_of"](place / "next.csv")]
    )
    said = done(command("diagnose", "growth", *library)).out
    assert "Verdict: identified: monod (Monod)" in said
    (half,) = re.findall(r"kinetics\.K_S = (\S+)", said)
    assert float(half) == pytest.approx(4.39, rel=0.05)


def test_the_published_models_of_the_tunnel(tmp_path: Path) -> None:
    """Model A2 ends at 3000 rpm; C3 gives a quarter of the fan's pressure with the hatch shut, a tenth with it open."""
    inputs = {"L_in": 1.0, "L_out": 0.0}
    shut, opened = (
        pam.simulate(
            "WindTunnel.Benches.TwoFans", {**inputs, "hatch": hatch}, files=[TUNNEL], stop_time=40.0
        )
        for hatch in (0.0, 1.0)
    )
    assert shut["w_in"][-1] == pytest.approx(314.1, abs=0.5)
    assert shut["i_in"][-1] == pytest.approx(0.27)
    at_rest = 74.82 * (shut["w_in"][-1] ** 2 - shut["w_out"][-1] ** 2) / 314.16**2
    assert (shut["p"][-1], opened["p"][-1]) == pytest.approx(
        (0.25 * at_rest, 0.10 * at_rest), rel=1e-3
    )
