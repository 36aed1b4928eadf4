"""How long commands take to start, and the first and the next diagnosis on a machine: processor seconds.

python -m benchmarks.diagnosis_speed OUTPUT.json [--package FOLDER]      # FOLDER: of another version of pam_cosim
python -m benchmarks.diagnosis_speed --picture docs/pictures/diagnosis-time.png BEFORE.json AFTER.json
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from typing import Any

from blind_cases import cases
from rig.named import effect_of
from rig.short import write_light_data

ROOT = Path(__file__).parents[2]
BENCHES = ("TankFilling", "Isotonic", "Antagonistic")
COMMANDS = (
    ("--version",),
    ("describe", "Isotonic"),
    ("simulate", "Isotonic", "--stop-time", "0.1"),
)
PARTS = ("start", "building", "predicting", "fitting", "choosing and judging", "ledger")
REPEATS = 3


def write_data(bench: str, folder: Path) -> None:
    """A tuning case of the blind score with one effect of the catalogue; "short": the data of quick tests."""
    if bench == "short":
        write_light_data(folder, [effect_of("leak:orifice")], seed=1)
        return
    cases = (cases.case_of("tuning2", n) for n in range(400))
    cases.write(
        cases.make(next(c for c in cases if c.design.bench == bench and c.group == "catalogue")),
        folder,
    )


def measured(package: Path, words: Sequence[str], cache: Path) -> tuple[float, str]:
    """Processor seconds and output of a process."""
    begin = getrusage(RUSAGE_CHILDREN)
    environment = {**os.environ, "PYTHONPATH": f"{package}:{ROOT}", "PAM_COSIM_CACHE": str(cache)}
    command, place = (
        [sys.executable, *words],
        cache.parent,
    )  # not where another version lies, which would come first
    run = subprocess.run(
        command, cwd=place, env=environment, capture_output=True, text=True, check=True
    )
    end = getrusage(RUSAGE_CHILDREN)
    return end.ru_utime + end.ru_stime - begin.ru_utime - begin.ru_stime, run.stdout


def measure(package: Path, benches: Sequence[str]) -> dict[str, Any]:
    """Everything."""
    result: dict[str, Any] = {"start": {}, "diagnosis": {}}
    with tempfile.TemporaryDirectory() as place:
        cache = Path(place, "cache")
        for words in COMMANDS:
            times = [
                measured(package, ["-m", "pam_cosim", *words], cache)[0] for _ in range(REPEATS + 1)
            ]
            result["start"][words[0]] = min(times[1:])
            print(f"{words[0]:12} {min(times[1:]):6.2f} s", flush=True)
        for bench in benches:
            write_data(bench, Path(place, bench))
            words = [
                "-m",
                "benchmarks.diagnosis_speed.one",
                str(Path(place, bench)),
                str(Path(place, f"of-{bench}")),
            ]
            own = {}
            for when in ("first", "next"):
                own[when] = json.loads(measured(package, words, cache)[1].splitlines()[-1])
            result["diagnosis"][bench] = own
            first, later = own["first"]["total"], own["next"]["total"]
            print(
                f"{bench:12} first {first:6.1f} s, next {later:6.1f} s, ratio {first / later:.1f}",
                flush=True,
            )
            for when, one in own.items():
                parts = ", ".join(f"{part} {one['parts'].get(part, 0.0):.2f}" for part in PARTS)
                print(f"  {when:6} {parts}", flush=True)
    return result


def picture(path: Path, before: Mapping[str, Any], after: Mapping[str, Any]) -> None:
    """Bars of the parts, before and after."""
    from matplotlib.figure import Figure

    benches = [bench for bench in after["diagnosis"] if bench in before["diagnosis"]]
    figure = Figure((8.0, 1.0 + 0.9 * len(benches) * 2), layout="constrained")
    axes = figure.subplots()
    rows = [
        (f"{bench}, {when}, {version}", results["diagnosis"][bench][when]["parts"])
        for bench in benches
        for when in ("first", "next")
        for version, results in (("before", before), ("after", after))
    ]
    left = [0.0] * len(rows)
    for part in PARTS:
        widths = [parts.get(part, 0.0) for _, parts in rows]
        axes.barh(range(len(rows)), widths, left=left, label=part)
        left = [a + b for a, b in zip(left, widths, strict=True)]
    axes.set_yticks(range(len(rows)), [name for name, _ in rows])
    axes.invert_yaxis()
    axes.set_xlabel("processor time of one diagnosis [s]")
    axes.legend(fontsize="small")
    figure.savefig(path, dpi=120)


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--package", type=Path, default=ROOT)
    parser.add_argument("--benches", default=",".join(("short", *BENCHES)))
    parser.add_argument("--picture", type=Path)
    options = parser.parse_args()
    if options.picture:
        before, after = (json.loads(file.read_text()) for file in options.files)
        picture(options.picture, before, after)
        return
    result = measure(options.package, options.benches.split(","))
    options.files[0].write_text(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
