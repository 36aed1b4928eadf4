"""Coverage of 95 % bands on held-out runs of the independent simulator.

    python -m benchmarks.predictive_bands --cases 400          # goes on where it was stopped
    python -m benchmarks.predictive_bands --table
    python -m benchmarks.predictive_bands --cases 60 --hidden   # one effect hidden, and left out

Cases are those of the tuning set of many benches in which nothing is hidden and runs are held out: the model is right,
its parameters are fitted, and what is asked is how far they leave a run open that nobody fitted. The noise of a third
of the cases has a colour, or drifts.

With ``--hidden`` they are those in which one effect is hidden: the bench is fitted without it, and what is asked is how
far the model error widens the bands. It is estimated from the other held-out runs, or from the fitted ones where there
is one held-out run alone.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
import traceback
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.predictive_bands.half_widths import with_discrepancy
from benchmarks.results import append_result, read_results
from blind_cases import cases
from pam_cosim import study
from pam_cosim.arrays import Array
from pam_cosim.fitting import Band

FOLDER = Path(__file__).resolve().parents[2] / "build"
SET = "tuning2"
SAMPLES = 100
MOST_RUNS = 2  # held out, of a case


def solve(number: int) -> dict[str, Any]:
    """Share of readings and of noise-free values within their bands, by run and signal."""
    made = cases.make(cases.case_of(SET, number))
    clean = made.setup.simulate()
    with tempfile.TemporaryDirectory() as folder:
        cases.write(made, Path(folder))
        data = study.read(folder)
    start = time.perf_counter()
    fitted = study.fit(data)
    runs = []
    for run in data.holdout_runs[:MOST_RUNS]:
        bands = study.predict(fitted, run=run.name, samples=SAMPLES)
        truth = clean[int(run.name.rpartition("-")[2]) - 1]
        plan = made.setup.plan[int(run.name.rpartition("-")[2]) - 1]
        for name, band in bands.bands.items():
            at = np.isin(bands.time, plan.times)
            values = np.full(len(bands.time), np.nan)
            if at.sum() == len(truth[name]):
                values[at] = truth[name]
            known = np.isfinite(values)
            inside = (band.low <= values) & (values <= band.high)
            sigma = fitted.comparison.data.signals[name].sigma
            half_width = float(np.median(band.high - band.low)) / 2
            off, centre = band.discrepancy, (band.reading_low + band.reading_high) / 2
            narrow = with_discrepancy(band.reading_high - centre, off, None)
            miss = np.abs(band.measured - centre)[np.isfinite(band.measured)]
            narrow = narrow[np.isfinite(band.measured)]
            runs.append({
                "run": run.name,
                "signal": name,
                "readings": band.coverage,
                "without": float(np.mean(miss <= narrow)),
                **_means(band, bands.time),
                "wider": float(np.median((band.reading_high - band.reading_low) / 2)) / float(np.median(narrow)),
                "held_out": bool(off and off.held_out),
                "samples": int(np.isfinite(band.measured).sum()),
                "truth": float(np.mean(inside[known])) if known.any() else None,
                "half_width": half_width / sigma,
            })  # fmt: skip
        effective = bands.posterior.effective
    return {
        "number": number,
        "bench": made.case.design.bench,
        "colour": made.sensors.colour,
        "effective": effective,
        "chi2_reduced": fitted.residuals["fit"].chi2_reduced,
        "runs": runs,
        "seconds": round(time.perf_counter() - start, 1),
    }


def _means(band: Band, time: Array) -> dict[str, bool]:
    """Whether the mean of the readings over time is within its interval, with and without the model error."""
    at = np.isfinite(band.measured)
    centre, half = (band.mean_low + band.mean_high) / 2, (band.mean_high - band.mean_low) / 2
    error = band.measured[at] - band.value[at]
    if at.sum() < 2 or np.ptp(time[at]) == 0.0:
        return {}
    own = float(np.trapezoid(error, time[at])) / float(np.ptp(time[at]))
    off = abs(own + band.mean - centre)
    narrow = float(with_discrepancy(half, band.discrepancy, None, float(np.ptp(time))))
    return {"mean": bool(off <= half), "mean_without": bool(off <= narrow)}


def table(results: Sequence[Mapping[str, Any]]) -> str:
    """Markdown: by the colour of the noise."""
    lines = [
        "| noise | cases | runs and signals | readings within | without model error | means within | without | "
        "times as wide | truth within | half width, sd of the noise |"
    ]
    lines.append("|---|---|---|---|---|---|---|---|---|---|")
    done = [r for r in results if "runs" in r]
    for colour in (*sorted({r["colour"] for r in done}), "all"):
        chosen = [r for r in done if colour in (r["colour"], "all")]
        rows = [row for r in chosen for row in r["runs"]]
        samples = [row["samples"] for row in rows]
        readings, without = (
            100 * float(np.average([row[kind] for row in rows], weights=samples))
            for kind in ("readings", "without")
        )
        means, means_without = (
            100 * float(np.mean([row[kind] for row in rows if kind in row]))
            for kind in ("mean", "mean_without")
        )
        wider = np.median([row["wider"] for row in rows])
        truth = np.mean([row["truth"] for row in rows if row["truth"] is not None])
        width = np.median([row["half_width"] for row in rows])
        lines.append(
            f"| {colour} | {len(chosen)} | {len(rows)} | {readings:.1f} % | {without:.1f} % | {means:.0f} % | "
            f"{means_without:.0f} % | {wider:.2g} | {100 * truth:.0f} % | {width:.2g} |"
        )
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument(
        "--cases", type=int, default=0, help="numbers of cases that are looked at, from --first on"
    )
    parser.add_argument("--results", type=Path, help="default: a file of the kind in build/")
    parser.add_argument("--hidden", action="store_true", help="cases with one hidden effect")
    parser.add_argument("--table", action="store_true", help="print what came out as Markdown")
    options = parser.parse_args(arguments)
    kind = "-hidden" if options.hidden else ""
    file = options.results or FOLDER / f"predictive-bands{kind}.jsonl"
    file.parent.mkdir(parents=True, exist_ok=True)
    done = read_results(file)
    for number in range(options.first, options.first + options.cases):
        case = cases.case_of(SET, number)
        wanted = ("catalogue", "new_form") if options.hidden else ("null",)
        if number in done or case.group not in wanted or case.design.runs < 2:
            continue
        try:
            result = solve(number)
        except Exception:
            result = {"number": number, "error": traceback.format_exc()}
        append_result(file, result)
        print(number, result.get("seconds", result.get("error")), flush=True)
    if options.table:
        results = list(read_results(file).values())
        if not results:
            parser.error(f"there are no results in {file}")
        print(table(results))
    return 0


if __name__ == "__main__":
    sys.exit(main())
