"""The verdict without members that bend to any form: python -m benchmarks.real_rigs.named FOLDER [RIG ...].

An explanation, made after the results: does a named law of few numbers carry further beyond the fitted rows? Diagnoses
each rig again without the effects whose names begin with Flexible or General, scores the model that it ends with as
``ours`` does, and prints it beside the verdict that has them, as it stands in results.json.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

import pam_cosim as pam
from benchmarks.real_rigs.ours import predictions
from benchmarks.real_rigs.rows import overall, read_rows, score
from benchmarks.real_rigs.table import REPEATS, RIGS
from pam_cosim.study.fitted_model import fitted_model

RESULTS = Path(__file__).with_name("results.json")
OPEN = ("Flexible", "General")
# the library of the tunnel has no member that bends
SHOWN = tuple(r for r in (*RIGS, *REPEATS["hoses of 2 to 8 m"][1:]) if not r.startswith("tunnel"))


def named(folder: Path) -> tuple[str, dict[str, float]]:
    """What the verdict is, and its error by role in per cent."""
    rows = read_rows(folder)
    files = [*rows.library, *(folder / "fitted").glob("*.mo")]
    data = pam.read(folder / "fitted", files=rows.library)
    bending = [e.name for e in pam.effects() if e.name.startswith(OPEN)]
    diagnosis = pam.diagnose(data, workers=1, exclude=bending, explain=False)
    model = folder / "Named.mo"
    pam.add(diagnosis, output=model, files=files)
    ratios = {n: v for n, v in fitted_model(diagnosis).of_the_data.items() if "@" not in n}
    scores = score(rows, predictions(rows, folder, model, files, ratios))
    effects = " + ".join(c.effect for c in diagnosis.path) or "none"
    return f"{diagnosis.verdict.kind}: {effects}", {
        r: 100 * overall(s) for r, s in scores.items() if s
    }


def main(folder: Path, names: Sequence[str]) -> None:
    """Prints a row a rig, and the root mean square of the leaks."""
    before = json.loads(RESULTS.read_text(encoding="utf-8"))
    leaks = []
    for name in names or SHOWN:
        said, errors = named(folder / name)
        was = before[f"{name}.verdict"]
        old = {role: 100 * overall(s) for role, s in was["scores"].items() if s}
        print(
            f"{name}: {said} {_text(errors)}; verdict: {' + '.join(was['effects'])} {_text(old)}",
            flush=True,
        )
        if name.startswith("muscle-leak"):
            leaks.append(errors["outside"])
    if leaks:
        print(f"muscle-leak: outside {np.sqrt(np.mean(np.square(leaks))):.2f} %")


def _text(errors: dict[str, float]) -> str:
    return ", ".join(f"{role} {value:.2f} %" for role, value in errors.items())


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])
