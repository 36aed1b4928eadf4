"""The writer of data sets of any bench: experiment.toml and one CSV file for each run.

Nothing in them says what is hidden.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from rig.benches import RigBench, Signals
from rig.data_set import ROW_GAP
from rig.trial import Trial

COLUMN_UNITS = {"p": ("kPa", 1e-3, 0.0), "x": ("mm", 1e3, 0.0), "s": ("mm", 1e3, 0.0), "F": ("N", 1.0, 0.0),
                "T": ("degC", 1.0, -273.15), "u": ("A", 1.0, 0.0)}  # fmt: skip
"""Unit in the files, factor and shift from SI, by what stands before the first underscore of a column's name."""

PARAMETER_UNITS = {
    "L0": "m", "D0": "m", "t_wall": "m", "h_film": "W/(m2.K)", "m": "kg", "frequency": "Hz", "V": "m3",
    "p_start": "Pa", "T_start": "K", "p_outside": "Pa", "alpha_0": "rad", "c_c": "N", "c_v": "N.s", "J": "kg.m2",
    "x_0": "m", "r": "m", "pulley.d": "N.m.s/rad", "orifice.d": "m",
}  # fmt: skip
"""SI units by a parameter's name or what stands behind its last point; others are plain numbers."""


@dataclass(frozen=True)
class About:
    """What experiment.toml says besides the runs.

    Attributes:
        sigma: standard deviations of the noise by signal [SI]; none are stated where None.
        signals: those that are written. parameters: known values [SI]. free: names to bounds [SI].
        start: how all runs begin, in the words of experiment.toml; nothing is said where None.
    """

    title: str
    signals: Sequence[str]
    sigma: Mapping[str, float] | None
    parameters: Mapping[str, float] = field(default_factory=dict)
    free: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    start: str | None = None


def write(
    folder: Path, bench: RigBench, runs: Sequence[tuple[Trial, Signals]], about: About
) -> None:
    """Write experiment.toml and run-01.csv, ... into a folder, which is made."""
    folder.mkdir(parents=True, exist_ok=True)
    for k, (trial, recorded) in enumerate(runs, start=1):
        (folder / f"run-{k:02d}.csv").write_text(_csv(bench, trial, recorded, about))
    (folder / "experiment.toml").write_text(_experiment(bench, [trial for trial, _ in runs], about))


def with_unit(name: str, value: float) -> str:
    """A parameter's value as TOML writes it."""
    unit = PARAMETER_UNITS.get(name) or PARAMETER_UNITS.get(name.rpartition(".")[2])
    return f'"{value:.9g} {unit}"' if unit else f"{value:.9g}"


def _unit(bench: RigBench, name: str) -> tuple[str, float, float]:
    letter = name.partition("_")[0]
    return (
        ("1", 1.0, 0.0)
        if letter == "u" and bench.name == "SwitchedMuscle"
        else COLUMN_UNITS[letter]
    )


def _held(trial: Trial) -> bool:
    """Whether all that is told is held from sample to sample."""
    return trial.held and (trial.course is None or len(set(trial.course.values)) == 1)


def _told(bench: RigBench, trial: Trial, supply: float, t: float) -> list[float]:
    """All inputs at a time [s], in the order of the columns."""
    values = []
    for k, name in enumerate(bench.inputs):
        if name == bench.course:
            assert trial.course is not None
            values.append(trial.course.at(t)[0])
        else:
            values.append(supply if name == "p_supply" else trial.schedules[k // 2].at(t)[k % 2])
    return values


def _csv(bench: RigBench, trial: Trial, recorded: Signals, about: About) -> str:
    names = [*bench.inputs, *about.signals]
    units = [_unit(bench, name) for name in names]
    columns = ["time [s]", *(name if unit == "1" else f"{name} [{unit}]" for name, (unit, _, _) in
               zip(names, units, strict=True))]  # fmt: skip
    supply = trial.values.get("p_supply", about.parameters.get("p_supply", 0.0))
    missing = [float("nan")] * len(about.signals)
    lines, step_rows = [",".join(columns)], trial.held and not _held(trial)
    for k, t in enumerate(trial.recorded.tolist()):
        told = _told(bench, trial, supply, t)
        if step_rows and k and any(s.at(t - 2e-9) != s.at(t) for s in trial.schedules):
            # the row before the step carries no measurement
            lines.append(
                _row(t - ROW_GAP, [*_told(bench, trial, supply, t - 2e-9), *missing], units)
            )
        lines.append(_row(t, [*told, *(float(recorded[name][k]) for name in about.signals)], units))
    return "\n".join(lines) + "\n"


def _row(t: float, values: Sequence[float], units: Sequence[tuple[str, float, float]]) -> str:
    cells = (
        "" if np.isnan(value) else f"{value * factor + shift:.9g}"
        for value, (_, factor, shift) in zip(values, units, strict=True)
    )
    return ",".join([f"{t:.9g}", *cells])


def _experiment(bench: RigBench, trials: Sequence[Trial], about: About) -> str:
    lines = [f"title = {json.dumps(about.title)}", f'model = "{bench.model}"']
    lines += [f'start = "{about.start}"', ""] if about.start else [""]
    for name in about.signals:
        lines.append(f"[signals.{name}]")
        if about.sigma:
            unit, factor, _ = _unit(bench, name)
            lines.append(
                f'sigma = "{about.sigma[name] * factor:.9g} {"K" if unit == "degC" else unit}"'
            )
        lines.append("")
    inputs = set(bench.inputs)
    known = {name: value for name, value in about.parameters.items() if name not in inputs}
    lines += [
        "[parameters]",
        *(f'"{name}" = {with_unit(name, value)}' for name, value in known.items()),
        "",
    ]
    lines.append("[fit]")
    for name, (low, high) in about.free.items():
        lines.append(
            f'"{name}" = {{ min = {with_unit(name, low)}, max = {with_unit(name, high)} }}'
        )
    for k, trial in enumerate(trials, start=1):
        lines += ["", "[[runs]]", f'file = "run-{k:02d}.csv"', f'role = "{trial.role}"']
        if bench.inputs and _held(trial):
            lines.append('interpolation = "previous"')
        own = {name: value for name, value in trial.values.items() if name not in inputs}
        if own:
            lines += [
                "[runs.parameters]",
                *(f'"{name}" = {with_unit(name, value)}' for name, value in own.items()),
            ]
    return "\n".join(lines) + "\n"
