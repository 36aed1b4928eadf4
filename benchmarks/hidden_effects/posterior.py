"""The numbers of ``evidence.something_else`` and the temperature of the evidence, from cases whose truth is known.

    python -m benchmarks.hidden_effects.posterior build/hidden-effects-tuning2.jsonl

Each verdict states a probability for every set of families that was fitted, for nothing, and for something else. The
cases judge the numbers in force, and say to what they would move them: those with which what was hidden is most
probable, beside a prior of one standard deviation about those in force. Whether that serves, cases tell to which they
were not fitted: those of even number by the numbers that those of odd number give, and the other way round.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import minimize

from benchmarks.hidden_effects.calibration import brier, calibration_error
from benchmarks.hidden_effects.outcome import judged, stated_probability
from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.posterior import DOUBTS

Result = Mapping[str, Any]
_SPREAD = 1.0  # of each logit and of the temperature's logarithm, about those in force


class Case(NamedTuple):
    """What a verdict knew, and what was true.

    Attributes:
        number: of the case.
        gaps: (k,) evidence of each set of families against the answer.
        true: (k,) whether it was just these that were hidden, or others that give the same data.
        named: (k,) whether the verdict names them.
        doubts: (1 + len(DOUBTS),) 1, then which of ``DOUBTS`` apply.
        states: whether the verdict states a probability that counts (``outcome.stated_probability``), and is so.
    """

    number: int
    gaps: Array
    true: Array
    named: Array
    doubts: Array
    states: tuple[float, bool] | None


def case_of(result: Result) -> Case:
    """What a result says."""
    verdict = result["diagnosis"]["verdict"]
    every = [frozenset(one["families"]) for one in verdict["posterior"]["explanations"]]
    said = frozenset(verdict["families"])
    named = [bool(f) and f <= said if verdict["kind"] == "ambiguous" else f == said for f in every]
    known = verdict["posterior"]["doubts"]
    return Case(
        result["number"],
        np.array([one["evidence"] for one in verdict["posterior"]["explanations"]]),
        np.array([f in _true(result) for f in every], float),
        np.array(named, float),
        np.array([1.0, *(float(name in known) for name in DOUBTS)]),
        stated_probability(result),
    )


def _true(result: Result) -> set[frozenset[str]]:
    """The sets of families that are right; none where something else was hidden."""
    case, said = result["case"], result["diagnosis"]["verdict"]["families"]
    if case["group"] == "none_of_these":
        return (
            {frozenset(said)} if said and judged(result) == "right" and _claims(result) else set()
        )
    same = {frozenset(case["families"]), *(frozenset(f) for f in case.get("same_as", []))}
    return same | ({frozenset()} if set(case["families"]) == {"quantisation"} else set())


def _claims(result: Result) -> bool:
    return bool(result["diagnosis"]["verdict"]["kind"] == "identified")


def probabilities(case: Case, numbers: Array) -> tuple[Array, float]:
    """(k,) of each set of families, and of something else; ``numbers``: logarithm of the temperature, then logits."""
    other = 1 / (1 + np.exp(-float(numbers[1:] @ case.doubts)))
    weights = np.exp(np.minimum(-case.gaps / (2 * np.exp(numbers[0])), 0.0))
    return (1 - other) * weights / weights.sum(), other


def surprise(case: Case, numbers: Array) -> float:
    """Minus the logarithm of the probability of what was true."""
    each, other = probabilities(case, numbers)
    return -float(np.log(max(each @ case.true if case.true.any() else other, 1e-12)))


def in_force() -> Array:
    """The numbers that verdicts are stated with."""
    return np.array([np.log(CRITERIA.evidence.temperature), *CRITERIA.evidence.something_else])


def fitted(cases: Sequence[Case]) -> Array:
    """The numbers with which what was true is most probable, beside the prior."""
    prior = in_force()

    def cost(numbers: Array) -> float:
        return (
            sum(surprise(c, numbers) for c in cases)
            + float(np.sum(((numbers - prior) / _SPREAD) ** 2)) / 2
        )

    found: Array = minimize(
        cost, prior, method="Nelder-Mead", options={"maxiter": 20000, "xatol": 1e-4}
    ).x
    return found


def pairs(cases: Sequence[Case], numbers: Array | None) -> Array:
    """(n, 2) stated probability and whether it was so; ``numbers`` None: as the verdicts stated it."""
    rows = []
    for c in cases:
        if c.states is not None:
            stated, so = c.states
            own = stated if numbers is None else float(probabilities(c, numbers)[0] @ c.named)
            rows.append((own, float(so)))
    return np.array(rows).reshape(-1, 2)


def _judgement(what: str, some: Array) -> str:
    share = some[:, 1].mean()
    return (
        f"{what}: {len(some)} verdicts, Brier score {brier(some):.3f} (always stating {100 * share:.0f} %: "
        f"{share * (1 - share):.3f}), calibration error {100 * calibration_error(some):.1f} %"
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("results", type=Path, help="JSON lines, as `score` writes them")
    results = [
        json.loads(line) for line in parser.parse_args(arguments).results.read_text().splitlines()
    ]
    cases = [case_of(r) for r in results if "error" not in r]
    halves = [[c for c in cases if c.number % 2 == parity] for parity in (0, 1)]
    own = fitted(cases)
    logits = ", ".join(
        f"{name} {v:+.2f}" for name, v in zip(("always", *DOUBTS), own[1:], strict=True)
    )
    print(f"fitted to {len(cases)} cases: temperature {np.exp(own[0]):.2f}; {logits}")
    others = [fitted(half) for half in reversed(halves)]
    crossed = list(zip(halves, others, strict=True))
    print(
        _judgement(
            "fitted to the other half",
            np.vstack([pairs(half, numbers) for half, numbers in crossed]),
        )
    )
    print(_judgement("by the numbers in force", pairs(cases, in_force())))
    print(_judgement("as the verdicts stated", pairs(cases, None)))
    mean = np.mean([surprise(c, numbers) for half, numbers in crossed for c in half])
    alone = np.mean([surprise(c, in_force()) for c in cases])
    print(f"minus log probability of what was true: {mean:.3f} and {alone:.3f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
