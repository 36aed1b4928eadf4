"""Hoses of one to eight metres, filled and vented at one end, pressure read at the other (Sojoodi Farimani, 2018)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from benchmarks.real_rigs.folders import Array, Rig, Run
from benchmarks.real_rigs.sources import Store

FOLDER = "Fig6/Fig6_data"
BIN = 0.01  # s; samples of many passes are pooled into means over this
COLUMNS = 5  # time [ms], pressure at the valve and at the closed end [bar gauge], two of the logger
BENCH = """within;
model HoseRig "A valve fills and vents a hose, and what is at its closed end"
  extends PneumaticMuscle.Icons.Bench;
  input Real u_in(start=1, unit="1") "Command to fill: 0 or 1";
  input Real u_out(start=0, unit="1") "Command to vent: 0 or 1";
  input PneumaticMuscle.Types.GaugePressure p_supply(start=500e3) "Gauge pressure of the supply";
  output PneumaticMuscle.Types.GaugePressure p "Gauge pressure at the closed end";
  replaceable model Manometer = PneumaticMuscle.Instruments.Sensors.GaugePressure
    constrainedby PneumaticMuscle.Interfaces.Manometer "Pressure transducer";
  replaceable model Line = PneumaticMuscle.Laws.Lines.DirectLine
    constrainedby PneumaticMuscle.Interfaces.Line "What is between the valve and the volume";
  replaceable model PressureChannel = PneumaticMuscle.Instruments.Sensors.DirectPressure
    constrainedby PneumaticMuscle.Interfaces.PressureChannel "Measuring channel of the pressure";
  replaceable model Recorder = PneumaticMuscle.Instruments.Sensors.SharedClock
    constrainedby PneumaticMuscle.Interfaces.Recorder "Recorder of the readings";
  inner PneumaticMuscle.Ambient ambient "Surroundings";
  PneumaticMuscle.Pneumatics.Components.Supply supply(p_gauge=p_supply) "Supply";
  PneumaticMuscle.Pneumatics.Components.Atmosphere atmosphere "Outlet";
  PneumaticMuscle.Pneumatics.Components.ValvePair valve(u_in=u_open*u_in, u_out=u_open*u_out, C_A=0.7) "Valve";
  Line line "What is between the valve and the volume";
  PneumaticMuscle.Pneumatics.Components.Tank vessel(V=50e-6, startIsReference=true) "Volume that is filled";
  Manometer manometer "Pressure transducer";
  PressureChannel channel_p(u=manometer.p) "Measuring channel of the pressure";
  Recorder recorder "Recorder of the readings";
protected
  constant PneumaticMuscle.Types.Current u_open = (3e-6 + 2.61e-7)/1.80e-6 "Current at which DP (62) opens 3 mm2";
equation
  connect(supply.port, valve.supply);
  connect(valve.exhaust, atmosphere.port);
  connect(valve.port, line.port_a);
  connect(line.port_b, vessel.port);
  connect(vessel.port, manometer.port);
  p = channel_p.y;
end HoseRig;
"""
HEAD = """model = "HoseRig.mo"

# The converter's steps are 12.2 mbar: 12.2/sqrt(12).
[signals.p]
sigma = "3.5 mbar"

# The bore is not documented, so that only areas over volumes are told: 50 mL stand for the volume.
[parameters]
"vessel.V" = "50 ml"
"valve.C_A" = 0.7
"vessel.n" = 1.2

[fit]
"valve.C_A" = { min = 0.1, max = 3 }
"vessel.n" = { min = 1.0, max = 1.4 }
"""


def passes(content: bytes) -> list[Array]:
    """The passes of a file, (n, 3) each: time [s], pressure at the valve and at the end [bar].

    The logger restarts its clock at every pass. Lines that it garbled are left out, and the first and the last pass,
    which may be cut.
    """
    rows = []
    for line in content.decode("latin-1").splitlines():
        cells = line.split(",")
        if len(cells) == COLUMNS and all(_number(c) for c in cells):
            rows.append([float(c) for c in cells[:3]])
    table = np.array(rows)
    parts = np.split(table, np.flatnonzero(np.diff(table[:, 0]) < 0) + 1)[1:-1]
    return [p * [1e-3, 1, 1] for p in parts if len(p) >= 4 and p[0, 0] <= 5]


def pooled(parts: Sequence[Array]) -> Array:
    """Means of all samples of some passes over intervals of time, (m, 3)."""
    samples = np.concatenate(list(parts))
    number: NDArray[np.intp] = np.floor(samples[:, 0] / BIN).astype(int)
    means: list[Array] = []
    for n in np.unique(number):
        own = samples[number == n]
        if len(own) >= max(2, len(parts) // 8):  # lone stragglers of a pass that was longer
            means.append(own.mean(axis=0))
    return np.array(means)


def run_of(store: Store, length: int, bar: int, phase: str, half: str) -> Run:
    """Filling ("start") or venting ("end") of one hose at one pressure, of the odd ("a") or even ("b") passes."""
    files = store.paths(FOLDER)
    stem = f"{FOLDER}/tube_l{length}_p{bar}_{phase}"
    (path,) = [f for f in files if f in (f"{stem}.csv", f"{stem}_1.csv")]
    parts = passes(store.read(path))[0 if half == "a" else 1 :: 2]
    table = pooled(parts)
    filling = phase == "start"
    settled = np.concatenate([p[-max(1, len(p) // 5) :, 1] for p in parts])
    supply = float(np.median(settled) if filling else np.median([p[0, 2] for p in parts]))
    ones = np.ones(len(table))
    return Run(
        f"l{length}-p{bar}-{'fill' if filling else 'vent'}-{half}",
        {
            "time [s]": np.concatenate([[0.0], table[1:, 0]]),
            "u_in [1]": ones * filling,
            "u_out [1]": ones * (not filling),
            "p_supply [bar]": ones * supply,
            "p [bar]": table[:, 2],
        },
        parameters={"vessel.p_start": f"{0.0 if filling else supply:.5g} bar"},
    )


def rig(store: Store, length: int) -> Rig:
    """The rig of one hose."""

    def group(bars: Sequence[int], halves: str) -> list[Run]:
        return [
            run_of(store, length, b, phase, h)
            for b in bars
            for phase in ("start", "end")
            for h in halves
        ]

    repeats = tuple(
        (f"l{length}-p{b}-{w}-a", f"l{length}-p{b}-{w}-b") for b in (2, 4) for w in ("fill", "vent")
    )
    return Rig(
        name="hose" if length == 8 else f"hose-{length}m",
        title=f"Closed end of {length} m of hose",
        signal="p",
        inputs=("u_in", "u_out", "p_supply"),
        head=HEAD,
        runs={
            "fitted": group((2, 4), "a"),
            "within": [*group((2, 4), "b"), *group((3,), "ab")],
            "outside": group((5, 6, 7), "a"),
        },
        step=BIN,
        repeats=repeats,
        files={"HoseRig.mo": BENCH},
    )


def _number(cell: str) -> bool:
    try:
        return bool(np.isfinite(float(cell)))
    except ValueError:
        return False
