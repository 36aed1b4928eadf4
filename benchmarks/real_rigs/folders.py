"""What a rig is on disk: three data sets of this project, and one JSON file that says what is in them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
ROLES = ("fitted", "within", "outside")
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


@dataclass(frozen=True)
class Run:
    """One run: columns with units in their names, scored from a time on, with parameters of its own; do inputs step?"""

    name: str
    columns: Mapping[str, Array]
    score_from: float = -np.inf
    parameters: Mapping[str, str] = field(default_factory=dict)
    steps: bool = False


@dataclass(frozen=True)
class Rig:
    """A rig: its runs by role, what is measured and imposed, and the head of its experiment.toml, with more by role.

    ``library`` is a folder below ``examples`` with the Modelica library of its bench, where it has one of its own.
    """

    name: str
    title: str
    signal: str
    inputs: tuple[str, ...]
    head: str
    runs: Mapping[str, Sequence[Run]]
    step: float
    repeats: tuple[tuple[str, str], ...] = ()
    static: bool = False
    files: Mapping[str, str] = field(default_factory=dict)
    heads: Mapping[str, str] = field(default_factory=dict)
    library: str = ""


def write_rig(folder: Path, rig: Rig) -> None:
    """Writes ``folder/NAME/{fitted,within,outside}`` and ``folder/NAME/rig.json``."""
    place = folder / rig.name
    described: dict[str, object] = {
        "title": rig.title,
        "signal": rig.signal,
        "inputs": rig.inputs,
        "step": rig.step,
        "static": rig.static,
        "repeats": rig.repeats,
        "library": rig.library,
        "runs": {
            role: {r.name: max(r.score_from, -1e9) for r in rig.runs.get(role, ())}
            for role in ROLES
        },
    }
    for role in ROLES:
        runs = rig.runs.get(role, ())
        if not runs:
            continue
        target = place / role
        target.mkdir(parents=True, exist_ok=True)
        for name, text in rig.files.items():
            (target / name).write_text(text, encoding="utf-8")
        for run in runs:
            (target / f"{run.name}.csv").write_text(_table(run.columns), encoding="utf-8")
        (target / "experiment.toml").write_text(_experiment(rig, role, runs), encoding="utf-8")
    (place / "rig.json").write_text(json.dumps(described, indent=1) + "\n", encoding="utf-8")


def read_columns(path: Path) -> dict[str, Array]:
    """The columns of a table by their names without units; an empty cell is not a number."""
    lines = [
        line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")
    ]
    names = [c.split("[")[0].strip() for c in lines[0].split(",")]
    cells = [[float(c) if c.strip() else np.nan for c in line.split(",")] for line in lines[1:]]
    return dict(zip(names, np.array(cells).T, strict=True))


def _experiment(rig: Rig, role: str, runs: Sequence[Run]) -> str:
    # a data set needs a run to fit; nothing is ever fitted to those of "within" and "outside"
    lines = [f'title = "{rig.title}: {role}"', rig.head.strip(), rig.heads.get(role, ""), ""]
    for run in runs:
        lines += ["[[runs]]", f'file = "{run.name}.csv"', 'role = "fit"']
        if run.steps:
            lines.append('interpolation = "previous"')
        if run.parameters:
            lines += ["[runs.parameters]", *(f'"{k}" = "{v}"' for k, v in run.parameters.items())]
        lines.append("")
    return "\n".join(lines)


def _table(columns: Mapping[str, Array]) -> str:
    rows = zip(*columns.values(), strict=True)
    cells = [",".join("" if np.isnan(v) else f"{v:.7g}" for v in row) for row in rows]
    return "\n".join([",".join(columns), *cells]) + "\n"
