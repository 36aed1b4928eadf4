"""What all pictures share: runs of the library's models, figures, and what is read off a course."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from pam_cosim.fmu import build_model
from pam_cosim.simulation import Simulator, Trajectory

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")  # told apart by colour-blind readers
P_ATM, T_ATM, R = 101325.0, 293.15, 287.05  # Pa, K, J/(kg K)
STYLE = {
    "font.size": 9,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.spines.top": False,
    "axes.spines.right": False,
}


def simulate(
    model: str,
    end: float,
    samples: int = 2001,
    outputs: Sequence[str] | None = None,
    **parameters: float,
) -> Trajectory:
    """A run of a class of the library from 0 to ``end`` [s]."""
    with Simulator(build_model(f"PneumaticMuscle.{model}")) as simulator:
        return simulator.run(np.linspace(0, end, samples), parameters=parameters, outputs=outputs)


def figure(columns: int, width: float = 9.0, height: float = 3.2) -> tuple[plt.Figure, list[Axes]]:
    """A row of axes; sizes in inches."""
    picture, axes = plt.subplots(
        1, columns, figsize=(width, height), layout="constrained", squeeze=False
    )
    return picture, list(axes[0])


def save(picture: plt.Figure, folder: Path, name: str) -> None:
    """Writes a picture and forgets it."""
    picture.savefig(folder / f"{name}.png", dpi=110)
    plt.close(picture)


def at(trajectory: Trajectory, name: str, time: float) -> float:
    """Value of a variable at a time [s]."""
    return float(np.interp(time, trajectory.time, trajectory.values[name]))


def spread_at(
    trajectory: Trajectory, level: float, pressure: str, variable: str, after: float
) -> float:
    """Largest minus smallest value of a variable when the pressure passes a level, after a time [s].

    Values are interpolated at the very crossings, so that the width of no window is in the result.
    """
    t, p, y = trajectory.time, trajectory.values[pressure], trajectory.values[variable]
    before = np.flatnonzero(((p[:-1] < level) != (p[1:] < level)) & (t[:-1] > after))
    share = (level - p[before]) / (p[before + 1] - p[before])
    return float(np.ptp(y[before] + share * (y[before + 1] - y[before])))


def widths(model: str, end: float, samples: int, level: float, after: float) -> list[float]:
    """How wide the loops of the four benches of a model are at a pressure [Pa], after a time [s]: % of the length."""
    names = [(f"bench[{i}].regulator.p", f"eps[{i}]") for i in (1, 2, 3, 4)]
    fine = simulate(model, end, samples, [name for pair in names for name in pair])
    return [100 * spread_at(fine, level, p, eps, after) for p, eps in names]


def numbers(values: Sequence[float], digits: int) -> str:
    """``1.0, 2.0 and 3.0``."""
    texts = [f"{v:.{digits}f}" for v in values]
    return f"{', '.join(texts[:-1])} and {texts[-1]}" if len(texts) > 1 else texts[0]
