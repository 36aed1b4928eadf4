"""One case: its base model is fitted, its ledger kept, its missing term described; each with its processor time."""

from __future__ import annotations

import math
import tempfile
import traceback
from pathlib import Path
from typing import Any

from benchmarks.explanations.cases import SAME, Truth
from benchmarks.hidden_effects.one import processor_seconds
from blind_cases.prepared import made_case
from pam_cosim import study
from pam_cosim.diagnosis.description.explanation import described, ledger_of
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.search.effort import Effort
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.searches import fit_base_model
from pam_cosim.diagnosis.search.subject import subject_of
from pam_cosim.fitting import Fit
from pam_cosim.simulation import Simulator

SEARCH = 6000
"""Runs that a search for an unlisted effect simulates on these benches, of which an explanation may take a tenth."""


def explain(truth: Truth) -> dict[str, Any]:
    """What the explanation says of a case; an exception becomes ``error``."""
    result: dict[str, Any] = {"case": f"{truth.which}:{truth.number}", "balance": truth.balance}
    try:
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch) / "data"
            hidden = made_case(truth.which, truth.number, folder)["hidden"]
            result["form"] = hidden[0]["form"]
            return result | _explained(truth, folder)
    except Exception:
        return result | {"error": traceback.format_exc()}


def _explained(truth: Truth, folder: Path) -> dict[str, Any]:
    began = processor_seconds()
    subject = subject_of(study.read(folder), None, (), 0, _silent)
    with subject.simulator() as simulator:
        effects = subject.effects(simulator.interface)
        data, base = fit_base_model(simulator, subject.data, _silent)
    effort = Effort(simulations=SEARCH)
    search = Search(subject.tree, subject.name, effects, data, subject.sources, effort=effort)
    fitted = processor_seconds()
    ledger = ledger_of(search, base)
    kept, simulated = processor_seconds(), Simulator.simulations
    learned = described(search, ledger, base, (), base)
    result: dict[str, Any] = {
        "before": _remaining(base),
        "failing": list(ledger.failing) if ledger else [],
        "same": sorted({s for e in ledger.entries for s in e.same_as}) if ledger else [],
        "closed": bool(ledger and ledger.closed),
        "seconds": {
            "fit": round(fitted - began, 2),
            "ledger": round(kept - fitted, 2),
            "formula": round(processor_seconds() - kept, 2),
        },
        "simulations": Simulator.simulations - simulated,
    }
    if learned is None:
        return result
    names = {name for name in _names(learned.term.formula) if name}
    return result | {
        "formula": learned.term.formula,
        "in": learned.term.balance,
        "variables": sorted(names),
        "right": _named(truth, names),
        "after": _remaining(learned.model.fit),
    }


def _silent(message: Message) -> None:
    """Nobody listens."""


def _remaining(fit: Fit) -> dict[str, float]:
    """Reduced chi-square of fitted and held-out runs."""
    chi2 = {role: fit.comparison.chi2_reduced(role) for role in ("fit", "holdout")}
    return {role: value for role, value in chi2.items() if not math.isnan(value)}


def _names(formula: str) -> list[str]:
    """The variables that a formula explains behind "where"."""
    _, _, where = formula.partition(", where ")
    return [part.split(" stands for ")[0].strip() for part in where.split("; ")]


def _named(truth: Truth, names: set[str]) -> bool | None:
    """Whether a formula names all variables of the law; None where the law has none of them."""
    if not truth.variables:
        return None
    alike = {v: next((s for s in SAME if v in s), frozenset({v})) for v in truth.variables}
    return all(names & same for same in alike.values())
