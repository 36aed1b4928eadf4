"""How often bands of predictions hold on real rigs: python -m benchmarks.real_rigs.bands FOLDER [RIG ...].

Needs the diagnoses that ``ours`` saved. Each run within and outside what was fitted is predicted with the model of the
verdict, whatever that says. Counted are the readings inside their 95 % band, and the runs whose mean over time is: with
parameters and noise alone, with the model error that the fitted runs show, and, for runs outside, with the one that
those within show as held-out runs. The diagnosis has seen none of them. Prints Markdown.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import pam_cosim as pam
from benchmarks.predictive_bands.half_widths import with_discrepancy
from benchmarks.real_rigs.folders import ROLES, Array
from benchmarks.real_rigs.rows import library_of
from benchmarks.real_rigs.table import RIGS
from pam_cosim.comparison import RunComparison
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fitting import Band, Discrepancy, discrepancies
from pam_cosim.fitting.discrepancy import TAIL
from pam_cosim.measurement import DataSet, Run

SAMPLES = 100
WITHOUT, FITTED, HELD_OUT = "parameters and noise", "fitted runs", "held-out runs"


@dataclass(frozen=True)
class Share:
    """Of one run and signal: readings inside, whether the mean over time is, half width in per cent of the range."""

    role: str
    kind: str
    inside: float
    mean: bool
    width: float


def shares(folder: Path, name: str) -> list[Share]:
    """Of all runs of a rig that were not fitted; one that cannot be simulated has none of its readings inside."""
    diagnosis = pam.load(folder / "models" / name / "verdict.npz")
    assert isinstance(diagnosis, Diagnosis)
    about = json.loads((folder / name / "rig.json").read_text(encoding="utf-8"))
    files = [*library_of(about), *(folder / name / "fitted").glob("*.mo")]
    runs = {role: _runs(folder / name / role, role, about, files) for role in ROLES[1:]}
    every = (*diagnosis.data.runs, *runs["within"], *runs["outside"])
    judged = replace(diagnosis, data=replace(diagnosis.data, runs=every))
    final, data = diagnosis.final, diagnosis.data
    fitted = discrepancies(final.comparison.runs, data.signals, final.freedom)
    known: dict[str, dict[str, Discrepancy]] = {WITHOUT: {}, FITTED: fitted}
    found: list[Share] = []
    for role, own in runs.items():
        compared = []
        for run in own:
            said = _predicted(judged, run, files)
            kept = run.time >= about["runs"][role][run.name]
            span = _ranges(every)
            for kind, off in known.items():
                found += [
                    _share(role, kind, said.get(n), fitted.get(n), off.get(n), run, kept, n, span)
                    for n in data.fitted_signals
                    if run.sample_count(n)
                ]
            if said:
                compared.append(RunComparison(run, {n: b.value for n, b in said.items()}))
        if role == "within" and compared:
            known[HELD_OUT] = discrepancies(compared, data.signals, final.freedom)
    return found


def _runs(
    folder: Path, role: str, about: Mapping[str, Mapping[str, object]], files: Sequence[Path]
) -> list[Run]:
    if not about["runs"][role]:
        return []
    data: DataSet = pam.read(folder, files=files)
    return [replace(run, role="holdout") for run in data.runs]


def _predicted(judged: Diagnosis, run: Run, files: Sequence[Path]) -> dict[str, Band]:
    try:
        return pam.predict(judged, run=run.name, samples=SAMPLES, files=files).bands
    except (InputError, SimulationFailure) as error:
        print(f"{run.name}: {error}", file=sys.stderr)
        return {}


def _ranges(runs: Sequence[Run]) -> dict[str, float]:
    names = {name for run in runs for name in run.measurements}
    values = {
        n: np.concatenate([r.measurements[n] for r in runs if n in r.measurements]) for n in names
    }
    return {n: float(np.nanmax(v) - np.nanmin(v)) for n, v in values.items()}


def _share(
    role: str,
    kind: str,
    band: Band | None,
    in_band: Discrepancy | None,
    off: Discrepancy | None,
    run: Run,
    kept: Array,
    name: str,
    span: Mapping[str, float],
) -> Share:
    """The band was made with one discrepancy, which is taken out of it before another one is added."""
    if band is None:
        return Share(role, kind, 0.0, False, np.nan)
    width = with_discrepancy((band.reading_high - band.reading_low) / 2, in_band, off)
    centre = (band.reading_high + band.reading_low) / 2
    miss = np.abs(run.measurements[name] - centre)
    at = np.isfinite(miss) & kept
    duration = float(np.ptp(run.time))
    of_mean = with_discrepancy((band.mean_high - band.mean_low) / 2, in_band, off, duration)
    error = run.measurements[name] - centre
    there = np.isfinite(error)
    mean = float(np.trapezoid(error[there], run.time[there])) / float(np.ptp(run.time[there]))
    return Share(
        role,
        kind,
        float(np.mean(miss[at] <= width[at])),
        bool(abs(mean) <= of_mean),
        float(np.median(width[at])) / span[name],
    )


def line(name: str, found: Sequence[Share]) -> str:
    """Markdown: within and outside, by kind: readings inside, means inside, half width."""
    cells = [name]
    for role in ROLES[1:]:
        for kind in (WITHOUT, FITTED, HELD_OUT):
            own = [s for s in found if s.role == role and s.kind == kind]
            if not own:
                cells.append("")
                continue
            inside = 100 * float(np.mean([s.inside for s in own]))
            width = 100 * float(np.nanmedian([s.width for s in own]))
            cells.append(
                f"{inside:.0f} %, {sum(s.mean for s in own)} of {len(own)}, ± {width:.2g} %"
            )
    return "| " + " | ".join(cells) + " |"


def main(folder: Path, names: Sequence[str]) -> None:
    """Some rigs (default: those of the table that have runs over time)."""
    print(f"band: {100 * (1 - 2 * TAIL):.0f} %, {SAMPLES} samples of the parameters")
    for name in names or [n for n in RIGS if n != "tunnel-out"]:  # one diagnosis of both speeds
        about = json.loads((folder / name / "rig.json").read_text(encoding="utf-8"))
        if not about["static"]:
            print(line(name, shares(folder, name)), flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])
