"""The vessel, carried on: python examples/tank-discharge/run.py [FOLDER WITH THE RAW DATA].

The thermometer is fitted too, the same vessel is filled, and another holds nitrogen at 150 bar. Without the raw data
the tables in carried-on/ are used as they are. Writes carried-on/report.md and carried-on/result.png.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent.parent)]

import published  # noqa: E402

import pam_cosim as pam  # noqa: E402
from examples.raw_data import asked_for, markdown_table, raw_folder  # noqa: E402
from pam_cosim import study  # noqa: E402
from pam_cosim.files import write_bytes, write_text  # noqa: E402
from pam_cosim.fitting import Fit  # noqa: E402
from pam_cosim.measurement import FreeParameter  # noqa: E402
from pam_cosim.reporting.style import image  # noqa: E402

FOLDER = HERE / "carried-on"
BENCH = "VesselOrifice"
FREE = {
    "EnergyGas": [FreeParameter("tank.gas.h", 0.01, 500, 10)],
    "FreeConvectionGas": [FreeParameter("tank.gas.c", 1e-3, 10, 0.13)],
    "ConvectiveGas": [
        FreeParameter("tank.gas.h_0", 0.01, 500, 5),
        FreeParameter("tank.gas.h_1", 0, 2000, 10),
    ],
    "ThermocoupleLag": [FreeParameter("thermometer.tau", 1e-3, 100, 3)],
    "WarmWall": [
        FreeParameter("tank.surroundings.C", 1e-2, 1e5, 8000),
        FreeParameter("tank.surroundings.G", 0, 50, 2),
    ],
}
LAG = "ThermocoupleLag"
PRESSURE_ONLY = ((), ("EnergyGas",), ("FreeConvectionGas",))
WITH_THERMOMETER = (
    ("EnergyGas",), ("EnergyGas", LAG), ("FreeConvectionGas", LAG), ("ConvectiveGas", LAG),
    ("EnergyGas", LAG, "WarmWall"),
)  # fmt: skip
NITROGEN = (
    (),
    ("EnergyGas",),
    ("ConvectiveGas",),
    ("FreeConvectionGas",),
    ("FreeConvectionGas", LAG),
)


def fitted(name: str, effects: tuple[str, ...], signals: tuple[str, ...], work: Path) -> Fit:
    """The vessel with some effects fitted to some signals of one data set."""
    model = BENCH
    if effects:
        model = str(work / "Vessel.mo")
        pam.add(effects, to=BENCH, output=model)
    data = pam.read(FOLDER / name, model=model)
    free = {n: p for n, p in data.fit.items() if not effects or n != "tank.n"}
    free |= {p.name: p for effect in effects for p in FREE[effect]}
    chosen = {n: replace(s, fitted=n in signals) for n, s in data.signals.items()}
    return study.fit(replace(data, signals=chosen, fit=free), model, method="multi-start")


def row(effects: tuple[str, ...], fit: Fit) -> list[str]:
    cells = [" + ".join(effects) or "polytropic law"]
    for role in ("fit", "holdout"):
        scores = fit.comparison.scores[role]
        cells += [f"{scores['p'].rmse / 1e3:.2f}", f"{scores['T'].rmse:.1f}"] if scores else []
    parts = []
    for n, e in fit.parameters.items():
        span = "at its bound" if e.at_bound else f"{e.low:.3g} to {e.high:.3g}"
        parts.append(f"{n.removeprefix('tank.').removeprefix('orifice.')} {e.value:.3g} ({span})")
    return [*cells, ", ".join(parts)]


def errors(fit: Fit) -> str:
    """Errors of pressure and thermometer in both runs, in words."""
    of = {role: fit.comparison.scores[role] for role in ("fit", "holdout")}
    texts = {
        role: f"{scores['p'].rmse / 1e3:.2f} kPa and {scores['T'].rmse:.1f} K"
        for role, scores in of.items()
    }
    return f"{texts['fit']} in the discharge, {texts['holdout']} in the filling"


def table(cases: dict[tuple[str, ...], Fit], *, holdout: bool) -> str:
    head = [
        "model",
        "p [kPa]",
        "T [K]",
        *(["p, filling [kPa]", "T, filling [K]"] if holdout else []),
        "parameters",
    ]
    return markdown_table(head, [row(effects, fit) for effects, fit in cases.items()])


def draw(pressure: Fit, both: Fit, nitrogen: Fit, film: Fit) -> None:
    """Temperature of the three vessels."""
    picture, axes = plt.subplots(1, 3, figsize=(13, 3.9), layout="constrained")
    air = [(pressure, "EnergyGas, p fitted"), (both, "free convection and lag, p and T fitted")]
    cases = [
        (axes[0], 0, air, "discharge from 790 kPa"),
        (axes[1], 1, air, "filling (never fitted)"),
        (axes[2], 0, [(film, "EnergyGas"), (nitrogen, "free convection")], "nitrogen from 150 bar"),
    ]  # fmt: skip
    for axis, i, fits, title in cases:
        for (fit, label), colour in zip(fits, ("#d55e00", "#0072b2"), strict=True):
            run = fit.comparison.runs[i]
            there = ~np.isnan(run.run.measurements["T"])
            axis.plot(run.run.time[there], run.model["T"][there], color=colour, label=label)
        axis.plot(
            run.run.time[there],
            run.run.measurements["T"][there],
            "o",
            color="0.3",
            ms=4,
            label="measured",
        )
        axis.set(xlabel="time [s]", ylabel="temperature reading [K]", title=title)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7)
    write_bytes(FOLDER / "result.png", image(picture, dpi=100))
    plt.close(picture)


def main() -> None:
    raw = raw_folder("tank-dutton-coverdill", asked_for())
    if raw is None:
        print("no raw data: the tables in carried-on/ are used as they are")
    else:
        published.write_tables(raw, FOLDER)
    with TemporaryDirectory() as place:
        work = Path(place)
        pressure = {e: fitted("both-ways", e, ("p",), work) for e in PRESSURE_ONLY}
        both = {e: fitted("both-ways", e, ("p", "T"), work) for e in WITH_THERMOMETER}
        nitrogen = {e: fitted("nitrogen", e, ("p", "T"), work) for e in NITROGEN}
    draw(
        pressure["EnergyGas",],
        both["FreeConvectionGas", LAG],
        nitrogen["FreeConvectionGas",],
        nitrogen["EnergyGas",],
    )
    diagnosis = pam.diagnose(
        pam.read(FOLDER / "both-ways"), say=lambda line: print(line, flush=True)
    )
    print(diagnosis)
    text = (
        (FOLDER / "report.template.md")
        .read_text(encoding="utf-8")
        .format(
            pressure=table(pressure, holdout=True),
            both=table(both, holdout=True),
            nitrogen=table(nitrogen, holdout=False),
            verdict=diagnosis.verdict.kind,
            effects=", ".join(diagnosis.verdict.effects),
            probability=f"{100 * diagnosis.verdict.probability:.0f} %",
            reason=diagnosis.verdict.reason,
            diagnosed=errors(diagnosis.final),
            named=", ".join(
                f"{name} = {value}" for name, value in diagnosis.final.parameters.items()
            ),
        )
    )
    write_text(FOLDER / "report.md", text)


if __name__ == "__main__":
    main()
