"""How the recordings of the corpus are drafted: right as they are, with one answer, or wrong without a mark."""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

import pam_cosim as pam
from pam_cosim.drafting import NewDataSet
from tests.drafting.corpus import CASES, Case

_TOLERANCE = {
    "p": 2e3,
    "p_set": 2e3,
    "x": 1e-3,
    "s": 2e-3,
    "F": 1.0,
    "T": 0.6,
    "u_in": 1e-3,
    "u_out": 1e-3,
}


def _wrong_names(case: Case, made: NewDataSet) -> list[str]:
    """Signals that differ from what was recorded, and what else is not as it was."""
    run = made.data.runs[0]
    read = {**run.inputs, **run.measurements}
    if run.is_static and "F" not in read:
        read = {}
    if run.is_static and read:
        read = {n: _in_order(made, n) for n in read}
    wrong = []
    for name, values in case.truth.items():
        got = read.get(name, read.get({"s": "x", "x": "s"}.get(name, "")))
        if got is not None and len(got) != len(values):
            got = None
        if got is None and name in ("s", "p_set") and name in made.data.runs[0].parameters:
            got = np.full(len(values), run.parameters[name])
        if got is None or not np.nanmax(np.abs(got - values)) <= _TOLERANCE[name] + 0.01 * np.ptp(
            values
        ):
            wrong.append(name)
    text = (made.folder / "experiment.toml").read_text() + "".join(
        f.read_text() for f in made.folder.glob("*.mo")
    )
    if not any(one in text for one in case.bench.split("|")):
        wrong.append("bench")
    if case.held and any(one.interpolation != "previous" for one in made.data.runs):
        wrong.append("interpolation")
    return wrong


def _in_order(made: NewDataSet, name: str) -> np.ndarray:
    """A signal in all rows of a table, fitted or held out, by the values that are imposed."""
    length = "s" if "s" in made.data.runs[0].inputs else "x"
    rows = {
        n: np.concatenate([{**run.inputs, **run.measurements}[n] for run in made.data.runs])
        for n in ("p", length, name)
    }
    there = np.isfinite(np.concatenate([run.measurements["F"] for run in made.data.runs]))
    order = np.lexsort((rows[length][there].round(6), rows["p"][there].round(0)))
    return rows[name][there][order]


def _is_marked(name: str, made: NewDataSet) -> bool:
    """Whether a sentence asks about a signal, the bench or a column that was taken for it."""
    columns = [
        guess.what for guess in made.guesses if guess.taken_as.split(" ")[0].strip(":") == name
    ]
    words = {"bench": ["--model"], "interpolation": ["interpolation"]}.get(name, [name, *columns])
    lines = [
        *made.to_check,
        *(f"{g.what} {g.why}" for g in made.guesses if g.taken_as == "not read"),
    ]
    return any(word in line for line in lines for word in words)


def _merged(one: Mapping[str, Any], other: Mapping[str, Any]) -> dict[str, Any]:
    return {key: {**one.get(key, {}), **other.get(key, {})} for key in {*one, *other}}


def outcome(case: Case, place: Path) -> tuple[str, str]:
    """ "right", "answered", "wrong" or "unmarked", and why."""
    files = case.write(place / "files")
    try:
        made = pam.new(place / "plain", files, **case.stated)
        wrong = _wrong_names(case, made)
        if not wrong:
            return "right", ""
        first = f"wrong: {', '.join(wrong)}"
        marked = all(_is_marked(name, made) for name in wrong)
    except pam.InputError as error:
        first, marked = f"refused: {error}", True
    if case.answer:
        try:
            made = pam.new(place / "answered", files, **_merged(case.stated, case.answer))
            if not (wrong := _wrong_names(case, made)):
                return ("answered" if marked else "unmarked"), first
            first += f"; answered, wrong: {', '.join(wrong)}"
        except pam.InputError as error:
            first += f"; answered, refused: {error}"
    return ("wrong" if marked else "unmarked"), first


def main() -> None:
    """Prints the outcome of each case that is not right, and how many there are of each."""
    counts: Counter[str] = Counter()
    for case in CASES:
        if len(sys.argv) > 1 and sys.argv[1] not in case.name:
            continue
        with tempfile.TemporaryDirectory() as place:
            kind, why = outcome(case, Path(place))
        counts[kind] += 1
        if kind != "right":
            print(f"{kind:9} {case.name}: {why}")
    print(dict(counts), sum(len(case.files) for case in CASES), "recordings")


if __name__ == "__main__":
    main()
