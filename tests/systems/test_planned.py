"""The run that a diagnosis proposes is the run that the rig makes."""

from __future__ import annotations

from pathlib import Path

import pytest

from rig.schedule import Phase
from rig.short import measure_light, planned

PROPOSED = """\
# run run-02, u_in times 1.25
# set load.m = 4 kg
time [s],u_in [A],u_out [A],p_supply [kPa]
0,0.375,0,240
0.4,0.375,0,240
0.4,0,0,240
0.6,0,0,240
0.6,0,0.35,240
1,0,0.35,240
"""


def test_proposed_run_is_made(tmp_path: Path) -> None:
    (tmp_path / "next.csv").write_text(PROPOSED)
    run = planned(tmp_path / "next.csv", 4.0)
    assert (run.load, run.p_supply, run.role) == (4.0, 240e3, "fit")
    assert [p.duration for p in run.phases] == pytest.approx([0.4, 0.2, 0.4])
    assert [(p.u_in, p.u_out) for p in run.phases] == [(0.375, 0.0), (0.0, 0.0), (0.0, 0.35)]
    assert isinstance(run.phases[0], Phase)
    before, after = measure_light(seed=1), measure_light(seed=1, further=[run])
    assert len(after) == len(before) + 1 == 3 and len(after[2].time) == 51
    assert all(
        (a.signals["p"] == b.signals["p"]).all() for a, b in zip(before, after, strict=False)
    )
    p = after[2].signals["p"]
    assert p[20] > 10e3 and p[-1] < p[30] - 2e3  # it fills, holds and vents
