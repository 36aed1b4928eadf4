"""Two more libraries of other fields: a bioreactor and a wind tunnel; and no Python is about them."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from tests.cli.conftest import ROOT

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
