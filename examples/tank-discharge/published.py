"""Makes the data sets of the second part from the published points."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from examples.raw_data import write_table

Array = NDArray[np.float64]

SOURCE = """{what}: points read off published curves by the authors of HydDown (andr1976/HydDown, MIT licence, commit
1040d75, validation/{name}.yml). Pressures there absolute in bar, here gauge to 101.325 kPa. Points in order of time."""
AIR = "Air in a steel vessel of 16.2 L (J. C. Dutton and R. E. Coverdill, Int. J. Engng Ed. 13(2) 1997, 123-134), {how}"
TABLES = {
    "both-ways/discharge.csv": ("Air_790kPa_21mm", AIR.format(how="discharge"), ("gas_mean",)),
    "both-ways/filling.csv": ("Air_3-7kPa_271mm", AIR.format(how="filling"), ("gas_high",)),
    "nitrogen/discharge.csv": (
        "N2_Exp_I1",
        "Nitrogen from 150 bar, vessel of 89.2 L",
        ("gas_high", "gas_low"),
    ),
}


def points(path: Path) -> tuple[Array, Array]:
    """Times [s] and values of one curve, in order of time."""
    rows = np.genfromtxt(path, delimiter=",", skip_header=1)
    order = np.argsort(rows[:, 0], kind="stable")
    return rows[order, 0], rows[order, 1]


def table(folder: Path, name: str, curves: tuple[str, ...]) -> dict[str, Array]:
    """Pressure and gas temperature; two curves of temperature are averaged at the times of the first."""
    t_p, p = points(folder / f"{name}_pressure.csv")
    t_t, temperature = points(folder / f"{name}_{curves[0]}.csv")
    for other in curves[1:]:
        temperature = (temperature + np.interp(t_t, *points(folder / f"{name}_{other}.csv"))) / 2
    time = np.unique(np.concatenate([t_p, t_t]))
    gauge = np.full(len(time), np.nan)
    gauge[np.searchsorted(time, t_p)] = 100 * p - 101.325
    reading = np.full(len(time), np.nan)
    reading[np.searchsorted(time, t_t)] = temperature
    return {"time [s]": time, "p [kPa]": gauge, "T [K]": reading}


def write_tables(raw: Path, folder: Path) -> None:
    """All tables."""
    for file, (name, what, curves) in TABLES.items():
        write_table(folder / file, table(raw, name, curves), SOURCE.format(what=what, name=name))
