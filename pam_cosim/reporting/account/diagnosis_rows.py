"""What a diagnosis found, as the rows of tables: numbers with units, as a person reads them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pam_cosim.comparison import Rule
from pam_cosim.diagnosis import Candidate, Diagnosis, FailedTrial
from pam_cosim.diagnosis.judgement.verdict import explained
from pam_cosim.fitting import Estimate, Fit
from pam_cosim.measurement import ROLES
from pam_cosim.model.domain import WRONG_PARAMETER
from pam_cosim.reporting.account.wording import (
    NOTHING,
    estimate_texts,
    fixed,
    number,
    percent,
    quantity_text,
    remark,
    unit_text,
)
from pam_cosim.wording import words

Row = dict[str, str]
STATED = "stated_parameter"
"""What stands in the place of a balance where a stated value is wrong: a length of a muscle is in none."""


def rule_rows(rules: Sequence[Rule]) -> list[Row]:
    """Where the error sits, as a table."""
    return [
        {
            "signal": r.signal,
            "rule": r.rule,
            "error": percent(r.error_share),
            "time": percent(r.time_share),
        }
        for r in rules
    ]


def summary_rows(diagnosis: Diagnosis) -> list[Row]:
    """The error of each signal on the runs of each role, before and after."""
    return error_rows(diagnosis.base, diagnosis.final if diagnosis.path else None)


def error_rows(base: Fit, final: Fit | None) -> list[Row]:
    """The error of each signal on the runs of each role, of one model and of another."""
    rows = []
    for role in ROLES:
        for name, before in base.comparison.scores[role].items():
            after = final.comparison.scores[role].get(name) if final else None
            signal = base.comparison.data.signals[name]
            rows.append(
                {
                    "name": name if signal.fitted else f"{name} (not fitted)",
                    "role": role,
                    "before": quantity_text(before.rmse, signal.unit),
                    "after": quantity_text(after.rmse if after else None, signal.unit),
                    "noise": quantity_text(before.noise_rmse, signal.unit),
                    "chi2_before": number(before.chi2_reduced),
                    "chi2_after": number(after.chi2_reduced if after else None),
                }
            )
    return rows


def was_added(path: Sequence[Candidate], candidate: Candidate) -> bool:
    """Whether a candidate is a step of the way to the verdict."""
    return any(candidate.effects == c.effects for c in path)


def place_of(candidate: Candidate | FailedTrial) -> str:
    """The balance that a candidate's last effect acts in, or ``STATED``."""
    return STATED if candidate.family == WRONG_PARAMETER else candidate.balance


def place_text(place: str) -> str:
    """What ``place_of`` gives, in words."""
    return words(place) if place == STATED else f"{words(place)} balance"


def balance_shares(diagnosis: Diagnosis) -> dict[str, float]:
    """Share of each balance; a stated value stands for itself where it explains most among what acts in a balance."""
    single = [c for c in diagnosis.candidates if len(c.effects) == 1]
    shares: dict[str, float] = {}
    for balance, share in diagnosis.balance.items():
        candidates_of_balance = [c for c in single if c.balance == balance]
        best = max(
            candidates_of_balance, key=lambda c: explained(diagnosis.base, c.fit), default=None
        )
        shares[place_of(best) if best is not None else balance] = share
    return shares


def candidate_row(base: Fit, c: Candidate, path: Sequence[Candidate]) -> dict[str, Any]:
    """A line of the ranking, compared with the base model; ``path``: what was added."""
    effect_parameters = [
        " ".join(filter(None, [name, "=", row["value"], row["unit"]]))
        + f" ({row['remark'] or row['interval']})"
        for name, row in estimate_rows(c.parameters).items()
    ]
    return {
        "effect": " + ".join(c.effects),
        "family": words(c.family),
        "balance": words(place_of(c)),
        "place": place_text(place_of(c)),
        "delta_bic": fixed(c.delta_bic),
        "explained": percent(explained(base, c.fit)),
        "chi2": number(c.fit.comparison.chi2_reduced("fit")),
        "holdout": number(c.fit.comparison.chi2_reduced("holdout")),
        "own": effect_parameters,
        "added": was_added(path, c),
    }


def parameter_rows(diagnosis: Diagnosis) -> list[Row]:
    """The fitted parameters, with where they come from and what is known of them."""
    origin = {name: c.effect for c in diagnosis.path for name in c.own_parameters}
    base = diagnosis.base.parameters
    return [
        row
        | {
            "origin": origin.get(name, "base model"),
            "base": estimate_texts(base[name])[0] if name in base else NOTHING,
        }
        for name, row in estimate_rows(diagnosis.final.parameters).items()
    ]


def estimate_rows(estimates: Mapping[str, Estimate]) -> dict[str, Row]:
    """Estimates with their intervals, by name."""
    rows = {}
    for name, estimate in estimates.items():
        value, interval = estimate_texts(estimate)
        rows[name] = {
            "name": name,
            "value": value,
            "interval": interval,
            "unit": unit_text(estimate.unit),
            "remark": remark(estimate),
        }
    return rows


def missing_rows(diagnosis: Diagnosis) -> dict[str, Any] | None:
    """What is left that no effect explains; None where all is explained."""
    missing = diagnosis.missing_term
    if missing is None:
        return None
    rows = [
        {
            "name": name,
            "rmse": quantity_text(s.rmse, diagnosis.data.signals[name].unit),
            "size": number(s.noise_standard_deviations),
            "with": s.correlates_with or NOTHING,
            "correlation": number(s.correlation, 2),
        }
        for name, s in missing.signals.items()
    ]
    return {
        "balance": words(missing.balance or ""),
        "rows": rows,
        "where": rule_rows(missing.where),
    }
