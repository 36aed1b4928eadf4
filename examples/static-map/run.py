"""A printed table of forces to a verdict: python examples/static-map/run.py [FOLDER].

The force map of a fluidic muscle (Martens and Boblan 2017, table A1) is diagnosed, and a static formula with as many
parameters is fitted by SciPy to the same rows. Writes the report and a picture into FOLDER (default: a temporary one).
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent.parent)]

import pam_cosim as pam  # noqa: E402
from pam_cosim.measurement import DataSet, Run  # noqa: E402
from pam_cosim.reporting import diagnosis_report, write_report  # noqa: E402

Array = NDArray[np.float64]
L0 = 0.296  # m


def sarosi(c: Array, p: Array, k: Array) -> Array:
    """F = (c1 p + c2) exp(c3 k) + c4 k p + c5 p + c6: Sarosi 2012, six parameters; p [bar], k [0.1]."""
    return np.asarray((c[0] * p + c[1]) * np.exp(c[2] * k) + c[3] * k * p + c[4] * p + c[5])


def hildebrandt(c: Array, p: Array, k: Array) -> Array:
    """F = p (c1 + c2 k + c3 k^2) - (c4 k^2 + c5 k + c6 + c7 k^(2/3)): Hildebrandt and others 2005, seven parameters."""
    return np.asarray(
        p * (c[0] + c[1] * k + c[2] * k**2) - (c[3] * k**2 + c[4] * k + c[5] + c[6] * k ** (2 / 3))
    )


FORMULAS: tuple[tuple[Callable[[Array, Array, Array], Array], tuple[float, ...]], ...] = (
    (sarosi, (-4.0, 290.0, -0.33, -9.0, 290.0, -280.0)),
    (hildebrandt, (250.0, -20.0, 1.0, 0.0, 0.0, 50.0, 10.0)),
)


def points(runs: tuple[Run, ...]) -> tuple[Array, Array, Array]:
    """Pressure [bar], contraction [0.1 of the length] and pull [N] of all points."""
    p = np.concatenate([run.inputs["p"] for run in runs]) / 1e5
    x = np.concatenate([run.inputs["x"] for run in runs])
    return p, 10 * x / L0, np.concatenate([run.measurements["F"] for run in runs])


def errors_of_formula(
    data: DataSet, formula: Callable[[Array, Array, Array], Array], start: tuple[float, ...]
) -> tuple[float, float]:
    """Rms error [N] of a formula in the rows it was fitted to, and in those that were held out."""
    p, k, pull = points(data.fit_runs)
    best = least_squares(lambda c: formula(c, p, k) - pull, start, x_scale="jac", max_nfev=20_000).x
    p_out, k_out, pull_out = points(data.holdout_runs)
    off = formula(best, p, k) - pull, formula(best, p_out, k_out) - pull_out
    return float(np.sqrt(np.mean(off[0] ** 2))), float(np.sqrt(np.mean(off[1] ** 2)))


def main(folder: Path) -> None:
    """Errors of the formulas and of the model, the verdict, its report and its picture."""
    folder.mkdir(parents=True, exist_ok=True)
    data = pam.read(HERE)
    for formula, start in FORMULAS:
        fitted, held = errors_of_formula(data, formula, start)
        print(
            f"{formula.__name__}, {len(start)} parameters: {fitted:.2f} N, held-out pressures {held:.2f} N"
        )
    diagnosis = pam.diagnose(data)
    print(diagnosis)
    write_report(folder / "report.html", diagnosis_report(diagnosis))
    pam.draw(diagnosis, folder / "result.png")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(Path(sys.argv[1]))
    else:
        with TemporaryDirectory() as made:
            main(Path(made))
