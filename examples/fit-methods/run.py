"""The published particle swarm against better methods, by simulations: python examples/fit-methods/run.py [PICTURE].

Four runs of the independent vertical rig (two loads, two frequencies, random waves, noise) are fitted by each method.
What the global searches find by themselves is told and drawn before the descent that follows them.
"""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "dzahir-yamamoto"), str(HERE.parent.parent)]

import matplotlib  # noqa: E402

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import vertical_rig as rig  # noqa: E402

import pam_cosim as pam  # noqa: E402
from pam_cosim.fitting import METHODS, Fit  # noqa: E402


def fits(folder: Path) -> dict[str, Fit]:
    """One fit by each method."""
    data = pam.read(
        rig.write_data_set(folder, loads=(5.0, 20.0), frequencies=(0.5, 2.0), title="four waves")
    )
    return {method: pam.fit(data, method=method) for method in METHODS}


def draw(made: dict[str, Fit], picture: Path) -> None:
    """The lowest chi-square by the number of simulations; a cross where a search leaves off and a descent begins."""
    figure, axes = plt.subplots(figsize=(8, 4.2), layout="constrained")
    widths = {"least-squares": 5.0}  # where descents from the same start coincide, both are seen
    for method, fit in made.items():
        course = fit.convergence
        simulations = [*course.evaluations, fit.evaluations]
        lowest = [*course.chi2_reduced, course.chi2_reduced[-1]]
        width = widths.get(method, 1.5)
        (line,) = axes.step(simulations, lowest, where="post", label=method, linewidth=width)
        if fit.search is not None:
            own = fit.search.as_dict()
            axes.plot(own["evaluations"], own["chi2_reduced"], "x", color=line.get_color(), ms=9)
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="simulations of the fitted runs",
        ylabel="lowest reduced chi-square",
    )
    axes.grid(alpha=0.3)
    axes.legend(title="cross: what a search finds by itself")
    figure.savefig(picture, dpi=100)
    plt.close(figure)


def told(made: dict[str, Fit]) -> str:
    """What each method finds."""
    lines = []
    for method, fit in made.items():
        lines.append(
            f"{method}: chi2 {fit.residuals['fit'].chi2_reduced:.5g} after {fit.evaluations} simulations"
        )
        lines += [str(fit.search)] * (fit.search is not None)
    return "\n".join(lines)


def main(picture: Path) -> None:
    """All methods, what each finds, and the picture."""
    with TemporaryDirectory() as place:
        made = fits(Path(place))
    print(told(made))
    draw(made, picture)


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "fit-methods.png"))
