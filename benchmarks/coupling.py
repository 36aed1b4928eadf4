"""How far coupled FMUs are from the model in one piece, by step size, method and cost.

    python -m benchmarks.coupling                 both tables, about a minute
    python -m benchmarks.coupling --picture       also draws docs/pictures/coupling.png

Valve and gas in one FMU, muscle and load in another (``CoSimulation`` of the library), against ``Benches.Isotonic``,
which runs with a relative tolerance of 1e-11. The solvers inside the coupled FMUs have 1e-9, so what is seen is the
error of the coupling. The error of a run is the largest difference of pressure or contraction at any of its
communication points, in parts of the range of that signal.

Order: half a second of filling with fixed steps. Cost: the same, in which something moves all the time; and ten seconds
in which the inlet is opened for half a second and the outlet for another half, and the muscle rests in between. The
cost of a run is the number of steps that both FMUs made together, with those made for the error estimate and those
taken back; processor time is beside it.
"""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from typing import Any

import numpy as np

import pam_cosim as pam
from benchmarks.speed.report import machine, parser, say, show, steps_of, write
from pam_cosim.simulation import Simulator

METHODS = [(m, e) for m in ("jacobi", "gauss-seidel") for e in ("constant", "linear")]
STEPS = (8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4)  # [s], for the order
FIXED = (2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2.5e-4)  # [s], for the cost
TOLERANCES = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6)
FIXED_STEPS, CHOSEN = "fixed steps", "steps by their error"
SIGNALS = {"gas.p": "p", "muscle.x": "x"}
Points = list[dict[str, float]]
_COSTS = ("cost", "seconds")
_REFERENCE, _INSIDE = 1e-11, 1e-9  # relative tolerances of the solvers


def system() -> Any:
    """The isotonic bench in two FMUs."""
    return pam.couple(
        {"gas": "CoSimulation.ValveAndGas", "muscle": "CoSimulation.MuscleAndLoad"},
        [
            "gas.p -> muscle.p",
            "muscle.V -> gas.V",
            "muscle.V_flow -> gas.V_flow",
            "muscle.A -> gas.A",
        ],
    )


def courses() -> dict[str, Any]:
    """The currents of the ten seconds: filling, rest, venting, rest."""
    at = np.array([0.0, 0.5, 0.5, 5.0, 5.0, 5.5, 5.5, 10.0])
    filling = np.array([0.35, 0.35, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    venting = np.array([0.0, 0.0, 0.0, 0.0, 0.35, 0.35, 0.0, 0.0])
    return {"time": at, "u_in": filling, "u_out": venting}


class Monolith:
    """The model in one piece."""

    def __init__(self, inputs: pam.Inputs | None = None) -> None:
        self._simulator, self._inputs = Simulator(pam.build("Isotonic")), inputs

    def error(self, trajectory: pam.Trajectory) -> float:
        """Largest difference at any communication point, in parts of the signal's range."""
        exact = self._simulator.run(
            trajectory.time,
            inputs=self._inputs,
            outputs=list(SIGNALS.values()),
            tolerance=_REFERENCE,
        )
        worst = 0.0
        for signal, name in SIGNALS.items():
            difference = np.max(np.abs(trajectory[signal] - exact[name]))
            worst = max(worst, float(difference / np.ptp(exact[name])))
        return worst


def _measured(monolith: Monolith, **settings: Any) -> dict[str, float]:
    before = time.process_time()
    run = system().simulate(solver_tolerance=_INSIDE, **settings)
    spent = time.process_time() - before
    return {
        "error": monolith.error(run.trajectory),
        "cost": float(sum(run.component_steps.values())),
        "rejected": float(run.rejected),
        "rollbacks": float(run.rollbacks),
        "smallest": run.smallest,
        "largest": run.largest,
        "seconds": spent,
    }


def orders(steps: Sequence[float] = STEPS) -> dict[str, Points]:
    """For each method the error of every fixed step."""
    monolith, by_method = Monolith(), {}
    for method, extrapolation in steps_of(METHODS, "order"):
        settings = {"stop_time": 0.48, "method": method, "extrapolation": extrapolation}
        by_method[f"{method}, {extrapolation}"] = [
            {"step": step, **_measured(monolith, step=step, **settings)} for step in steps
        ]
    return by_method


def costs(
    rests: bool, fixed: Sequence[float] = FIXED, tolerances: Sequence[float] = TOLERANCES
) -> dict[str, Points]:
    """Error and cost with fixed steps, and with steps chosen by their error; Gauss-Seidel, linear."""
    course = courses() if rests else {"time": np.array([0.0])}
    at = course.pop("time")
    monolith = Monolith(pam.Inputs(at, course))
    coupled = pam.Inputs(at, {f"gas.{name}": values for name, values in course.items()})
    common = {"stop_time": 10.0 if rests else 0.48, "inputs": coupled}
    return {
        FIXED_STEPS: [
            {"step": s, **_measured(monolith, step=s, **common)} for s in steps_of(fixed, "fixed")
        ],
        CHOSEN: [
            {"tolerance": t, **_measured(monolith, tolerance=t, **common)}
            for t in steps_of(tolerances, "chosen")
        ],
    }


def order_of(points: Points) -> float:
    """The slope of log error over log step, of the three smallest steps."""
    last = sorted(points, key=lambda p: p["step"])[:3]
    return float(
        np.polyfit([math.log(p["step"]) for p in last], [math.log(p["error"]) for p in last], 1)[0]
    )


def error_at_cost(points: Points, cost: float, of: str = "cost") -> float | None:
    """The error that a series has at some cost, between its points on logarithmic scales; None: outside."""
    ordered = sorted(points, key=lambda p: p[of])
    x = [math.log(p[of]) for p in ordered]
    if not x[0] <= math.log(cost) <= x[-1]:
        return None
    return math.exp(float(np.interp(math.log(cost), x, [math.log(p["error"]) for p in ordered])))


def draw(order: dict[str, Points], cost: dict[str, dict[str, Points]]) -> str:
    """The picture of ``docs/own-fmu.md``."""
    from pathlib import Path

    from pam_cosim.reporting.style import (
        BLUE,
        GREEN,
        ORANGE,
        SOFT,
        VERMILLION,
        drawing,
        image,
        new_figure,
    )

    target = Path(__file__).resolve().parents[1] / "docs" / "pictures" / "coupling.png"
    colours = dict(zip(order, (VERMILLION, ORANGE, BLUE, GREEN), strict=True))
    with drawing():
        figure = new_figure(9.0, 3.8)
        left, right = figure.subplots(1, 2)
        for (name, points), marker in zip(order.items(), "so^D", strict=True):
            label = f"{name}: order {order_of(points):.2f}"
            x, y = [1e3 * p["step"] for p in points], [p["error"] for p in points]
            left.loglog(x, y, marker=marker, ms=4, lw=1.2, color=colours[name], label=label)
        left.set_xlabel("communication step [ms]")
        left.set_title("fixed steps, filling for 0.48 s", loc="left", fontweight="bold")
        for (case, by_steps), colour in zip(cost.items(), (SOFT, BLUE), strict=True):
            for (name, points), line, marker in zip(
                by_steps.items(), ("--", "-"), "so", strict=True
            ):
                x, y = [p["cost"] for p in points], [p["error"] for p in points]
                right.loglog(
                    x, y, line, marker=marker, ms=4, lw=1.2, color=colour, label=f"{case}, {name}"
                )
        right.set_xlabel("steps of both FMUs, all that were made")
        right.set_title("Gauss-Seidel, linear", loc="left", fontweight="bold")
        for axes in (left, right):
            axes.set_ylabel("coupling error, part of the range [-]")
            axes.grid(True, which="major")
            axes.legend(loc="lower right" if axes is left else "lower left")
            for axis in (axes.xaxis, axes.yaxis):
                axis.set_major_formatter("{x:g}")
                axis.set_minor_formatter("")
        left.set_xticks([1e3 * step for step in STEPS])
        right.set_ylim(bottom=2e-7)  # below the points is room for the legend
        target.write_bytes(image(figure, dpi=120))
    return str(target)


def main(arguments: Sequence[str] | None = None) -> None:
    """Measures and prints."""
    options = parser(__doc__)
    options.add_argument("--picture", action="store_true", help="draw docs/pictures/coupling.png")
    given = options.parse_args(arguments)
    say(f"{machine()['processor']}, {machine()['cores']} cores")
    order = orders()
    heads = ["method", *(f"{1e3 * step:g} ms" for step in STEPS), "order"]
    rows = [
        [n, *(f"{p['error']:.1e}" for p in points), f"{order_of(points):.2f}"]
        for n, points in order.items()
    ]
    show("coupling error by step, part of the range", heads, rows)
    cost = {"filling": costs(False), "ten seconds with rests": costs(True)}
    for case, by_steps in cost.items():
        _show_costs(case, by_steps)
    if given.picture:
        say(f"drawn: {draw(order, cost)}")
    write(given.json, {"order": order, "cost": cost})


def _show_costs(case: str, by_steps: dict[str, Points]) -> None:
    columns = [
        "steps",
        "error",
        "cost",
        "taken back",
        "rollbacks",
        "smallest",
        "largest",
        "processor time",
    ]
    columns += ["fixed/this, equal cost", "equal time"]
    rows = []
    for name, what in ((FIXED_STEPS, "step"), (CHOSEN, "tolerance")):
        for p in by_steps[name]:
            sizes = (
                f"{1e3 * p['smallest']:.2g} ms",
                f"{1e3 * p['largest']:.3g} ms",
                f"{p['seconds']:.2f} s",
            )
            counts = (f"{p[key]:.0f}" for key in ("cost", "rejected", "rollbacks"))
            other = [
                error_at_cost(by_steps[FIXED_STEPS], p[of], of) if name == CHOSEN else None
                for of in _COSTS
            ]
            ratios = (f"{error / p['error']:.2g}" if error else "-" for error in other)
            rows.append([f"{what} {p[what]:g}", f"{p['error']:.1e}", *counts, *sizes, *ratios])
    show(f"{case}: error and cost", columns, rows)


if __name__ == "__main__":
    main()
