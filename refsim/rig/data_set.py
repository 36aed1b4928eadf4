"""The writer of data sets: experiment.toml and one CSV file for each run, as the software reads them.

Nothing in them says what is hidden.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from rig.integrate import Array
from rig.schedule import Schedule

COLUMNS = {"p": ("kPa", 1e-3, 0.0), "x": ("mm", 1e3, 0.0), "T": ("degC", 1.0, -273.15)}
"""Unit in the files, factor and shift from SI."""

ROW_GAP = 1e-6  # s, between the two rows of a step


@dataclass(frozen=True)
class Recording:
    """One run as recorded.

    Attributes:
        schedule: of the currents. p_supply: Pa gauge. role: fit or holdout.
        time: shape (samples,) [s]. signals: by name, shape (samples,) [SI]; NaN where a sample is missing.
        load: mass [kg] that [runs.parameters] states; None where it is free.
        interpolation: of the inputs between the samples, linear or previous.
    """

    schedule: Schedule
    p_supply: float
    role: str
    time: Array
    signals: Mapping[str, Array]
    load: float | None = None
    interpolation: str = "previous"


@dataclass(frozen=True)
class Description:
    """What experiment.toml says besides the runs.

    Attributes:
        title: of the data set. sigma: standard deviations of the noise by signal [SI]; none are stated where None.
        signals: those that are written, in order.
        parameters: names to known values, free: names to bounds, both as TOML writes them.
    """

    title: str
    sigma: Mapping[str, float] | None
    signals: Sequence[str] = tuple(COLUMNS)
    parameters: Mapping[str, str] = field(default_factory=dict)
    free: Mapping[str, tuple[str, str]] = field(default_factory=dict)


def write(
    folder: Path, runs: Sequence[Recording], description: Description, step_rows: bool = False
) -> None:
    """Write experiment.toml and run-01.csv, ... into a folder, which is made.

    With `step_rows` a step of the currents is two rows ROW_GAP apart, the first without measurements, and the inputs
    are lines between rows.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for k, run in enumerate(runs, start=1):
        (folder / _file(k)).write_text(_csv(run, description.signals, step_rows))
    (folder / "experiment.toml").write_text(_experiment(runs, description, step_rows))


def _file(k: int) -> str:
    return f"run-{k:02d}.csv"


def _csv(run: Recording, names: Sequence[str], step_rows: bool) -> str:
    supply = f"{run.p_supply / 1e3:.9g}"
    columns = [
        "time [s]",
        "u_in [A]",
        "u_out [A]",
        "p_supply [kPa]",
        *(f"{n} [{COLUMNS[n][0]}]" for n in names),
    ]
    lines = [",".join(columns)]
    for k, t in enumerate(run.time.tolist()):
        u_in, u_out = run.schedule.at(t)
        before = run.schedule.at(t - 2e-9) if step_rows and k else (u_in, u_out)
        if before != (u_in, u_out):  # the row before the step carries no measurement
            old = [f"{t - ROW_GAP:.9g}", f"{before[0]:.9g}", f"{before[1]:.9g}", supply]
            lines.append(",".join([*old, *("" for _ in names)]))
        values = [run.signals[n][k] * COLUMNS[n][1] + COLUMNS[n][2] for n in names]
        new = [f"{t:.9g}", f"{u_in:.9g}", f"{u_out:.9g}", supply]
        lines.append(",".join([*new, *("" if np.isnan(y) else f"{y:.9g}" for y in values)]))
    return "\n".join(lines) + "\n"


def _experiment(runs: Sequence[Recording], about: Description, step_rows: bool) -> str:
    lines = [f"title = {json.dumps(about.title)}", 'model = "PneumaticMuscle.Benches.Isotonic"', ""]
    for name in about.signals:
        unit, factor, _ = COLUMNS[name]
        lines += [f"[signals.{name}]"]
        if about.sigma:
            lines += [f'sigma = "{about.sigma[name] * factor:.9g} {"K" if name == "T" else unit}"']
        lines += [""]
    if about.parameters:
        lines += [
            "[parameters]",
            *(f'"{name}" = {value}' for name, value in about.parameters.items()),
            "",
        ]
    lines += [
        "[fit]",
        *(
            f'"{name}" = {{ min = {low}, max = {high} }}'
            for name, (low, high) in about.free.items()
        ),
    ]
    for k, run in enumerate(runs, start=1):
        lines += ["", "[[runs]]", f'file = "{_file(k)}"', f'role = "{run.role}"']
        if run.interpolation != "linear" and not step_rows:
            lines.append(f'interpolation = "{run.interpolation}"')
        if run.load is not None:
            lines += ["[runs.parameters]", f'"load.m" = "{run.load:.9g} kg"']
    return "\n".join(lines) + "\n"
