"""The calibration of the valve as a sweep: python examples/sweeps/valve.py [FOLDER].

Flow and effective area of the inlet by current at fifteen supplies from 30 to 280 kPa, as DP section 4.4 plan it, here
of a valve that blows into a tank at ambient pressure: its flow at the first moment is that into the open air. Writes
valve.nc, valve.csv and valve.png.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

import pam_cosim as pam


def calibration(folder: Path) -> pam.Sweep:
    """Fifteen supplies by twenty-one currents; stopped, it goes on where it was."""
    folder.mkdir(parents=True, exist_ok=True)
    swept = pam.sweep(
        "TankFilling",
        {"u_in": np.linspace(0.15, 0.35, 21), "p_supply": np.linspace(30e3, 280e3, 15)},
        scalars={
            "mass flow": "initial(valve.inlet.m_flow)",
            "effective area": "initial(valve.inlet.A)",
        },
        stop_time="10 ms",
        output=folder / "valve.nc",
    )
    swept.save(folder / "valve.csv")
    pam.draw(swept, folder / "valve.png")
    return swept


if __name__ == "__main__":
    result = calibration(Path(sys.argv[1]) if len(sys.argv) > 1 else Path.cwd())
    print(result)
    flow = result.to_xarray()["mass flow"]
    for pressure in (30e3, 280e3):
        at_full_current = float(flow.sel(p_supply=pressure, method="nearest").isel(u_in=-1))
        print(f"at 0.35 A and {pressure / 1e3:g} kPa: {at_full_current * 1e3:.3f} g/s")
