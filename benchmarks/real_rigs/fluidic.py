"""Fluidic muscles of 20 mm: force at held lengths under a pulsed pressure, and how they leak (Portland State)."""

from __future__ import annotations

import io
from collections.abc import Sequence

import numpy as np
from scipy.io import loadmat

from benchmarks.real_rigs.folders import Array, Rig, Run
from benchmarks.real_rigs.sources import Store

FOLDER = "BPA_Static_Characterization_Test/DataCollection/AllData_raw_csv"
LEAKS = "Leak-Fill_tests/Leak_Experiments"
FOLDERS = (FOLDER, LEAKS)
BIN = 0.05  # s
BENCH = "IsometricRig.mo"
# contraction [mm] as the authors measured it, and what they call it
HELD = {
    30: {0: "Unkinked", 13: "Kinked14mm", 22: "Kinked23mm", 33: "Kinked34mm"},
    40: {0: "Unkinked", 36: "Kinked35mm", 47: "Kinked46mm", 70: "Kinked69mm"},
}
REST = {30: 274, 40: 398}  # mm, length without pressure
GAIN, ZERO = 0.7654, -18.609  # kPa per step of the converter and at zero, the authors' calibration
PART = 0.75  # of the first pressure, down to which a leak is fitted
HEAD = f"""model = "{BENCH}"

# Steps of the load cell's converter are 1.74 N; its zero differs by some newtons from test to test.
[signals.F]
sigma = "2 N"

[parameters]
"muscle.L0" = "REST mm"

[fit]
"muscle.D0" = {{ min = "10 mm", max = "40 mm" }}
"muscle.turns" = {{ min = 0.5, max = 5 }}
"""
STATIC = """model = "PneumaticMuscle.Benches.QuasiStaticIsometric"
kind = "static"

[signals.F]
sigma = "5 N"

[parameters]
"muscle.L0" = "398 mm"

[fit]
"muscle.D0" = { min = "15 mm", max = "40 mm" }
"muscle.turns" = { min = 0.5, max = 5 }
"""
LEAK = """model = "PneumaticMuscle.Benches.ClosedVessel"

# Steps of the converter are 0.77 kPa; its noise is about one step.
[signals.p]
sigma = "0.8 kPa"

# The volume is not documented: 100 mL stands for it. Only leak over volume can be found.
[parameters]
"tank.V" = "100 ml"
"tank.p_start" = "START kPa"

[fit]
"tank.p_start" = { min = "LOW kPa", max = "HIGH kPa" }
"tank.n" = { min = 1.0, max = 1.4 }
"""


def recording(store: Store, length: int, contraction: int, test: int) -> Array:
    """One test, (n, 3): time [s], pressure [kPa] and force [N], means over intervals of time."""
    stem = f"{FOLDER}/20mm_{length}cm_{HELD[length][contraction]}_Test{test}"
    paths = store.paths(FOLDER)
    (path,) = [p for p in paths if p in (f"{stem}.csv", f"{stem}Data.csv")]
    raw = np.loadtxt(io.BytesIO(store.read(path)), delimiter=",")[:, [2, 1, 0]]
    number = np.floor(raw[:, 0] / BIN).astype(int)
    return np.array([raw[number == n].mean(axis=0) for n in np.unique(number)])


def run_of(store: Store, length: int, contraction: int, test: int) -> Run:
    """One test as a run with the held contraction as an input."""
    time, p, pull = recording(store, length, contraction, test).T
    held = np.full(len(time), float(contraction))
    return Run(
        f"x{contraction}-test{test}",
        {"time [s]": time - time[0], "p [kPa]": p, "s [mm]": held, "F [N]": pull},
        parameters={"drive.s_start": f"{contraction} mm"},
    )


def isometric(store: Store, bench: str, tests: Sequence[int] = (3, 7), name: str = "muscle") -> Rig:
    """The muscle of 274 mm at held lengths; ``tests`` are the two that are fitted."""
    fitted = [run_of(store, 30, x, t) for x in (0, 22) for t in tests]
    others = [t for t in (3, 7, 4, 8, 5) if t not in tests][-3:]
    within = [run_of(store, 30, x, t) for x in (0, 22) for t in others]
    within += [run_of(store, 30, 13, t) for t in (3, 7)]
    return Rig(
        name=name,
        title="Force of a 20 mm fluidic muscle at held lengths",
        signal="F",
        inputs=("p", "s"),
        head=HEAD.replace("REST", str(REST[30])),
        runs={
            "fitted": fitted,
            "within": within,
            "outside": [run_of(store, 30, 33, t) for t in (3, 7)],
        },
        step=BIN,
        repeats=tuple(
            (f"x{x}-test{a}", f"x{x}-test{b}") for x in (0, 22) for a, b in ((3, 4), (7, 8))
        ),
        files={BENCH: bench},
    )


def static_map(store: Store) -> Rig:
    """Points of a slow inflation of the muscle of 398 mm, every 20 kPa."""

    def points(contraction: int) -> Run:
        rows = []
        for test in (9, 10):
            table = recording(store, 40, contraction, test)
            rising = table[: int(np.argmax(table[:, 1]))]
            for p in np.arange(40.0, 601.0, 20.0):
                near = rising[np.abs(rising[:, 1] - p) < 4]
                if len(near):
                    rows.append([p + float(np.mean(near[:, 1] - p)), float(np.mean(near[:, 2]))])
        table = np.array(rows)
        held = np.full(len(table), float(contraction))
        return Run(
            f"x{contraction}", {"p [kPa]": table[:, 0], "x [mm]": held, "F [N]": table[:, 1]}
        )

    return Rig(
        name="map-398",
        title="Force of a 20 mm fluidic muscle of 398 mm by pressure and length",
        signal="F",
        inputs=("p", "x"),
        head=STATIC,
        runs={"fitted": [points(0), points(47)], "within": [points(36)], "outside": [points(70)]},
        step=0.0,
        static=True,
    )


def leak(store: Store, experiment: int) -> Rig:
    """The shut muscle that empties itself: the run down to a part of its first pressure, and all of it."""
    data = loadmat(
        io.BytesIO(store.read(f"{LEAKS}/Experiment{experiment}Leak.mat")), variable_names=["data"]
    )["data"]
    shut = data[np.asarray(data[:, 1]) == 0].astype(float)
    time, p = (shut[:, 0] - shut[0, 0]) / 1e3, GAIN * shut[:, 2] + ZERO
    return free_course(
        f"muscle-leak-{experiment}",
        f"Leak of a shut muscle, experiment {experiment}",
        time,
        p,
        LEAK,
    )


def free_course(name: str, title: str, time: Array, p: Array, head: str) -> Rig:
    """A course without inputs, fitted at its head and scored at its tail; pressures in kPa."""
    cut = int(np.argmax(p < PART * p[0]))
    if cut == 0:
        raise ValueError(f"{name} never falls to {PART} of its first pressure")
    words = {"START": f"{p[0]:.5g}", "LOW": f"{0.97 * p[0]:.5g}", "HIGH": f"{1.03 * p[0]:.5g}"}
    for word, value in words.items():
        head = head.replace(word, value)
    columns = {"time [s]": time, "p [kPa]": p}
    first = {k: v[:cut] for k, v in columns.items()}
    return Rig(
        name=name,
        title=title,
        signal="p",
        inputs=(),
        head=head,
        runs={
            "fitted": [Run("first", first)],
            "outside": [Run("whole", columns, score_from=float(time[cut]))],
        },
        step=float(np.median(np.diff(time))),
    )
