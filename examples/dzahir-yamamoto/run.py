"""Which friction the existing model lacks, DY Fig. 6a and 6b: python examples/dzahir-yamamoto/run.py [FOLDER].

Writes the rig's data set into FOLDER (default: a temporary one), diagnoses it, prints the verdict and the
correlations in the form of DY Table 3, and draws docs/pictures/dzahir-yamamoto-friction.png.
"""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path[:0] = [str(HERE), str(ROOT)]

import vertical_rig as rig  # noqa: E402

import pam_cosim as pam  # noqa: E402
from examples.raw_data import markdown_table  # noqa: E402
from pam_cosim import Diagnosis  # noqa: E402
from pam_cosim.comparison import Comparison, RunComparison, Statistic  # noqa: E402

PICTURE = ROOT / "docs" / "pictures" / "dzahir-yamamoto-friction.png"
COLOURS = plt.get_cmap("viridis")(np.linspace(0, 0.85, len(rig.LOADS)))


def by_condition(comparison: Comparison) -> dict[tuple[float, float], RunComparison]:
    """Runs by load [kg] and frequency [Hz]."""
    return {(r.run.parameters["load.m"], r.run.parameters["frequency"]): r for r in comparison.runs}


def tabled(comparison: Comparison, statistic: Statistic) -> str:
    """Load by frequency, with mean and standard deviation, as DY Table 3."""
    head, *rows = comparison.table("load.m", "frequency").texts(statistic)
    return markdown_table(head, rows)


def rounded(comparison: Comparison) -> list[str]:
    """Rms errors [mm], two decimals, a row of Markdown for each load."""
    runs = by_condition(comparison)
    errors = {
        at: f"{1e3 * np.sqrt(np.nanmean(run.residual('x') ** 2)):.2f}" for at, run in runs.items()
    }
    return [
        f"| {load:g} kg | {' | '.join(errors[load, f] for f in rig.FREQUENCIES)} |"
        for load in rig.LOADS
    ]


def draw(diagnosis: Diagnosis, picture: Path) -> None:
    """Loops at the lowest and the highest frequency: measured, by the existing model, with the effect found."""
    models = [("existing model", by_condition(diagnosis.base.comparison))]
    models += [("with the effect found", by_condition(diagnosis.final.comparison))]
    figure, axes = plt.subplots(
        2, 2, figsize=(10, 7.4), layout="constrained", sharex=True, sharey="row"
    )
    for row, frequency in zip(axes, (rig.FREQUENCIES[0], rig.FREQUENCIES[-1]), strict=True):
        for axis, (name, runs) in zip(row, models, strict=True):
            for load, colour in list(zip(rig.LOADS, COLOURS, strict=True))[::2]:
                run = runs[load, frequency]
                p, late = run.run.inputs["p"] / 1e3, run.run.time > 1
                axis.plot(
                    p[late],
                    run.run.measurements["x"][late] / 3e-3,
                    ".",
                    color=colour,
                    ms=2,
                    alpha=0.6,
                )
                axis.plot(
                    p[late], run.model["x"][late] / 3e-3, color=colour, lw=0.9, label=f"{load:g} kg"
                )
            axis.set_title(f"{name}, {frequency:g} Hz", fontsize=10)
            axis.grid(alpha=0.3)
        row[0].set_ylabel("contraction ratio [%]")
    for axis in axes[1]:
        axis.set_xlabel("gauge pressure [kPa]")
    axes[0, 0].legend(fontsize=8, title="lines: model\npoints: measured", title_fontsize=8)
    figure.savefig(picture, dpi=100)
    plt.close(figure)


def main() -> None:
    with TemporaryDirectory() as place:
        folder = rig.write_data_set(Path(sys.argv[1] if len(sys.argv) > 1 else place))
        diagnosis = pam.diagnose(pam.read(folder), say=lambda line: print(line, flush=True))
    print(diagnosis)
    for name, comparison in (
        ("existing model", diagnosis.base.comparison),
        ("with the effect", diagnosis.final.comparison),
    ):
        print(f"\nCorrelation, {name}\n\n{tabled(comparison, 'correlation')}")
        print(f"\nRms error [mm]\n\n{tabled(comparison, 'rmse')}")
    draw(diagnosis, PICTURE)


if __name__ == "__main__":
    main()
