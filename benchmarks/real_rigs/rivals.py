"""Runs the rival methods on the rigs of a folder: python -m benchmarks.real_rigs.rivals FOLDER [RIG ...].

Needs scikit-learn, SysIdentPy, PySINDy and SciPy, best in an environment of their own; pam-cosim is not used. Writes
``FOLDER/results/RIG.METHOD.json`` and ``.npz`` (what was predicted).
"""

from __future__ import annotations

import json
import sys
import time
import warnings
from collections.abc import Callable, Mapping, Sequence
from importlib.metadata import version
from pathlib import Path

import numpy as np

from benchmarks.real_rigs import formulas
from benchmarks.real_rigs.at_rest import run_static
from benchmarks.real_rigs.dynamic import SHELF, Fitted, run_method
from benchmarks.real_rigs.folders import ROLES, Array
from benchmarks.real_rigs.rows import Course, Rows, read_rows, score
from benchmarks.real_rigs.table import RIGS

PACKAGES = {
    "NARX": "sysidentpy",
    "network": "scikit-learn",
    "SINDy": "pysindy",
    "boosting": "scikit-learn",
    "polynomial": "scikit-learn",
    "formula": "scipy",
}


def by_formula(
    rows: Rows, courses: Mapping[str, Sequence[Course]], twins: Sequence[Course]
) -> Fitted:
    """The formula that fits best of those published for the rig; ``twins`` are fitted rows of an equal part."""
    found = []
    for formula in formulas.formulas(rows.name):
        c = formulas.fitted(formula, [*courses["fitted"], *twins])
        predicted = formulas.predictions(formula, c, courses)
        left = [
            np.nanmean((predicted["fitted"][k.name] - k.measured) ** 2) for k in courses["fitted"]
        ]
        found.append((float(np.mean(left)), Fitted(formula.title, len(c), predicted)))
    return min(found, key=lambda f: f[0])[1]


def methods(rows: Rows, twins: Sequence[Course] = ()) -> dict[str, Callable[[], Fitted]]:
    """What is run on a rig."""
    courses = {role: rows.courses[role] for role in ROLES}
    listed: dict[str, Callable[[], Fitted]] = {"formula": lambda: by_formula(rows, courses, twins)}
    if rows.static:
        return listed | {
            m: (lambda m=m: run_static(m, courses)) for m in ("boosting", "polynomial")
        }
    return listed | {m: (lambda s=s: run_method(s, courses, rows.step)) for m, s in SHELF.items()}


def write_result(
    folder: Path,
    rows: Rows,
    method: str,
    about: Mapping[str, object],
    predicted: Mapping[str, Mapping[str, Array]],
) -> None:
    """``RIG.METHOD.json`` with the scores, and the predictions beside it."""
    folder.mkdir(exist_ok=True)
    scores = score(rows, predicted)
    said = {"rig": rows.name, "method": method, **about, "scores": scores}
    (folder / f"{rows.name}.{method}.json").write_text(
        json.dumps(said, indent=1) + "\n", encoding="utf-8"
    )
    flat = {
        f"{role}/{name}": values for role, own in predicted.items() for name, values in own.items()
    }
    np.savez_compressed(folder / f"{rows.name}.{method}.npz", **flat)  # type: ignore[arg-type]


def main(folder: Path, names: Sequence[str]) -> None:
    """All rival methods on some rigs (default: those of the table)."""
    for name in names or RIGS:
        rows = read_rows(folder / name)
        for method, run in methods(rows, _twins(folder, name)).items():
            begun = time.process_time()
            about: dict[str, object] = {
                "version": f"{PACKAGES[method]} {version(PACKAGES[method])}"
            }
            predicted: Mapping[str, Mapping[str, Array]] = {}
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    done = run()
                predicted = done.predicted
                about |= {"size": done.size, "coefficients": done.count}
            except Exception as error:  # whatever a method fails of is its result
                about |= {"failed": f"{type(error).__name__}: {error}"}
            about["seconds"] = time.process_time() - begun
            write_result(folder / "results", rows, method, about, predicted)
            print(name, method, about, flush=True)


def _twins(folder: Path, name: str) -> list[Course]:
    """Fitted rows of a part that the published formula takes for an equal one."""
    twin = formulas.TWINS.get(name)
    if twin is None:
        return []
    return [formulas.of_twin(c) for c in read_rows(folder / twin).courses["fitted"]]


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])
