"""Makes one data set for each chamber from the recordings of the leak tests."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from examples.raw_data import write_table

Array = NDArray[np.float64]

ZERO = 0.033  # bar, what the sensor reads when the chamber of 0.20 mm layers has emptied itself
EMPTIED = "Ultimaker_020"
VALVE_SHUT = 5.5  # s, in the run of that chamber; before it the supply holds the pressure
SOURCE = """Leak test of a closed chamber, {name}: measured by E. Zillen, TU Delft (github.com/EvaZillen/
3D-printed-pneumatic-actuator, CC0-1.0, commit 6e0bcb4, chamber_leak_{name}.csv). Means of {samples} samples of 0.1 s;
gauge pressure less 0.033 bar, the reading of the empty chamber."""
EXPONENT = (
    '"tank.n" = { min = 1.0, max = 1.4 }'  # a run that empties the chamber shows how its gas cools
)
EXPERIMENT = """title = "Leak test of a closed chamber: {name}"
model = "PneumaticMuscle.Benches.ClosedVessel"

# The converter's steps are 6.3 mbar: 6.3/sqrt(12).
[signals.p]
sigma = "1.8 mbar"

# The volume is not documented: 100 mL stands for it. Only leak/volume can be found.
[parameters]
"tank.V" = "100 ml"
"tank.p_start" = "{start:.4g} bar"

[fit]
"tank.p_start" = {{ min = "{low:.4g} bar", max = "{high:.4g} bar" }}
{exponent}

[[runs]]
file = "pressure.csv"
role = "fit"
"""


def read_recording(path: Path) -> tuple[Array, Array]:
    """Time [s] and pressure [bar]; dots stand between thousands of milliseconds: 151.203.000 is 151203.000 ms."""
    cells = [line.split(";") for line in path.read_text(encoding="utf-8").split()]
    time = [float("".join(cell[0].split(".")[:-1])) / 1e3 for cell in cells]
    return np.array(time), np.array([float(cell[2]) for cell in cells])


def means(values: Array, samples: int) -> Array:
    """(n // samples,) means of neighbouring samples."""
    n = len(values) // samples
    averages: Array = values[: n * samples].reshape(n, samples).mean(axis=1)
    return averages


def write_chamber(path: Path, folder: Path) -> None:
    """The data set of one chamber: from the moment when the valve is shut until nothing can be seen any more."""
    name = path.stem.removeprefix("chamber_leak_")
    time, p = read_recording(path)
    samples = 4 if name == EMPTIED else 20
    kept = (time >= VALVE_SHUT) & (time < 50) if name == EMPTIED else time >= 0
    t, y = means(time[kept] - time[kept][0], samples), means(p[kept], samples) - ZERO
    write_table(
        folder / "pressure.csv",
        {"time [s]": t, "p [bar]": y},
        SOURCE.format(name=name, samples=samples),
    )
    start = float(y[0])
    text = EXPERIMENT.format(
        name=name,
        start=start,
        low=start * 0.98,
        high=start * 1.1,
        exponent=EXPONENT if name == EMPTIED else "",
    )
    (folder / "experiment.toml").write_text(text, encoding="utf-8")


def write_chambers(raw: Path, folder: Path) -> None:
    """All chambers of the folder."""
    for path in sorted(raw.glob("chamber_leak_*.csv")):
        write_chamber(path, folder / path.stem.removeprefix("chamber_leak_"))
