"""Horizontal bars with readable labels: where the error sits, what explains it, which balance it is in."""

from __future__ import annotations

import itertools
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from matplotlib.patches import Patch
from matplotlib.ticker import PercentFormatter

from pam_cosim.comparison import Rule
from pam_cosim.diagnosis.judgement.verdict_sentences import ProbabilityRow
from pam_cosim.reporting.account.diagnosis_rows import place_text
from pam_cosim.reporting.account.wording import percent, shortened
from pam_cosim.reporting.style import (
    BEFORE,
    BLUE,
    GREEN,
    INK,
    LINE,
    ORANGE,
    PINK,
    SKY,
    SOFT,
    WIDTH,
    Picture,
    drawing,
    legend_outside,
    new_figure,
    picture,
)
from pam_cosim.wording import words

_MOST_RULES = 10
_WIDE_ENOUGH = 0.06  # part of a bar that a number fits into
_WORST = -0.2  # an effect that makes the error larger is drawn to here


@dataclass(frozen=True)
class CandidateBar:
    """One candidate of the ranking: its label, the share it explains, its balance, and whether it was added."""

    label: str
    share: float
    balance: str
    added: bool


def where_picture(rules: Sequence[Rule]) -> Picture:
    """Share of the error and share of the time, rule by rule."""
    drawn_rules = list(rules[:_MOST_RULES])
    labels = [textwrap.fill(f"{r.signal}: {r.rule}", 46) for r in drawn_rules]
    with drawing():
        figure = new_figure(0.8 * WIDTH, 0.75 + 0.47 * len(drawn_rules))
        axes = figure.subplots()
        for i, rule in enumerate(drawn_rules):
            axes.barh(i - 0.19, rule.error_share, 0.36, color=BEFORE, zorder=3)
            axes.barh(i + 0.19, rule.time_share, 0.36, color=LINE, zorder=3)
            axes.text(
                rule.error_share + 0.01,
                i - 0.19,
                percent(rule.error_share),
                va="center",
                fontsize=7.5,
            )
            axes.text(
                rule.time_share + 0.01,
                i + 0.19,
                percent(rule.time_share),
                va="center",
                fontsize=7.5,
                color=SOFT,
            )
        axes.set_yticks(range(len(drawn_rules)), labels)
        axes.tick_params(axis="y", length=0, labelcolor=INK)
        axes.invert_yaxis()
        axes.set_xlim(0, 1.1)
        axes.set_xticks([0, 0.25, 0.5, 0.75, 1])
        axes.xaxis.set_major_formatter(PercentFormatter(1))
        axes.grid(True, axis="x")
        handles = [
            Patch(color=BEFORE, label="share of the signal's error"),
            Patch(color=LINE, label="share of the samples"),
        ]
        legend_outside(figure, handles, "outside upper right")
        return picture(
            figure,
            "Share of the error and of the samples in each part of the measurement",
            "A long coloured bar over a short grey one marks a small part of the measurement with much of the error. "
            "The physics of that part is the first clue to the missing effect.",
        )


def ranking_picture(
    bars: Sequence[CandidateBar], palette: Mapping[str, str], left_out: int, runs: str
) -> Picture:
    """How much of the base model's error each tried model explains."""
    with drawing():
        figure = new_figure(0.8 * WIDTH, 0.8 + 0.25 * len(bars))
        axes = figure.subplots()
        for i, bar in enumerate(bars):
            value = max(bar.share, _WORST)
            axes.barh(i, value, 0.72, color=palette[bar.balance], zorder=3)
            text = percent(bar.share) + ("  added" if bar.added else "")
            weight = "bold" if bar.added else "normal"
            axes.text(max(value, 0) + 0.01, i, text, va="center", fontsize=7.5, fontweight=weight)
        axes.set_yticks(range(len(bars)), [shortened(b.label, 52) for b in bars])
        axes.tick_params(axis="y", length=0, labelcolor=INK)
        for label, bar in zip(axes.get_yticklabels(), bars, strict=True):
            label.set_fontweight("bold" if bar.added else "normal")
        axes.invert_yaxis()
        axes.set_xlim(min(0.0, *(max(b.share, _WORST) for b in bars)), 1.16)
        axes.set_xticks([0, 0.25, 0.5, 0.75, 1])
        axes.xaxis.set_major_formatter(PercentFormatter(1))
        axes.axvline(0, color=SOFT, lw=0.8, zorder=4)
        axes.grid(True, axis="x")
        used = [b for b in palette if any(bar.balance == b for bar in bars)]
        handles = [Patch(color=palette[b], label=place_text(b)) for b in used]
        legend_outside(figure, handles, "outside upper right")
        more = (
            f" The best {len(bars)} are drawn; the table holds {left_out} more." if left_out else ""
        )
        worse = f" A bar to the left: the fitted model is worse there (cut at {percent(_WORST)})."
        note = (worse if any(b.share < 0 for b in bars) else "") + more
        return picture(
            figure,
            "Share of the error that each tried effect explains",
            f"Share of the base model's squared error beyond the noise that each model removes on the {runs} runs, "
            f"in the order of the evidence. Effects of one balance have one colour.{note}",
        )


def balance_picture(balance: Mapping[str, float], palette: Mapping[str, str]) -> Picture:
    """One bar, divided by balance."""
    with drawing():
        figure = new_figure(0.8 * WIDTH, 0.95)
        axes = figure.subplots()
        position = 0.0
        for name, share in balance.items():
            axes.barh(
                0, share, 0.6, left=position, color=palette[name], edgecolor="white", linewidth=1.2
            )
            if share > _WIDE_ENOUGH:
                axes.text(
                    position + share / 2,
                    0,
                    percent(share),
                    ha="center",
                    va="center",
                    color=_on(palette[name]),
                )
            position += share
        axes.set_xlim(0, 1)
        axes.axis("off")
        handles = [
            Patch(color=palette[n], label=f"{words(n)} {percent(s)}") for n, s in balance.items()
        ]
        legend_outside(figure, handles, "outside lower center")
        return picture(
            figure,
            "Share of each balance in the error that can be explained",
            "How the explainable error divides among the balances: each is counted with its best single effect.",
        )


def probability_picture(rows: Sequence[ProbabilityRow]) -> Picture:
    """One bar, divided by what may be missing; the last row is what no effect describes."""
    named_colours, other_colours = (
        itertools.cycle((BLUE, SKY)),
        itertools.cycle((ORANGE, GREEN, PINK)),
    )
    colours = [*(next(named_colours if row.named else other_colours) for row in rows[:-1]), SOFT]
    with drawing():
        figure = new_figure(0.8 * WIDTH, 0.75 + 0.22 * len(rows))
        axes = figure.subplots()
        position = 0.0
        for (_, share, _), colour in zip(rows, colours, strict=True):
            axes.barh(0, share, 0.6, left=position, color=colour, edgecolor="white", linewidth=1.2)
            if share > _WIDE_ENOUGH:
                axes.text(
                    position + share / 2,
                    0,
                    percent(share),
                    ha="center",
                    va="center",
                    color=_on(colour),
                )
            position += share
        axes.set_xlim(0, 1)
        axes.axis("off")
        labels = [f"{percent(share)}  {shortened(missing, 90)}" for missing, share, _ in rows]
        handles = [
            Patch(color=colour, label=label) for colour, label in zip(colours, labels, strict=True)
        ]
        figure.legend(handles=handles, loc="outside lower left", ncols=1)
        return picture(
            figure,
            f"Probability of what may be missing: {'; '.join(labels)}",
            "Probability of each possible cause, by the evidence of the fitted models. The last probability is how "
            "often such a verdict was wrong in cases of which the truth is known.",
        )


def _on(colour: str) -> str:
    """White on dark colours, ink on light ones."""
    red, green, blue = (int(colour[i : i + 2], 16) for i in (1, 3, 5))
    return "white" if 0.3 * red + 0.59 * green + 0.11 * blue < 140 else INK
