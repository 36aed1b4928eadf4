"""The temperature that Doumit and Pardoel print: python examples/gas-temperature/run.py [FOLDER FOR THE DATA SET].

An independent simulator (SciPy; states are internal energy, mass of gas, contraction and speed) makes three runs of the
latex muscle whose wall conducts as DP (45) prints and whose gas obeys the balances of mass and energy, with noise. Four
models are fitted to them; the printed one is diagnosed, and the library's own with films. Writes the data set
(to demo/gas-temperature), report.md and result.png, and prints what docs/stories.md quotes.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path[:0] = [str(ROOT)]

import pam_cosim as pam  # noqa: E402
from examples.raw_data import asked_for, markdown_table  # noqa: E402
from pam_cosim.files import write_text  # noqa: E402
from pam_cosim.fitting import Fit  # noqa: E402
from pam_cosim.measurement import FreeParameter  # noqa: E402
from rig import measurement  # noqa: E402
from rig.catalogue.gas_energy import GasEnergy  # noqa: E402
from rig.plan import Run  # noqa: E402
from rig.schedule import Phase  # noqa: E402

PRINTED = "PneumaticMuscle.Examples.PrintedWallIsotonic"
FILMS = "PneumaticMuscle.Benches.Isotonic"
LADDER = {
    "wall as printed, power law (60)": (PRINTED, ()),
    "wall with films, power law (60)": (FILMS, ()),
    "wall with films, balance of energy": (FILMS, ("EnergyGas",)),
    "wall as printed, balance of energy": (PRINTED, ("EnergyGas",)),
}
FILM = FreeParameter(
    "muscle.gas.h", 0.01, 500, 10
)  # as in Effects.GasEnergy.EnergyGas; the printed wall has no film
SIGNALS = {"p": ("kPa", 1e-3), "x": ("mm", 1e3), "T": ("K", 1.0)}
AXES = (
    ("p", "gauge pressure [kPa]", 1e-3, 0.0),
    ("x", "contraction [mm]", 1e3, 0.0),
    ("T", "gas temperature [°C]", 1.0, 273.15),
)  # signal, label, factor, zero
COLOURS = ("#d55e00", "#cc79a7", "#009e73", "#0072b2")


def fill(seconds: float) -> Phase:
    return Phase(seconds, u_in=0.35)


def vent(seconds: float) -> Phase:
    return Phase(seconds, u_out=0.35)


def hold(seconds: float) -> Phase:
    return Phase(seconds)


PLAN = (
    Run(2.27, 207e3, (fill(5), vent(5))),  # the course of DP Figs. 8, 10 and 12
    Run(2.27, 138e3, (fill(2), hold(1.5), vent(1), hold(1), vent(4.5))),
    Run(2.27, 170e3, (fill(0.8), hold(1.2), fill(2), vent(1), hold(1), vent(4)), "holdout"),
)


def write_data(folder: Path, seed: int = 1) -> None:
    """The three runs with noise; the same seed gives the same numbers."""
    muscle = measurement.TRUTH
    hidden = GasEnergy(h=muscle.k_wall / muscle.t_wall)  # DP (45) as printed, without films
    measured = measurement.measure(PLAN, [hidden], seed=seed)
    measurement.write_data_set(
        folder, measured, title="Latex muscle, wall as printed, balances of mass and energy"
    )
    description = folder / "experiment.toml"
    description.write_text(
        description.read_text(encoding="utf-8").replace(FILMS, PRINTED), encoding="utf-8"
    )


def fitted(folder: Path, rung: str, work: Path) -> Fit:
    """One model of the ladder fitted to the data set."""
    model, effects = LADDER[rung]
    if effects:
        target = work / f"Rung{list(LADDER).index(rung)}.mo"
        pam.add(effects, to=model, output=target)
        model = str(target)
    data = pam.read(folder, model=model)
    if effects and LADDER[rung][0] == FILMS:
        data = replace(data, fit={**data.fit, FILM.name: FILM})
    return pam.fit(data, model)


def row(rung: str, fit: Fit) -> list[str]:
    cells = [rung]
    for role in ("fit", "holdout"):
        scores = fit.comparison.scores[role]
        cells += [f"{scores[name].rmse * factor:.3g}" for name, (_, factor) in SIGNALS.items()]
    return [*cells, ", ".join(f"{name} {e.value:.4g}" for name, e in fit.parameters.items())]


def holdout_row(rung: str, fit: Fit) -> str:
    """Errors of a model on the run that was never fitted, two digits each, as a row of Markdown."""
    scores = fit.comparison.scores["holdout"]
    cells = [
        f"{scores[name].rmse * factor:#.2g}".rstrip(".") for name, (_, factor) in SIGNALS.items()
    ]
    return f"| {' | '.join([rung, *cells])} |"


def draw(fits: dict[str, Fit], picture: Path) -> None:
    """The holdout run: pressure, contraction and temperature, measured and by each model."""
    page, axes = plt.subplots(1, 3, figsize=(12, 3.9), layout="constrained")
    holdout = {
        rung: next(r for r in fit.comparison.runs if r.run.role == "holdout")
        for rung, fit in fits.items()
    }
    run = next(iter(holdout.values())).run
    for axis, (name, label, factor, zero) in zip(axes, AXES, strict=True):
        for (rung, simulated), colour in zip(holdout.items(), COLOURS, strict=True):
            axis.plot(
                run.time, (simulated.model[name] - zero) * factor, color=colour, lw=1.4, label=rung
            )
        t, measured = run.time[::12], run.measurements[name][::12]
        axis.plot(
            t, (measured - zero) * factor, "k.", ms=2.5, label="measured on the simulated rig"
        )
        axis.set(xlabel="time [s]", ylabel=label)
        axis.grid(alpha=0.3)
    page.legend(
        *axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=5, fontsize=8
    )
    page.savefig(picture, dpi=100)
    plt.close(page)


def main() -> None:
    folder = Path(asked_for() or ROOT / "demo" / "gas-temperature")
    write_data(folder)
    with TemporaryDirectory() as place:
        fits = {rung: fitted(folder, rung, Path(place)) for rung in LADDER}
    draw(fits, HERE / "result.png")
    diagnosis = pam.diagnose(pam.read(folder), say=lambda line: print(line, flush=True))
    print(diagnosis)
    print(pam.diagnose(pam.read(folder), FILMS))
    print(*(holdout_row(rung, fit) for rung, fit in fits.items()), sep="\n")
    head = [
        "model",
        *(f"{n}, {role} [{u}]" for role in ("fit", "holdout") for n, (u, _) in SIGNALS.items()),
        "fitted",
    ]
    table = markdown_table(head, [row(rung, fit) for rung, fit in fits.items()])
    text = (HERE / "report.template.md").read_text(encoding="utf-8")
    write_text(HERE / "report.md", text.format(table=table, verdict=diagnosis))


if __name__ == "__main__":
    main()
