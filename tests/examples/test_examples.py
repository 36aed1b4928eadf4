"""The examples run as they stand, the notebook too."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray

ROOT = Path(__file__).parents[2]


@pytest.mark.full
def test_calibration_of_the_valve(tmp_path: Path) -> None:
    """Choked flow through the printed area, DP (41)-(42) and (62), worked out here by hand."""
    script = ROOT / "examples" / "sweeps" / "valve.py"
    made = subprocess.run([sys.executable, script, tmp_path], capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    assert made.stdout.startswith("315 runs of PneumaticMuscle.Benches.TankFilling (grid)")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["valve.csv", "valve.nc", "valve.png"]
    gamma, gas = 1.4, 287.05
    constant = np.sqrt(gamma / gas * (2 / (gamma + 1)) ** ((gamma + 1) / (gamma - 1)))
    with xarray.open_dataset(tmp_path / "valve.nc") as data:
        area = data["effective area"].isel(u_in=-1, p_supply=-1)
        choked = constant * float(area) * (280e3 + 101325.0) / np.sqrt(293.15)
        assert float(data["mass flow"].isel(u_in=-1, p_supply=-1)) == pytest.approx(
            choked, rel=2e-3
        )
        assert (data["mass flow"].diff("p_supply") > 0).all() and (
            data["mass flow"].diff("u_in") > 0
        ).all()


@pytest.mark.full
def test_the_notebook_runs_from_top_to_bottom() -> None:
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.read(ROOT / "examples" / "tour.ipynb", as_version=4)
    NotebookClient(
        notebook,
        timeout=300,
        kernel_name="python3",
        resources={"metadata": {"path": ROOT / "examples"}},
    ).execute()
    shown = [
        output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs
    ]
    assert not [
        output
        for output in shown
        if output.output_type == "error" or output.get("name") == "stderr"
    ]
    assert sum("text/html" in output.get("data", {}) for output in shown) >= 5
