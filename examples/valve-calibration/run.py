"""The valve at fifteen supplies: python examples/valve-calibration/run.py [FOLDER].

Flow and effective area by current and supply from PneumaticMuscle.Examples.Validation.ValveCalibration, and the
regression of DP (61)-(62) done again with each reading of its 344.7 kPa. Nothing here is measured: DP print neither
flows nor areas of their calibration. Prints the report, and writes calibration.csv, report.md and result.png into
FOLDER (default: demo/valve-calibration).
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path[:0] = [str(ROOT)]

import pam_cosim as pam  # noqa: E402
from examples.raw_data import asked_for, markdown_table, write_table  # noqa: E402
from pam_cosim.files import write_text  # noqa: E402
from pam_cosim.simulation import Trajectory  # noqa: E402

Array = NDArray[np.float64]
MODEL = "PneumaticMuscle.Examples.Validation.ValveCalibration"
SUPPLIES = 30e3 + 250e3 * np.arange(15) / 14  # Pa gauge, as in the model
R, GAMMA, P_ATM, T_ATM = 287.05, 1.4, 101325.0, 293.15
K = float(np.sqrt(GAMMA / R * (2 / (GAMMA + 1)) ** ((GAMMA + 1) / (GAMMA - 1))))  # DP (42)
FLOW_SLOPE, FLOW_OFFSET = 0.07289 / 60, 0.01056 / 60  # DP (61), m3/s by A, m3/s
STATED = 344.7e3  # Pa, "supply pressure" of DP (61)
MEASURED, CURRENT = 2.580e-7, 0.35  # m2 at A, DP section 4.4


def printed_area(current: float) -> float:
    """DP (62), m2."""
    return 1.80e-6 * current - 2.61e-7


def regression(upstream: float, air_temperature: float = T_ATM) -> tuple[float, float]:
    """Slope [m2/A] and offset [m2] of the area that (41) finds in (61), choked, from an absolute upstream pressure.

    ``air_temperature``: at which a cubic metre of (61) is counted, under 101.325 kPa.
    """
    density = P_ATM / (R * air_temperature)
    factor = density * np.sqrt(T_ATM) / (K * upstream)
    return FLOW_SLOPE * factor, FLOW_OFFSET * factor


def calibration() -> Trajectory:
    """Flows and areas while the current rises to 0.35 A."""
    return pam.simulate(MODEL)


def readings() -> dict[str, tuple[float, float]]:
    """The regression with each reading of what (61) leaves open."""
    return {
        "344.7 kPa absolute, air of 20 °C": regression(STATED),
        "344.7 kPa gauge, air of 20 °C": regression(STATED + P_ATM),
        "344.7 kPa absolute, air of 0 °C": regression(STATED, 273.15),
        "344.7 kPa gauge, air of 0 °C": regression(STATED + P_ATM, 273.15),
    }


def regression_table() -> str:
    rows = []
    for name, (slope, offset) in {"DP (62) as printed": (1.80e-6, 2.61e-7), **readings()}.items():
        area = slope * CURRENT - offset
        cells = [f"{slope * 1e6:.3f}", f"{offset * 1e7:.3f}", f"{area * 1e7:.2f}"]
        rows.append(
            [
                name,
                *cells,
                f"{area / printed_area(CURRENT) - 1:+.1%}",
                f"{MEASURED / area - 1:+.1%}",
            ]
        )
    head = [
        "reading",
        "slope [1e-6 m2/A]",
        "offset [1e-7 m2]",
        "at 0.35 A [1e-7 m2]",
        "against (62)",
        "measured",
    ]
    return markdown_table(head, rows)


def supply_table(trajectory: Trajectory) -> str:
    rows = []
    for i, supply in enumerate(SUPPLIES):
        flow, *areas = (
            trajectory.values[f"{name}[{i + 1}]"][-1]
            for name in ("V_flow", "A", "A_choked", "A_gauge")
        )
        rows.append(
            [f"{supply / 1e3:.1f}", f"{flow * 6e4:.2f}", *(f"{a * 1e7:.2f}" for a in areas)]
        )
    head = [
        "supply [kPa gauge]",
        "flow [L/min]",
        "area by (41) [1e-7 m2]",
        "taken as choked",
        "and gauge as absolute",
    ]
    return markdown_table(head, rows)


def draw(trajectory: Trajectory, picture: Path) -> None:
    page, (flows, areas, conversions) = plt.subplots(1, 3, figsize=(13, 3.9), layout="constrained")
    shades = plt.get_cmap("viridis")(np.linspace(0, 0.9, len(SUPPLIES)))
    u = trajectory.values["u"]
    for i, shade in enumerate(shades):
        label = f"{SUPPLIES[i] / 1e3:.0f} kPa" if i in (0, 7, 14) else None
        flows.plot(u, trajectory.values[f"V_flow[{i + 1}]"] * 6e4, color=shade, lw=1.2, label=label)
    flows.plot(
        u,
        np.maximum(0, FLOW_SLOPE * u - FLOW_OFFSET) * 6e4,
        "k--",
        lw=1,
        label="DP (61), 344.7 kPa",
    )
    flows.set(
        xlabel="current [A]", ylabel="flow [L/min of ambient air]", title="flow, C$_A$ = 0.699"
    )
    for (name, (slope, offset)), colour, style in zip(
        readings().items(),
        ("#0072b2", "#d55e00", "#0072b2", "#d55e00"),
        ("-", "-", ":", ":"),
        strict=True,
    ):
        areas.plot(
            u,
            np.maximum(0, slope * u - offset) * 1e7,
            color=colour,
            ls=style,
            lw=1.2,
            label=f"(61): {name}",
        )
    areas.plot(u[::20], np.maximum(0, printed_area(u[::20])) * 1e7, "k+", ms=5, label="DP (62)")
    areas.plot(CURRENT, MEASURED * 1e7, "s", color="#009e73", ms=6, label="DP: measured")
    areas.set(
        xlabel="current [A]",
        ylabel="effective area [1e-7 m²]",
        title="four readings of (61)",
        xlim=(0.14, 0.36),
    )
    names = {"A": "(41)", "A_choked": "taken as choked", "A_gauge": "and gauge as absolute"}
    for (name, label), colour in zip(names.items(), ("#0072b2", "#cc79a7", "#d55e00"), strict=True):
        last = [trajectory.values[f"{name}[{i + 1}]"][-1] * 1e7 for i in range(len(SUPPLIES))]
        conversions.plot(SUPPLIES / 1e3, last, "o-", ms=3, lw=1.2, color=colour, label=label)
    conversions.set(xlabel="supply [kPa gauge]", ylabel="effective area at 0.35 A [1e-7 m²]")
    conversions.set_title("one valve, three conversions")
    for axis in (flows, areas, conversions):
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7)
    page.savefig(picture, dpi=100)
    plt.close(page)


def write(folder: Path) -> str:
    """The three files; returns the report."""
    folder.mkdir(parents=True, exist_ok=True)
    trajectory = calibration()
    draw(trajectory, folder / "result.png")
    every = slice(None, None, max(1, len(trajectory.time) // 50))
    columns = {"u [A]": trajectory.values["u"][every]}
    for i, supply in enumerate(SUPPLIES):
        columns[f"flow at {supply / 1e3:.1f} kPa [L/min]"] = (
            trajectory.values[f"V_flow[{i + 1}]"][every] * 6e4
        )
    write_table(
        folder / "calibration.csv", columns, f"Flows of {MODEL}: a model's, nobody measured them."
    )
    text = (HERE / "report.template.md").read_text(encoding="utf-8")
    report = text.format(regression=regression_table(), supplies=supply_table(trajectory))
    write_text(folder / "report.md", report)
    return report


if __name__ == "__main__":
    print(write(Path(asked_for() or ROOT / "demo" / "valve-calibration")))
