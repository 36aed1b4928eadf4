"""Whether the explanation is right: the balances that a ledger says fail, and what a learned formula leaves.

    python -m benchmarks.hidden_effects.explanation --set tuning4 --cases 80 --out build/explanation.jsonl
    python -m benchmarks.hidden_effects.explanation --table build/explanation.jsonl

The base model is fitted to each case; where it leaves structure its ledger is kept, and a formula learned of what it
leaves. A balance is right where an effect that is hidden acts in it, or in one that the ledger says does the same.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks.hidden_effects.outcome import INSTRUMENTS
from benchmarks.results import Result, append_result, read_results
from blind_cases.prepared import made_case
from pam_cosim import study
from pam_cosim.catalogue import effect_classes
from pam_cosim.compiler import read_library
from pam_cosim.diagnosis.description.explanation import described, ledger_of, remaining_chi2
from pam_cosim.diagnosis.judgement.evidence import leaves_structure
from pam_cosim.diagnosis.search.effort import Effort
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.searches import fit_base_model
from pam_cosim.diagnosis.search.subject import subject_of

_SIMULATIONS = 20_000  # of a search, of which a formula may take a part


def explained(which: str, number: int, folder: Path) -> Result:
    """The result of one case."""
    case = made_case(which, number, folder)
    subject = subject_of(study.read(folder), None, (), 0, lambda message: None)
    with subject.simulator() as simulator:
        data, base = fit_base_model(simulator, subject.data, lambda message: None)
        available = subject.effects(simulator.interface)
    result: dict[str, Any] = {"set": which, "number": number, "group": case["group"]}
    result["families"] = [h["family"] for h in case["hidden"]]
    if not leaves_structure(base):
        return result
    balances = dict.fromkeys(INSTRUMENTS, "instrument")
    balances |= {e.family: e.balance for e in effect_classes(read_library())}
    result["true"] = sorted({balances[f] for f in result["families"] if f in balances})
    effort = Effort(simulations=_SIMULATIONS)
    search = Search(
        subject.library, subject.name, available, data, subject.sources, workers=0, effort=effort
    )
    begin = time.process_time()
    ledger = ledger_of(search, base)
    result["seconds"] = round(time.process_time() - begin, 2)
    if ledger is not None:
        entries = [e for e in map(ledger.entry, ledger.failing) if e is not None]
        result |= {"failing": [[e.balance, *e.same_as] for e in entries], "closed": ledger.closed}
    learned = described(search, ledger, base, (), base)
    result["formula_seconds"] = round(time.process_time() - begin - result["seconds"], 2)
    result["base"] = remaining_chi2(base)
    if learned is not None:
        result["formula"] = [
            learned.term.balance,
            learned.term.formula,
            remaining_chi2(learned.model.fit),
        ]
    return result


def table(results: Sequence[Result]) -> str:
    """By group: cases with a ledger, the leading balance right, all balances right, the formula's balance right."""
    groups: dict[str, list[Result]] = defaultdict(list)
    for result in results:
        if "true" in result and result["true"]:
            groups[result["group"]].append(result)
    lines = [
        "| hidden | cases | nothing fails | leading balance right | all right | closed | ledger, s "
        "| formulas | balance right | chi-square left |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for group, cases in groups.items():
        failing = [(c["failing"], {*c["true"]}) for c in cases if c.get("failing")]
        formulas = [(*c["formula"], c["base"], c["true"]) for c in cases if "formula" in c]
        cells = [
            len(cases),
            len(cases) - len(failing),
            sum(bool({*first} & true) for (first, *_), true in failing),
            sum(all({*each} & true for each in every) for every, true in failing),
            sum(c.get("closed", False) for c in cases),
            f"{_middle([c['seconds'] for c in cases]):.1f}",
            len(formulas),
            sum(balance in true for balance, _, _, _, true in formulas),
            f"{_middle([(after - 1) / (base - 1) for _, _, after, base, _ in formulas]):.2f}",
        ]
        lines.append(f"| {group} | {' | '.join(map(str, cells))} |")
    return "\n".join(lines)


def _middle(values: Sequence[float]) -> float:
    return sorted(values)[len(values) // 2] if values else float("nan")


def main() -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--set", dest="which", default="tuning4")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--cases", type=int, default=80)
    parser.add_argument("--out", type=Path)
    parser.add_argument("--table", type=Path, help="print the table of these results")
    options = parser.parse_args()
    if options.table:
        print(table([*read_results(options.table).values()]))
        return 0
    for number in range(options.first, options.first + options.cases):
        with tempfile.TemporaryDirectory() as scratch:
            try:
                result = explained(options.which, number, Path(scratch) / "data")
            except Exception as error:  # one case must not end the others
                result = {"set": options.which, "number": number, "error": repr(error)}
        append_result(options.out, result)
        print(json.dumps(result)[:200], flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
