"""The motor on a table: an independent simulation of what the example measures, with noise, as data sets.

Nothing of it comes from the Modelica library or its solver. The current is stepped by the exact solution of the
circuit at a constant speed; dry friction takes momentum and never more than there is (Moreau's time stepping), where
the library has a smooth function; the contact of the brushes saturates exponentially, where the library has a
hyperbolic tangent; the resistance follows the inferred zero of copper.

    python examples/own-library/rig.py FOLDER --hidden dry_friction
"""

from __future__ import annotations

import argparse
import csv
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

STEP = 50e-6  # s
EVERY = 100  # steps from one sample to the next
NOISE = {"i": 0.02, "w": 0.3}  # A, rad/s

Schedule = tuple[tuple[float, float], ...]  # from when [s], which voltage [V]

FREE: dict[str, Schedule] = {
    "fit-up": ((0.0, 6.0), (1.0, 12.0), (2.0, 18.0), (3.0, 9.0), (4.0, 3.0)),
    "fit-both": ((0.0, 10.0), (1.0, -5.0), (2.0, -14.0), (3.0, 4.0), (4.0, 0.0)),
    "holdout-other": ((0.0, 15.0), (1.2, 2.0), (2.0, -8.0), (3.4, 11.0), (4.0, 20.0)),
}
LIFTED: dict[str, Schedule] = {
    "fit-up": ((0.0, 9.0), (2.0, 14.0), (4.0, 11.0), (6.0, 18.0)),
    "fit-down": ((0.0, 16.0), (3.0, 8.0), (6.0, 12.0)),
    "holdout-other": ((0.0, 12.0), (2.5, 20.0), (5.0, 10.0)),
}


@dataclass(frozen=True)
class Rig:
    """The motor as it is; zero: there is nothing of the kind."""

    bench: str = "FreeRun"
    R: float = 1.1  # Ohm
    L: float = 1e-3  # H
    k: float = 0.05  # V.s
    J: float = 2.4e-4  # kg.m2
    b: float = 2.6e-5  # N.m.s
    load: float = 0.0  # kg on the rope
    radius: float = 0.02  # m
    friction: float = 0.0  # N.m
    drag: float = 0.0  # N.m.s2
    contact: float = 0.0  # V
    heat_capacity: float = math.inf  # J/K
    conductance: float = 0.25  # W/K


HIDDEN = {
    "none": Rig(),
    "dry_friction": Rig(friction=0.012),
    "air_drag": Rig(drag=1.5e-7),
    "brush_contact": Rig(contact=0.7),
    "winding_heat": Rig(bench="Hoist", load=1.5, heat_capacity=14.0),
}
"""What the rig has that the base model lacks."""


def run(rig: Rig, schedule: Schedule, duration: float) -> dict[str, np.ndarray]:
    """One run from rest: (n,) each of time [s], voltage [V], current [A], speed [rad/s], without noise."""
    inertia = rig.J + rig.load * rig.radius**2
    weight = rig.load * 9.81 * rig.radius
    i = w = warmth = 0.0
    rows = []
    for n in range(round(duration / STEP) + 1):
        t = n * STEP
        u = [v for start, v in schedule if start <= t + 1e-9][-1]
        if n % EVERY == 0:
            rows.append((t, u, i, w))
        R = (
            rig.R * (254.5 + warmth) / 254.5
        )  # 234.5 degC below zero copper would not resist; cold is 20 degC
        contact = rig.contact * math.copysign(1 - math.exp(-abs(i) / 0.12), i)
        settled = (u - contact - rig.k * w) / R
        after = settled + (i - settled) * math.exp(-R * STEP / rig.L)
        warmth += STEP * (R * i * i - rig.conductance * warmth) / rig.heat_capacity
        torque = rig.k * (i + after) / 2 - rig.b * w - rig.drag * w * abs(w) - weight
        w += STEP * torque / inertia
        taken = min(STEP * rig.friction / inertia, abs(w))
        w -= math.copysign(taken, w)
        i = after
    return dict(zip(("time", "u", "i", "w"), np.array(rows).T, strict=True))


def write(folder: Path, hidden: str, seed: int = 1) -> None:
    """The runs of a rig as a data set."""
    rig, draw = HIDDEN[hidden], np.random.default_rng(seed)
    folder.mkdir(parents=True, exist_ok=True)
    schedules = LIFTED if rig.load else FREE
    text = [
        f'title = "A motor with {hidden.replace("_", " ")}"',
        f'model = "DCMotor.Benches.{rig.bench}"',
    ]
    text += [
        "",
        "[signals.i]",
        f'sigma = "{NOISE["i"]} A"',
        "",
        "[signals.w]",
        f'sigma = "{NOISE["w"]} rad/s"',
    ]
    text += ["", "[parameters]", f'"motor.L" = "{rig.L} H"', f'"motor.k" = "{rig.k} V.s/rad"']
    text += [f'"drum.m" = "{rig.load} kg"', f'"drum.r" = "{rig.radius} m"'] if rig.load else []
    text += ["", "[fit]", '"motor.R" = { min = "0.5 Ohm", max = "2 Ohm" }']
    text += ['"motor.b" = { min = "0 N.m.s/rad", max = "2e-4 N.m.s/rad" }']
    text += ['"flywheel.J" = { min = "1e-4 kg.m2", max = "1e-3 kg.m2" }']
    for name, schedule in schedules.items():
        course = run(rig, schedule, 8.0 if rig.load else 5.0)
        for signal, sigma in NOISE.items():
            course[signal] = course[signal] + sigma * draw.standard_normal(len(course[signal]))
        with (folder / f"{name}.csv").open("w", newline="", encoding="utf-8") as file:
            table = csv.writer(file)
            table.writerow(["time [s]", "u [V]", "i [A]", "w [rad/s]"])
            table.writerows(
                [f"{value:.6g}" for value in row] for row in zip(*course.values(), strict=True)
            )
        text += ["", "[[runs]]", f'file = "{name}.csv"', f'role = "{name.partition("-")[0]}"']
        text += ['interpolation = "previous"']
    (folder / "experiment.toml").write_text("\n".join([*text, ""]), encoding="utf-8")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path, help="where the data set goes")
    parser.add_argument("--hidden", choices=HIDDEN, default="dry_friction", help="what the rig has")
    parser.add_argument("--seed", type=int, default=1, help="of the noise")
    words = parser.parse_args()
    write(words.folder, words.hidden, words.seed)
