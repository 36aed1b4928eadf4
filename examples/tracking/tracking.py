"""A sinusoid of contraction through the valves: a PID controller as an FMU and one in Python, error by frequency.

The gains come from the linear model about 45 mm: how fast each valve moves the load, and the lag behind it.

python examples/tracking/tracking.py [FOLDER FOR PICTURES]
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from sine_tracking import Tracking, track

import pam_cosim as pam

OPEN, MOST = 0.145, 0.35  # A: a valve begins to open, DP (62), and the largest current of DP
MEAN, AMPLITUDE = 0.045, 0.005  # m
FREQUENCIES = np.geomspace(0.1, 5, 9)


def speeds_by_current() -> tuple[float, float]:
    """How fast the load moves by the current of the inlet and of the exhaust valve [m/(s A)], about the mean."""
    linear = pam.linearise("Isotonic", {"u_out": 0.2}, at={"x": MEAN}, free=["u_in"])
    # Where the load follows the pressure at once, x = G p, and the valves fill the muscle: x_dot = G B u.
    force = linear.A[linear.states.index("load.v")]
    by_pressure = -force[linear.states.index("muscle.gas.p")] / force[linear.states.index("load.s")]
    filling = linear.B[linear.states.index("muscle.gas.p")]
    return by_pressure * filling[0], -by_pressure * filling[1]


INLET, EXHAUST = speeds_by_current()
CROSSOVER, LAG, INTEGRAL, FILTER, SAMPLE = 12.0, 0.09, 1.0, 0.03, 0.0125  # rad/s, s


def servo() -> pam.Controller:
    """PID like the FMU's, which knows that the two valves are not equally fast."""
    memory = {"x": 0.0, "w": 0.0, "i": 0.0}

    @pam.controller(
        inputs={"x": "m", "x_wanted": "m"}, outputs={"u_in": "A", "u_out": "A"}, interval=SAMPLE
    )
    def law(time: float, x: float, x_wanted: float) -> dict[str, float]:
        speed, wanted = (x - memory["x"]) / FILTER, (x_wanted - memory["w"]) / FILTER
        forget = 1 - np.exp(-SAMPLE / FILTER)
        memory["x"] += forget * (x - memory["x"])
        memory["w"] += forget * (x_wanted - memory["w"])
        error = x_wanted - x
        demand = wanted + CROSSOVER * (
            error + memory["i"] + LAG * (wanted - speed)
        )  # a speed [m/s]
        limited = float(np.clip(demand, -(MOST - OPEN) * EXHAUST, (MOST - OPEN) * INLET))
        memory["i"] += SAMPLE / INTEGRAL * (error + (limited - demand) / CROSSOVER)
        return {
            "u_in": OPEN + max(0.0, limited / INLET),
            "u_out": OPEN + max(0.0, -limited / EXHAUST),
        }

    return law


def row(name: str, tracking: Tracking) -> str:
    """Errors up to 2 Hz, without 0.16 Hz, as a row of Markdown; a star where two periods are not alike."""
    shown = [k for k, f in enumerate(FREQUENCIES) if f < 2 and k != 1]
    errors = 100 * tracking.relative_error
    cells = [
        f"{errors[k]:#.2g}".rstrip(".") if errors[k] < 10 else f"{errors[k]:.0f}" for k in shown
    ]
    marks = ["" if tracking.settled[k] else " *" for k in shown]
    return f"| {name} | {' | '.join(f'{c} %{m}' for c, m in zip(cells, marks, strict=True))} |"


def main(folder: Path) -> None:
    """Three controllers against frequency."""
    plt.switch_backend("Agg")
    folder.mkdir(parents=True, exist_ok=True)
    print(
        f"the load moves with {INLET:.3f} m/s by an ampere of the inlet, {EXHAUST:.3f} m/s of the exhaust"
    )
    mean = (INLET + EXHAUST) / 2
    gains = {"control.K": CROSSOVER / mean, "control.T_i": INTEGRAL, "control.T_f": FILTER}
    words = {
        "output": "x",
        "mean": MEAN,
        "amplitude": AMPLITUDE,
        "frequencies": FREQUENCIES,
        "interval": SAMPLE,
    }
    fmu = "CoSimulation.ServoController"
    results = {
        "FMU, PI": track("Isotonic", fmu, gains | {"control.T_d": 0.0}, **words),
        "FMU, PID and speed wanted": track(
            "Isotonic", fmu, gains | {"control.T_d": LAG, "control.K_v": 1 / mean}, **words
        ),
        "Python, the same, valves apart": track("Isotonic", servo, **words),
    }
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.9), layout="constrained")
    for (name, tracking), colour in zip(
        results.items(), ("#d55e00", "#009e73", "#0072b2"), strict=True
    ):
        print(f"\n{name}\n{tracking}")
        axes[0].loglog(
            FREQUENCIES, 100 * tracking.relative_error, "o-", color=colour, ms=4, label=name
        )
        for axis, k in ((axes[1], 2), (axes[2], 5)):
            axis.plot(tracking.phase, 1e3 * tracking.courses[k], color=colour, lw=1.2)
            axis.plot(tracking.phase, 1e3 * tracking.reference, color="#2b2f33", lw=1.0, ls="--")
            axis.set(
                title=f"{FREQUENCIES[k]:.2g} Hz",
                xlabel="part of a period",
                ylabel="contraction [mm]",
            )
    axes[0].axhline(100, color="#2b2f33", lw=0.8, ls=":")
    axes[0].set(xlabel="frequency [Hz]", ylabel="rms error [% of the sine's]")
    axes[0].legend(frameon=False, fontsize=8)
    for axis in axes:
        axis.grid(color="#e4e7ea")
    print(*(row(name, tracking) for name, tracking in results.items()), sep="\n")
    figure.savefig(folder / "tracking.png", dpi=110)
    print(f"written: {folder / 'tracking.png'}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
