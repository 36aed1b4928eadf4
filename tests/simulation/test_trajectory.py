"""Trajectories and their files."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pam_cosim.simulation import Trajectory
from tests.trajectories import read_trajectory

TRAJECTORY = Trajectory(
    np.array([0.0, 0.1, 1 / 3]),
    {
        "p": np.array([1e5, 1e-300, -0.1 - 0.2]),
        "a[1,2]": np.array([0.0, 1.0, 2.0]),
        "eps": np.ones(3),
    },
    {"p": "Pa", "a[1,2]": "W/(m2.K)", "eps": ""},
)


def test_csv_reads_back_exactly(tmp_path: Path) -> None:
    path = TRAJECTORY.to_csv(tmp_path / "x.csv")
    assert path.read_text().splitlines()[0] == 'time [s],p [Pa],"a[1,2] [W/(m2.K)]",eps'
    back = read_trajectory(path)
    assert back.time.tolist() == TRAJECTORY.time.tolist() and back.units == TRAJECTORY.units
    assert {k: v.tolist() for k, v in back.values.items()} == {
        k: v.tolist() for k, v in TRAJECTORY.values.items()
    }
