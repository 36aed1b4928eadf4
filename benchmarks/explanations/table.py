"""The results of explanations as a table and its sums."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any


def table(results: Sequence[Mapping[str, Any]]) -> str:
    """A row for each case, and what they come to."""
    rows = [
        "| case | hidden | in | ledger | formula in | variables | chi-square | ledger, formula [s] | runs |",
        "|---|---|---|---|---|---|---|---|---|",
        *map(_row, results),
    ]
    return "\n".join([*rows, "", *_sums(results)])


def _row(r: Mapping[str, Any]) -> str:
    if "error" in r:
        return f"| {r['case']} | {r.get('form', '')} | {r['balance']} | failed: {r['error'].splitlines()[-1]} |"
    role = "holdout" if "holdout" in r["before"] else "fit"
    after = f"{r['after'][role]:.3g}" if "after" in r else "no formula"
    right = {True: " (right)", False: " (wrong)", None: ""}[r.get("right")]
    cells = [
        r["case"],
        r["form"],
        r["balance"],
        " and ".join(r["failing"]) or "nothing",
        r.get("in", ""),
        ", ".join(r.get("variables", ())) + right,
        f"{r['before'][role]:.3g} → {after} ({role})",
        f"{r['seconds']['ledger']:.1f}, {r['seconds']['formula']:.1f}",
        str(r["simulations"]),
    ]
    return f"| {' | '.join(cells)} |"


def _sums(results: Sequence[Mapping[str, Any]]) -> list[str]:
    done = [r for r in results if "error" not in r]
    only = [r for r in done if r["failing"] == [r["balance"]]]
    among = [r for r in done if r["balance"] in {*r["failing"], *r["same"]}]
    formulas = [r for r in done if "after" in r]
    judged = [r for r in formulas if r["right"] is not None]
    shares = sorted(_left(r) for r in formulas)
    seconds = {k: sum(r["seconds"][k] for r in done) for k in ("fit", "ledger", "formula")}
    return [
        f"cases {len(done)} of {len(results)}",
        f"the ledger names the right balance alone: {len(only)}; among others: {len(among)}",
        f"formulas {len(formulas)}; in the right balance {sum(r['in'] == r['balance'] for r in formulas)}; "
        f"with all variables of the law {sum(r['right'] for r in judged)} of {len(judged)}",
        f"part of the excess that is left with the formula, median: {shares[len(shares) // 2]:.3f}"
        if shares
        else "",
        "processor time [s]: " + ", ".join(f"{k} {v:.1f}" for k, v in seconds.items()),
    ]


def _left(r: Mapping[str, Any]) -> float:
    """Excess of the chi-square over the noise with the formula over that without; of held-out runs if there are any."""
    role = "holdout" if "holdout" in r["before"] else "fit"
    before, after = (max(r[k][role] - 1, 0.0) for k in ("before", "after"))
    return float(after / before) if before else 1.0
