"""Why verdicts were not right: what was hidden is fitted too, and compared with what the diagnosis chose.

    python -m benchmarks.hidden_effects.misses build/hidden-effects-tuning2.jsonl --jobs 2 [--numbers 3 17]

Each case that was not right is diagnosed again. Beside it the families that were hidden are fitted, without a search
for which: one after another, each by all its members, from two sides (the base model, and the answer without what is
wrong in it). Of each pair of models the evidence of the software tells which the data prefer.

    not distinguishable  the best model with the hidden families is not better, by ``very_strong``, than the answer and
                         than those that lack one of the families: these data do not tell.
    no member            the hidden families, by whichever members, leave structure.
    never fitted         they leave noise and are better, and the search fitted no such model to the end.
    optimiser            the search fitted the same effects, to a larger chi-square.
    not chosen           the search had a model of theirs that is as good, and another one was chosen.
    noise                nothing was hidden, and something was named.
    no family            what was hidden belongs to no family, and one was named.
    error                there is no verdict.

A line of JSON for each case goes beside the results, so that a second call goes on. ``--sums`` prints no case.
"""

from __future__ import annotations

import argparse
import math
import sys
import tempfile
import traceback
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from benchmarks.hidden_effects.outcome import judged
from benchmarks.results import append_result, read_results
from blind_cases.prepared import made_case
from pam_cosim import study
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.evidence import (
    information_criterion,
    leaves_structure,
    noise_scale,
)
from pam_cosim.diagnosis.search.search import FitRequest, Search
from pam_cosim.diagnosis.search.subject import subject_of
from pam_cosim.fitting import Fit

Result = Mapping[str, Any]
CLASSES = (
    "not distinguishable",
    "no member",
    "never fitted",
    "optimiser",
    "not chosen",
    "noise",
    "no family",
    "error",
)
_KEPT = 3  # members of a family that are fitted to the end and gone on from


def explained(which: str, number: int, result: Result) -> dict[str, Any]:
    """Why the verdict on a case is what it is, one of CLASSES, with the numbers that say so."""
    if "error" in result:
        return _line(number, "error")
    group = result["case"]["group"]
    if group in ("null", "none_of_these"):
        return _line(number, "noise" if group == "null" else "no family")
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "data"
        made_case(which, number, folder)
        diagnosis = study.diagnose(study.read(folder), workers=0, explain=False)
        facts = _compared(list(dict.fromkeys(result["case"]["families"])), diagnosis)
    return _line(number, reason(facts), **asdict(facts))


@dataclass(frozen=True)
class Facts:
    """What a case comes to when the families that were hidden are fitted.

    Attributes:
        hidden: the families. best: effects of the best model with just these; none where one has no place in it.
        answer: effects of the answer. verdict: its kind.
        gap: evidence against the best model, less that against the best of those without one of the families and of
            the answer: below zero, it is better.
        structure: whether it leaves structure in the fitted or in the held-out runs.
        searched: evidence against the best model with just these families that the search fitted to the end, less that
            against the best model; infinite: it fitted none.
        same_effects: whether the search fitted the very effects of the best model to the end.
    """

    hidden: tuple[str, ...]
    best: tuple[str, ...] = ()
    answer: tuple[str, ...] = ()
    verdict: str = ""
    gap: float = math.inf
    structure: bool = True
    searched: float = math.inf
    same_effects: bool = False


def reason(facts: Facts) -> str:
    """One of CLASSES, of a case in which an effect of a family is hidden."""
    worth = CRITERIA.evidence.very_strong
    if not facts.best:
        return "no member"
    if facts.gap > -worth:
        return "not distinguishable"
    if facts.structure:
        return "no member"
    if facts.searched <= worth:
        return "not chosen"
    return "optimiser" if facts.same_effects else "never fitted"


def _compared(hidden: Sequence[str], diagnosis: Diagnosis) -> Facts:
    search = _search_of(diagnosis)
    base, answer = diagnosis.base, diagnosis.path[-1] if diagnosis.path else None
    chosen = answer.effects if answer else ()
    models = list(_with_families(search, base, hidden, chosen))

    def families(c: Candidate) -> set[str]:
        return {search.family[e] for e in c.effects}

    whole = [c for c in models if families(c) == set(hidden)]
    if not whole:
        return Facts(tuple(hidden), answer=chosen, verdict=diagnosis.verdict.kind)
    scale = noise_scale([base, *(c.fit for c in models), *([answer.fit] if answer else [])])

    def evidence(c: Candidate | None) -> float:
        fit, effects = (c.fit, c.effects) if c else (base, ())
        return information_criterion(fit, scale, effects, search.model_space, c)

    best = min(whole, key=evidence)
    fewer = [c for c in models if families(c) < set(hidden)]
    tried = [c for c in diagnosis.candidates if not c.brief and families(c) == set(hidden)]
    return Facts(
        tuple(hidden),
        best.effects,
        chosen,
        diagnosis.verdict.kind,
        evidence(best) - min(evidence(c) for c in (None, answer, *fewer)),
        leaves_structure(best.fit),
        min((evidence(c) for c in tried), default=math.inf) - evidence(best),
        any(set(c.effects) == set(best.effects) for c in tried),
    )


def _search_of(diagnosis: Diagnosis) -> Search:
    """A search on the samples that the diagnosis judged by, which nobody has begun."""
    subject = subject_of(diagnosis.data, None, (), 0, _say_nothing)
    with subject.simulator() as simulator:
        available = subject.effects(simulator.interface)
    return Search(
        subject.tree, subject.name, available, diagnosis.data, subject.sources, _say_nothing, 0
    )


def _say_nothing(message: object) -> None:
    pass


def _with_families(
    search: Search, base: Fit, hidden: Sequence[str], chosen: Sequence[str]
) -> Iterator[Candidate]:
    """Models with members of these families, in two orders, and beside those effects of the answer that are right."""
    right = tuple(e for e in chosen if search.family[e] in hidden)
    for first in dict.fromkeys([(), right]):
        has = {search.family[e] for e in first}
        missing = [f for f in hidden if f not in has]
        for order in dict.fromkeys([tuple(missing), tuple(reversed(missing))]):
            yield from _one_after_another(search, base, first, order)


def _one_after_another(
    search: Search, base: Fit, first: tuple[str, ...], families: Sequence[str]
) -> Iterator[Candidate]:
    """Fits members of one family after another, each beside the best of those before."""
    best = search.fit_final(first, base.values) if first else None
    if best is not None:
        yield best
    for family in families:
        start, effects = (best.fit.values, best.effects) if best else (base.values, ())
        members = [e.name for e in search.available_effects if e.family == family]
        brief = search.fit_briefly([FitRequest((*effects, m), start) for m in members])
        brief.sort(key=lambda c: (c.fit.chi2_minimised, c.effects))
        done = [replace(c, brief=False) for c in search.fit_completely(brief[:_KEPT], base)]
        yield from done
        if not done:
            return
        best = min(done, key=lambda c: (c.fit.chi2_minimised, c.effects))


def _line(number: int, why: str, **facts: Any) -> dict[str, Any]:
    return {"number": number, "class": why, **facts}


def _explained(task: tuple[str, int, Result]) -> dict[str, Any]:
    try:
        return explained(*task)
    except Exception:
        return _line(task[1], "error", text=traceback.format_exc()[-1500:])


def table(lines: Sequence[Mapping[str, Any]], results: Mapping[int, Result]) -> str:
    """Markdown: how many verdicts of each group were not right, and why."""
    counts = Counter((results[e["number"]]["case"]["group"], e["class"]) for e in lines)
    groups = sorted({group for group, _ in counts})
    rows = [
        "| hidden | cases | not right | " + " | ".join(CLASSES) + " |",
        "|---" * (3 + len(CLASSES)) + "|",
    ]
    for group in groups:
        cases = sum(r["case"]["group"] == group for r in results.values())
        numbers = [counts[group, name] for name in CLASSES]
        rows.append(
            f"| {group} | {cases} | {sum(numbers)} | " + " | ".join(map(str, numbers)) + " |"
        )
    return "\n".join(rows)


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("results", type=Path)
    parser.add_argument("--out", type=Path, help="default: beside the results")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--numbers", type=int, nargs="*")
    parser.add_argument("--sums", action="store_true", help="print the table alone")
    options = parser.parse_args(arguments)
    out = options.out or options.results.with_suffix(".misses.jsonl")
    results = read_results(options.results)
    done = read_results(out)
    lines = list(done.values())
    wrong = [n for n, r in sorted(results.items()) if judged(r) != "right"]
    chosen = [n for n in wrong if n not in done and n in (options.numbers or wrong)]
    tasks = [(results[n]["set"], n, results[n]) for n in chosen]
    with ProcessPoolExecutor(options.jobs) as pool:
        for line in pool.map(_explained, tasks):
            lines.append(line)
            append_result(out, line)
            if not options.sums:
                print(line, flush=True)
    print(table(lines, results))
    return 0


if __name__ == "__main__":
    sys.exit(main())
