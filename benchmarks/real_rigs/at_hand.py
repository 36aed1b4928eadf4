"""Rigs whose thinned tables are in the examples of this repository already, licences allowing."""

from __future__ import annotations

import numpy as np

from benchmarks.real_rigs.fluidic import LEAK, free_course
from benchmarks.real_rigs.folders import EXAMPLES, Array, Rig, Run, read_columns

ROBOT = """model = "PneumaticMuscle.Benches.SwitchedMuscle"

[signals.p]
sigma = "1.5 kPa"

[parameters]
"muscle.L0" = "211.4 mm"
"muscle.D0" = "16.38 mm"
"muscle.turns" = 1.538
"ambient.T" = "296.15 K"
"valve.C_A" = 0.2

[fit]
"valve.C_A" = { min = 0.1, max = 1.5 }
"muscle.n_g" = { min = 1.0, max = 1.4 }
"""
VESSEL = """model = "PneumaticMuscle.Benches.VesselOrifice"

# Read off printed curves.
[signals.p]
sigma = "2 kPa"

[parameters]
"tank.V" = "16.18 l"
"orifice.d" = "2.71 mm"
"orifice.C_d" = 0.8
"tank.n" = 1.2

[fit]
"orifice.C_d" = { min = 0.5, max = 1.1 }
"tank.n" = { min = 1.0, max = 1.4 }
"""
MAP = """model = "PneumaticMuscle.Benches.QuasiStaticIsometric"
kind = "static"

[signals.F]
sigma = "5 N"

[parameters]
"muscle.L0" = "296 mm"
"muscle.mu_fb" = "0"

[fit]
"muscle.D0" = { min = "15 mm", max = "40 mm" }
"muscle.turns" = { min = 0.5, max = 5 }
"""


JUMPS: dict[str, tuple[str, ...]] = {
    "robot": ("0p06-65", "0p12-65"),
    "robot-80": ("0p06-80", "0p12-80"),
    "robot-80-others": ("0p02-80", "0p09-80"),
}


def robot(name: str = "robot") -> Rig:
    """Pressure in the left hip muscle of a jumping robot; two of three are repeats of the verdict, fitted alone."""

    def run(name: str) -> Run:
        columns = read_columns(EXAMPLES / "jumping-robot" / "recordings" / f"{name}-hip_l.csv")
        units = {"time": "s", "u_in": "1", "u_out": "1", "p_supply": "kPa", "s": "mm", "p": "kPa"}
        return Run(name, {f"{k} [{u}]": columns[k] for k, u in units.items()})

    runs = {"fitted": JUMPS[name]}
    if name == "robot":
        runs |= {
            "within": ("0p09-65",),
            "outside": ("0p02-80", "0p06-80", "0p09-80", "0p12-80"),
        }
    return Rig(
        name=name,
        title="Left hip muscle of a jumping robot",
        signal="p",
        inputs=("u_in", "u_out", "p_supply", "s"),
        head=ROBOT,
        runs={role: [run(n) for n in names] for role, names in runs.items()},
        step=0.004,
    )


def vessel() -> Rig:
    """Pressure of a steel vessel that empties, and that is filled."""
    folder = EXAMPLES / "tank-discharge" / "carried-on" / "both-ways"
    out, into = (read_columns(folder / f"{n}.csv") for n in ("discharge", "filling"))
    hot = {
        "tank.p_start": "688.675 kPa",
        "tank.T_start": "298 K",
        "ambient.T": "298 K",
        "p_outside": "-1.325 kPa",
    }
    cold = {
        "tank.p_start": "-97.625 kPa",
        "tank.T_start": "295 K",
        "ambient.T": "295 K",
        "p_outside": "-0.775 kPa",
    }
    p = _pressure(out)
    half = float(p["time [s]"][-1]) / 2
    early = p["time [s]"] <= half
    first = Run("discharge-first", {k: v[early] for k, v in p.items()}, parameters=hot)
    return Rig(
        name="vessel",
        title="A steel vessel that empties or fills through a hole",
        signal="p",
        inputs=(),
        head=VESSEL,
        runs={
            "fitted": [first],
            "within": [Run("discharge", p, half, hot)],
            "outside": [Run("filling", _pressure(into), parameters=cold)],
        },
        step=1.0,
    )


def _pressure(table: dict[str, Array]) -> dict[str, Array]:
    """The samples of a pressure that are there."""
    there = ~np.isnan(table["p"])
    return {"time [s]": table["time"][there], "p [kPa]": table["p"][there]}


def chamber() -> Rig:
    """Pressure of a printed chamber that empties itself; the table is in bar."""
    table = _pressure(
        read_columns(EXAMPLES / "chamber-leak" / "chambers" / "Ultimaker_020" / "pressure.csv")
    )
    time = table["time [s]"] - table["time [s]"][0]
    head = LEAK.replace("0.8 kPa", "0.18 kPa").replace(
        "0.77 kPa; its noise is about one step", "0.63 kPa"
    )
    return free_course(
        "chamber-leak", "A printed chamber that empties itself", time, 100 * table["p [kPa]"], head
    )


def printed_map() -> Rig:
    """A printed table of forces, Martens and Boblan 2017."""
    table = read_columns(EXAMPLES / "static-map" / "map.csv")
    columns = {"p [kPa]": table["p"], "x [mm]": 296 - table["length"], "F [N]": table["F"]}
    within, outside = np.isin(table["p"], [180, 250, 375]), table["p"] > 450

    def part(name: str, kept: np.ndarray) -> Run:
        return Run(name, {k: v[kept] for k, v in columns.items()})

    return Rig(
        name="map-20",
        title="Force of a 20 mm fluidic muscle, printed table",
        signal="F",
        inputs=("p", "x"),
        head=MAP,
        runs={
            "fitted": [part("map", ~within & ~outside)],
            "within": [part("between", within)],
            "outside": [part("above", outside)],
        },
        step=0.0,
        static=True,
    )
