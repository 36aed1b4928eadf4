"""Two more libraries of other fields: a bioreactor and a wind tunnel; and no Python is about them."""

from __future__ import annotations

import runpy
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from tests.cli.conftest import ROOT

GROWTH = ROOT / "examples" / "bioreactor" / "Bioreactor"
RIG = runpy.run_path(str(ROOT / "examples" / "bioreactor" / "rig.py"))


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
