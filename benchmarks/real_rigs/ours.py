"""Runs this software on the rigs of a folder: python -m benchmarks.real_rigs.ours FOLDER [RIG ...].

Three results a rig: the bench of the rig, fitted; the model that the diagnosis ends with, whatever its verdict; that
model with the learned term. Only ``fitted`` is read before the parameters are final. Writes
``FOLDER/results/RIG.METHOD.json`` and ``.npz``, and the models and what was said into ``FOLDER/models/RIG``.
"""

from __future__ import annotations

import itertools
import json
import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from time import process_time

import numpy as np

import pam_cosim as pam
from benchmarks.real_rigs.folders import ROLES, Array
from benchmarks.real_rigs.rivals import write_result
from benchmarks.real_rigs.rows import Course, Rows, read_rows
from benchmarks.real_rigs.table import REPEATS, RIGS
from pam_cosim.comparison import Comparison
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.files import write_text
from pam_cosim.fitting import Fit
from pam_cosim.model.references import is_ratio
from pam_cosim.study.fitted_model import fitted_model

VERSION = f"pam-cosim {version('pam-cosim')}"


def predictions(
    rows: Rows, folder: Path, model: Path, files: Sequence[Path], values: Mapping[str, float]
) -> dict[str, dict[str, Array]]:
    """What a model says of every course, in the rows' own unit; a role that cannot be simulated is missing."""
    found: dict[str, dict[str, Array]] = {}
    for role in ROLES:
        if rows.courses[role]:
            try:
                compared = pam.compare(
                    pam.read(folder / role, files=files), str(model), values, files=files
                )
            except (InputError, SimulationFailure) as error:
                print(f"{rows.name} {role}: {error}", file=sys.stderr)
                continue
            found[role] = {c.name: _of_course(c, rows.signal, compared) for c in rows.courses[role]}
    return found


def _of_course(course: Course, signal: str, compared: Comparison) -> Array:
    """(n,) at the course's rows; points at rest are found again by what was imposed and measured."""
    own = [
        r
        for r in compared.runs
        if r.run.name == course.name or r.run.name.startswith(f"{course.name} ")
    ]
    measured = np.concatenate([r.run.measurements[signal] for r in own])
    values = np.concatenate([r.model[signal] for r in own])
    unit = 10 ** np.round(
        np.log10(np.nanmax(np.abs(measured)) / np.nanmax(np.abs(course.measured)))
    )
    if len(own) == 1 and len(values) == len(course.time) and np.any(course.time):
        return np.asarray(values / unit)
    imposed = np.concatenate([np.column_stack(list(r.run.inputs.values())) for r in own])
    keys = np.column_stack([imposed, measured])
    wanted = np.column_stack([course.inputs, course.measured])
    scaled = [table / np.maximum(np.abs(table).max(axis=0), 1e-12) for table in (keys, wanted)]
    nearest = [int(np.argmin(((scaled[0] - row) ** 2).sum(axis=1))) for row in scaled[1]]
    return np.asarray(values[nearest] / unit)


def run_rig(folder: Path, results: Path) -> None:
    """The three results of one rig."""
    rows = read_rows(folder)
    place = results.parent / "models" / rows.name
    place.mkdir(parents=True, exist_ok=True)
    for method in ("base", "verdict", "learned"):
        (results / f"{rows.name}.{method}.json").unlink(missing_ok=True)
    files = [*rows.library, *(folder / "fitted").glob("*.mo")]
    data = pam.read(folder / "fitted", files=rows.library)
    begun = process_time()
    fit = pam.fit(data, files=rows.library)
    pam.add(fit, output=place / "Base.mo", files=files)
    _write(results, rows, "base", place / "Base.mo", files, _said(fit, process_time() - begun, ""))
    diagnosis = pam.diagnose(
        data, files=rows.library, workers=1, say=lambda line: print(f"  {line}", flush=True)
    )
    write_text(place / "verdict.txt", f"{diagnosis}\n")
    pam.save(diagnosis, place / "verdict.npz")
    pam.add(diagnosis, output=place / "Verdict.mo", files=files)
    families = "+".join(sorted({c.family for c in diagnosis.path})) or "none"
    said = _said(diagnosis.final, 0.0, f"{diagnosis.verdict.kind}: {families}")
    said["effects"] = [c.effect for c in diagnosis.path]
    said["named"] = [*diagnosis.verdict.families]
    said["probability"] = diagnosis.verdict.probability
    # what it says of the data set is no part of the model: a ratio to a stated parameter
    ratios = {n: v for n, v in fitted_model(diagnosis).of_the_data.items() if "@" not in n}
    _write(results, rows, "verdict", place / "Verdict.mo", files, said, ratios)
    learned = diagnosis.learned
    if learned is None:
        return
    write_text(place / f"{learned.term.name}.mo", learned.term.modelica_source)
    pam.add(diagnosis, output=place / "Learned.mo", files=files, learned=True)
    said = _said(learned.model.fit, 0.0, learned.term.formula) | {
        "effects": list(learned.model.effects)
    }
    ratios = {n: v for n, v in learned.model.fit.values.items() if is_ratio(n)}
    _write(results, rows, "learned", place / "Learned.mo", files, said, ratios)


def _said(fit: Fit, seconds: float, reading: str) -> dict[str, object]:
    return {
        "version": VERSION,
        "coefficients": len(fit.parameters),
        "seconds": seconds,
        "reading": reading,
    }


def _write(
    results: Path,
    rows: Rows,
    method: str,
    model: Path,
    files: Sequence[Path],
    about: dict[str, object],
    values: Mapping[str, float] | None = None,
) -> None:
    try:
        predicted = predictions(rows, results.parent / rows.name, model, files, values or {})
    except (InputError, SimulationFailure) as error:
        about, predicted = about | {"failed": str(error)}, {}
    write_result(results, rows, method, about, predicted)
    print(rows.name, method, about, flush=True)


def timed(folder: Path, name: str) -> None:
    """One rig in a process of its own, whose time, workers included, is written into the results."""
    command = [sys.executable, "-m", "benchmarks.real_rigs.ours", str(folder), "--alone", name]
    with subprocess.Popen(command) as process:
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"{name}: exit status {process.returncode}")
    for method in ("verdict", "learned"):
        path = folder / "results" / f"{name}.{method}.json"
        if path.is_file():
            said = json.loads(path.read_text(encoding="utf-8")) | {
                "seconds": used.ru_utime + used.ru_stime
            }
            path.write_text(json.dumps(said, indent=1) + "\n", encoding="utf-8")


def main(folder: Path, names: Sequence[str]) -> None:
    """Some rigs (default: those of the table and the repeats of the verdict)."""
    if names and names[0] == "--alone":
        run_rig(folder / names[1], folder / "results")
        return
    for name in names or sorted({*RIGS, *itertools.chain(*REPEATS.values())}):
        timed(folder, name)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])
