"""Writes the rigs: python -m strangers FOLDER [--rig N ...] [--half tuning|once]."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from strangers.loggers import Recorded, record, write
from strangers.notes import SPRING_RIG, described, draft, notes
from strangers.rigs import HALVES, RIGS, Rig, rig


def make(one: Rig, folder: Path) -> None:
    """Writes a rig into a new folder: its files, notes.md, experiment.toml and truth.json.

    Raises:
        FileExistsError: the folder is there already.
    """
    runs = [record(one, i) for i in range(len(one.runs))]
    folder.mkdir(parents=True)
    files = write(one, runs, folder)
    (folder / "notes.md").write_text(notes(one, files), encoding="utf-8")
    (folder / "experiment.toml").write_text(draft(one, files), encoding="utf-8")
    if one.truth.load == "spring":
        (folder / "SpringRig.mo").write_text(SPRING_RIG, encoding="utf-8")
    (folder / "truth.json").write_text(json.dumps(truth(one, runs), indent=1) + "\n")


def truth(one: Rig, runs: list[Recorded]) -> dict[str, Any]:
    """What is hidden, how much each departure changes, and the error that the truth itself leaves."""
    departures = []
    for departure in one.departures:
        without = one.truth.without(*departure.fields)
        change = _change(runs, [record(one, i, without, run) for i, run in enumerate(runs)])
        over = {s: change[s] / one.sigma[s] for s in change}
        departures.append(
            described(departure)
            | {
                "fields": list(departure.fields),
                "rms_change": change,
                "rms_over_noise": {s: round(v, 2) for s, v in over.items()},
                "counts": max(over.values()) > 1,
            }
        )
    return {
        "rig": f"rig-{one.number:02d}",
        "half": one.half,
        "load": one.truth.load,
        "drive": one.drive,
        "departures": departures,
        "noise": one.sigma,
        "error_of_truth": {
            role: _error([r for r in runs if r.plan.held_out == held])
            for role, held in (("fit", False), ("holdout", True))
        },
        "held_out_runs": [i for i, r in enumerate(runs, 1) if r.plan.held_out],
        "true_parameters": asdict(one.truth) | {"masses": [r.plan.M for r in runs]},
    }


def _change(runs: list[Recorded], others: list[Recorded]) -> dict[str, float]:
    """Root mean square of what signals differ by, over all runs."""
    return {
        s: _rms([a.true[s] - b.true[s] for a, b in zip(runs, others, strict=True)])
        for s in runs[0].true
    }


def _error(runs: list[Recorded]) -> dict[str, float]:
    return {s: _rms([r.read[s] - r.true[s] for r in runs]) for s in runs[0].true}


def _rms(differences: list[Any]) -> float:
    return float(np.sqrt(np.mean(np.concatenate(differences) ** 2)))


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--rig", type=int, nargs="+", choices=range(RIGS))
    parser.add_argument("--half", choices=HALVES)
    options = parser.parse_args(arguments)
    numbers = options.rig or (HALVES[options.half] if options.half else range(RIGS))
    for number in numbers:
        folder = options.folder / f"rig-{number:02d}"
        if folder.exists():
            print(f"{folder} is there already; it stays as it is")
            continue
        make(rig(number), folder)
        print(folder, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
