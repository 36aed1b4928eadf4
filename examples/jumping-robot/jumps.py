"""Makes the data set from the recordings of the jumping robot."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq
from scipy.signal import savgol_filter

from examples.raw_data import write_table

Array = NDArray[np.float64]

JOINTS = ("knee_r", "hip_r", "hip_l", "knee_l")
EXHAUST = (
    0.30  # s, command; not documented: the curves break at 0.32 s, and the inlet valves need 0.02 s
)
END = 0.45  # s
STEP = 0.004  # s
PULLEY = 45.0  # mm, robot_config_2021-04-05.yaml
TENDON = 8.2  # N/mm, robot_config_2021-04-05.yaml
SATURATED = 467.0  # kPa, of the muscles' sensors
SOURCE = """Jumping robot with four pneumatic muscles, run {run}, {joint}: measured by the Borg Lab, Georgia Tech
(github.com/borglab/GTDynamics, examples/example_jumping_robot/system-id-data, commit 2dd29bf, BSD-2-Clause, Copyright
Georgia Tech Research Corporation). Every second sample of 2 ms, outliers left out; contraction from the joint angle,
the tendon and the authors' force law; the command of the exhaust is assumed. p as read: {zero} kPa at ambient."""


@dataclass(frozen=True)
class Recording:
    """One run as recorded: time [s], pressures [kPa, as read], angles [rad] on the same clock, valve times [s]."""

    name: str
    time: Array
    source: Array
    pressure: dict[str, Array]
    angle: dict[str, Array]
    opens: dict[str, float]
    closes: dict[str, float]


def read_recordings(folder: Path) -> list[Recording]:
    """All runs of the folder; the clock of the pressure is zero at the video's first frame, as the authors take it."""
    return [_read(path) for path in sorted(folder.glob("*_pressure_500Hz.csv"))]


def _read(path: Path) -> Recording:
    stem = path.name.removesuffix("_pressure_500Hz.csv")
    pressures = np.genfromtxt(path, delimiter=",", skip_header=1)
    video = np.genfromtxt(path.with_name(f"{stem}_angles_240fps.csv"), delimiter=",", skip_header=1)
    (valve,) = (path.parent / "raw" / stem).glob("*_t_valve.txt")
    times = np.loadtxt(valve, delimiter=",")
    time, frame = pressures[:, 0], video[:, 0] - video[0, 0]
    return Recording(
        stem.split("_2021")[0],
        time,
        pressures[:, 1],
        {j: pressures[:, 2 + i] for i, j in enumerate(JOINTS)},
        {j: np.interp(time, frame, video[:, 1 + i]) for i, j in enumerate(JOINTS)},
        {j: float(times[0, i]) for i, j in enumerate(JOINTS)},
        {j: float(times[1, i]) for i, j in enumerate(JOINTS)},
    )


def without_outliers(p: Array, width: int = 9, limit: float = np.inf) -> Array:
    """NaN where a sample reaches ``limit`` or leaves the running median by more than five times the usual deviation."""
    padded = np.pad(p, width // 2, mode="edge")
    middle = np.median(np.lib.stride_tricks.sliding_window_view(padded, width), axis=1)
    off = np.abs(p - middle)
    return np.where((off > 5 * max(1.0, 1.4826 * float(np.median(off)))) | (p > limit), np.nan, p)


def cleaned(run: Recording, joint: str) -> Array:
    """The muscle's pressure [kPa, as read] without outliers and saturated samples."""
    return without_outliers(run.pressure[joint], limit=SATURATED)


def bridged(p: Array) -> Array:
    """Missing samples bridged by straight lines."""
    there = ~np.isnan(p)
    index = np.arange(len(p))
    return np.interp(index, index[there], p[there])


def zero_of(run: Recording, joint: str) -> float:
    """What the sensor reads before the valve opens [kPa]."""
    return float(np.median(run.pressure[joint][run.time < run.opens[joint] + 0.018]))


def pull(p: float, x: float) -> float:
    """The authors' fitted force of the muscle [N] by gauge pressure [kPa] and contraction [cm].

    Source: SmoothActuatorFactor of GTDynamics (PneumaticActuatorFactors.h): a cubic in x that has the force 1.966 p
    and the slope -0.3554 p at x = 0 and no force and no slope at the contraction without load.
    """
    free = (
        3.05583930
        + 7.58361626e-2 * p
        - 4.91579771e-4 * p**2
        + 1.42792618e-6 * p**3
        - 1.54817477e-9 * p**4
    )
    f_0, k = 1.966409 * p, 0.35541599 * p
    if p <= 0 or x >= free:
        return 0.0
    if x < 0:
        return f_0 - k * x
    c = (2 * k * free - 3 * f_0) / free**2
    d = (-k * free + 2 * f_0) / free**3
    return f_0 - k * x + c * x**2 + d * x**3


def free_contraction(p: float) -> float:
    """The contraction without load [cm] of the same law."""
    return (
        3.05583930
        + 7.58361626e-2 * p
        - 4.91579771e-4 * p**2
        + 1.42792618e-6 * p**3
        - 1.54817477e-9 * p**4
    )


def contraction(run: Recording, joint: str) -> Array:
    """Contraction [mm]: travel of the pulley and stretch of the tendon; a slack tendon leaves it where no load does."""
    p = bridged(cleaned(run, joint)) - zero_of(run, joint)
    angle = run.angle[joint]
    travel = PULLEY / 10 * np.abs(angle - np.mean(angle[:5]))
    contractions = np.array(
        [_held(max(0.0, float(a)), float(b)) for a, b in zip(p, travel, strict=True)]
    )
    smooth: Array = savgol_filter(10 * contractions, 11, 2)
    return np.maximum(smooth, 0.0)


def _held(p: float, travel: float) -> float:
    if p < 1.0 or travel >= free_contraction(p):
        return min(travel, free_contraction(p))
    return float(
        brentq(lambda x: x - travel - pull(p, x) / (10 * TENDON), travel - 1.0, travel + 20.0)
    )


def columns(run: Recording, joint: str) -> dict[str, Array]:
    """The table of one muscle in one run: every second sample, and two rows where a valve is switched."""
    kept = (run.time <= END) & (np.arange(len(run.time)) % 2 == 0)
    p = cleaned(run, joint)
    source, s = bridged(without_outliers(run.source)), contraction(run, joint)
    switches = np.array(
        [t + d for t in (run.opens[joint], run.closes[joint], EXHAUST) for d in (0.0, 1e-5)]
    )
    switches = switches[switches > run.time[0]]
    time = np.unique(np.concatenate([run.time[kept], np.round(switches, 5)]))
    at = {float(t): float(v) for t, v in zip(run.time[kept], p[kept], strict=True)}
    shut, opened = run.closes[joint], run.opens[joint]
    return {
        "time [s]": time,
        "u_in [1]": ((time > opened) & (time <= shut)).astype(float),
        "u_out [1]": (time > EXHAUST).astype(float),
        "p_supply [kPa]": np.interp(time, run.time, source),
        "s [mm]": np.interp(time, run.time, s),
        "p [kPa]": np.array([at.get(float(t), np.nan) for t in time]),
    }


def write_runs(folder: Path, runs: list[Recording]) -> None:
    """One table per run for the left hip, and the left knee of the run in which knees and hips differ."""
    for run in runs:
        for joint in ("hip_l", "knee_l") if run.name.startswith("0p02") else ("hip_l",):
            text = SOURCE.format(run=run.name, joint=joint, zero=f"{zero_of(run, joint):.3g}")
            write_table(folder / file_name(run.name, joint), columns(run, joint), text)


def file_name(run: str, joint: str) -> str:
    """0p00_0p09_hipknee-80source, hip_l -> 0p09-80-hip_l.csv"""
    timing, source = (
        run.removesuffix("source").split("-")[0],
        run.removesuffix("source").split("-")[-1],
    )
    return f"{timing.split('_')[1] if timing.startswith('0p00') else '0p02'}-{source}-{joint}.csv"
