"""Comparison -> HTML."""

from __future__ import annotations

from pam_cosim.comparison import Comparison, score
from pam_cosim.reporting.account.diagnosis_rows import rule_rows
from pam_cosim.reporting.account.wording import NOTHING, number, quantity_text
from pam_cosim.reporting.figures.bars import where_picture
from pam_cosim.reporting.figures.curves import curve_pictures
from pam_cosim.reporting.figures.layer import alone
from pam_cosim.reporting.figures.residuals import residual_pictures
from pam_cosim.reporting.page import provenance, render, score_rows, signal_rows
from pam_cosim.wording import enumeration

Row = dict[str, str]


def comparison_report(comparison: Comparison) -> str:
    """A self-contained HTML page of one model on its data. Same input, same bytes."""
    layers = (alone(comparison),)
    return render(
        "comparison.html",
        title=comparison.data.title,
        model=layers[0].label,
        headline=_headline(comparison),
        scores=score_rows(comparison),
        curves=curve_pictures(layers),
        residuals=residual_pictures(layers),
        starts=comparison.data.starts,
        doubts=[doubt.text for doubt in comparison.doubts],
        where=where_picture(comparison.where) if comparison.where else None,
        rules=rule_rows(comparison.where),
        runs=_run_rows(comparison),
        names=list(comparison.data.signals),
        parameters=[(name, number(value, 4)) for name, value in comparison.parameters.items()],
        signals=signal_rows(comparison.data),
        runs_in_words=[run.describe() for run in comparison.data.runs],
        notes=comparison.data.notes(),
        provenance=provenance(comparison.data, comparison.model),
    )


def _headline(comparison: Comparison) -> str:
    parts = []
    for name, s in comparison.scores["all"].items():
        signal = comparison.data.signals[name]
        error, noise = (quantity_text(value, signal.unit) for value in (s.rmse, signal.sigma))
        parts.append(f"{error} in {name} (noise {noise})")
    return (
        f"The rms error over all runs is {enumeration(parts)}."
        if parts
        else "There is no sample to compare with."
    )


def _run_rows(comparison: Comparison) -> list[dict[str, object]]:
    rows: list[dict[str, object]] = []
    for run in comparison.runs:
        scores = score([run], comparison.data.signals)
        cells = [
            quantity_text(scores[name].rmse, signal.unit) if name in scores else NOTHING
            for name, signal in comparison.data.signals.items()
        ]
        rows.append({"name": run.run.name, "role": run.run.role, "cells": cells})
    return rows
