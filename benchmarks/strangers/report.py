"""Tables of the score of strangers' rigs: python -m benchmarks.strangers.report FILE."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from statistics import median

from benchmarks.results import Result, read_results

NAMED = 0.5  # marginal probability from which a family counts as named
BINS = (0.0, 0.05, 0.2, 0.5, 0.8, 1.0)


def named(result: Result) -> set[str]:
    """Families that the verdict holds for more probable than not."""
    return {f for f, p in result.get("families", {}).items() if p > NAMED}


def there(result: Result) -> set[str]:
    """Families of the departures that count."""
    return {f for f, counts in result.get("departures", {}).items() if counts}


def recall_and_precision(results: Iterable[Result]) -> tuple[float, float]:
    """Of the families of all rigs; what is named, there and too small to count is left out."""
    found = missed = wrong = 0
    for result in results:
        found += len(named(result) & there(result))
        missed += len(there(result) - named(result))
        wrong += len(named(result) - set(result.get("departures", {})))
    return _share(found, found + missed), _share(found, found + wrong)


def calibration(results: Iterable[Result]) -> tuple[list[tuple[float, float, int, float]], float]:
    """Mean probability, share that is there, number and upper end of each bin; and the Brier score."""
    pairs = [
        (p, float(f in there(r)))
        for r in results
        if "families" in r
        for f, p in (dict.fromkeys(there(r), 0.0) | r["families"]).items()
        if f in there(r) or f not in r["departures"]
    ]
    rows = []
    for low, high in zip(BINS, BINS[1:], strict=False):
        inside = [(p, y) for p, y in pairs if low < p <= high or (low == 0.0 == p)]
        n = len(inside)
        rows.append(
            (_share(sum(p for p, _ in inside), n), _share(sum(y for _, y in inside), n), n, high)
        )
    return rows, _share(sum((p - y) ** 2 for p, y in pairs), len(pairs))


def _share(part: float, whole: float) -> float:
    return part / whole if whole else math.nan


def over_truth(errors: Mapping[str, float], truth: Mapping[str, float]) -> float:
    """Root mean square, over signals, of an error over that of the truth itself."""
    squares = [(errors[s] / truth[s]) ** 2 for s in truth if s in errors]
    return math.sqrt(sum(squares) / len(squares)) if squares else math.nan


def held_out(result: Result) -> dict[str, float]:
    """Held-out error over that of the truth: of the base, the verdict, the truth told by hand and rivals."""
    truth = result.get("error_of_truth", {})
    errors = {name: result[name] for name in ("base", "final", "told") if name in result}
    errors |= result.get("rivals", {})
    return {name: over_truth(one, truth) for name, one in errors.items()}


def line(result: Result) -> str:
    """One rig for the console."""
    head = f"{result['number']:3d} {result.get('rig', ''):18}"
    if "error" in result:
        return f"{head} ERROR {result['error'].strip().splitlines()[-1]}"
    found, errors = named(result) & there(result), held_out(result)
    wrong = named(result) - set(result["departures"])
    told = ", ".join(f"{n} {e:.3g}" for n, e in errors.items())
    return (
        f"{head} {result['kind']:12} {len(found)} of {len(there(result))} found, {len(wrong)} wrong; {told}; "
        f"{result['processor_seconds']:.0f} s of processor time"
    )


def report(results: Sequence[Result]) -> Iterator[str]:
    """The tables, as Markdown."""
    yield f"{len(results)} rigs, {sum('error' in r for r in results)} without a verdict"
    recall, precision = recall_and_precision(results)
    yield f"recall {recall:.2f}, precision {precision:.2f} of families with a marginal probability above {NAMED}"
    rows, brier = calibration(results)
    yield "\n| marginal probability up to | families | mean | there |\n|---|---|---|---|"
    for mean, share, number, high in rows:
        yield f"| {high:g} | {number} | {mean:.2f} | {share:.2f} |"
    yield f"\nBrier score {brier:.3f}\n"
    yield "| rig | verdict | there | named | held-out error over that of the truth | processor time |"
    yield "|---|---|---|---|---|---|"
    for r in sorted(results, key=lambda r: r["number"]):
        errors = ", ".join(f"{n} {e:.2f}" for n, e in held_out(r).items())
        yield (
            f"| {r['number']} {r.get('rig', '')} | {r.get('kind', 'error')} | {', '.join(sorted(there(r)))} "
            f"| {', '.join(sorted(named(r)))} | {errors} | {r.get('processor_seconds', math.nan):.0f} s |"
        )
    judged = [(r, held_out(r)) for r in results if "final" in r]
    if not judged:
        return
    yield f"\nmedian held-out error over that of the truth: {median(e['final'] for _, e in judged):.2f}"
    told = [e["final"] / e["told"] for _, e in judged if "told" in e]
    if told:
        yield f"over that of the truth told by hand: {median(told):.2f}"
    rivals = [(e["final"], min(e[m] for m in r["rivals"])) for r, e in judged if r.get("rivals")]
    yield f"better than the best regression: {sum(a < b for a, b in rivals)} of {len(rivals)}"
    yield f"median processor time: {median(r['processor_seconds'] for r, _ in judged):.0f} s"


def main() -> int:
    """Command line; returns the exit status."""
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    for text in report(list(read_results(Path(sys.argv[1])).values())):
        print(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
