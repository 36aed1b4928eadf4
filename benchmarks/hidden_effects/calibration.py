"""Whether a stated probability means something: of the cases called 90 %, how many were right."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

from benchmarks.hidden_effects.goals import rate, wilson
from benchmarks.hidden_effects.outcome import stated_probability

Result = dict[str, Any]
EDGES = (0.0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0)


def stated(results: Sequence[Result]) -> np.ndarray:
    """Stated probability and whether it was so (0 or 1), shape (cases that state one, 2)."""
    pairs = [pair for r in results if (pair := stated_probability(r)) is not None]
    return np.array([(p, float(so)) for p, so in pairs]).reshape(-1, 2)


def brier(pairs: np.ndarray) -> float:
    """Mean square of stated probability minus outcome (Brier, 1950): 0 is best, 0.25 is what 50 % always gives."""
    return float(np.mean((pairs[:, 0] - pairs[:, 1]) ** 2))


def binned(pairs: np.ndarray) -> list[tuple[float, float, np.ndarray]]:
    """(low, high, pairs) of the classes that have cases; the upper end belongs to the last class alone."""
    ends = list(zip(EDGES[:-1], EDGES[1:], strict=True))
    chosen = [
        (low, high, pairs[(pairs[:, 0] >= low) & ((pairs[:, 0] < high) | (high == EDGES[-1]))])
        for low, high in ends
    ]
    return [one for one in chosen if len(one[2])]


def calibration_error(pairs: np.ndarray) -> float:
    """Expected calibration error: by how much the share that was right differs from what was stated, over classes."""
    gaps = [len(some) * abs(some[:, 0].mean() - some[:, 1].mean()) for _, _, some in binned(pairs)]
    return float(sum(gaps) / len(pairs))


def calibration_table(results: Sequence[Result]) -> list[str]:
    """Markdown: stated and true shares by class, and the Brier score; says so where no verdict states one."""
    pairs = stated(results)
    if not len(pairs):
        return ["No verdict states a probability."]
    base = float(pairs[:, 1].mean())
    lines = [
        f"{len(pairs)} verdicts state a probability (`unknown` does not count). Brier score {brier(pairs):.3f}; always "
        f"stating the share that is right, {100 * base:.0f} %, would give {base * (1 - base):.3f}. Expected "
        f"calibration error {100 * calibration_error(pairs):.1f} %.", "",
        "| stated | in the mean | right |", "|---|---|---|",
    ]  # fmt: skip
    for low, high, some in binned(pairs):
        hits = int(some[:, 1].sum())
        lines.append(
            f"| {100 * low:g} to {100 * high:g} % | {100 * some[:, 0].mean():.1f} % | {rate(hits, len(some))} |"
        )
    return lines


def draw_calibration(results: Sequence[Result], file: Path) -> bool:
    """The calibration curve with Wilson's intervals; False, and no file, where no verdict states a probability."""
    pairs = stated(results)
    if not len(pairs):
        return False
    figure, axes = plt.subplots(figsize=(5.2, 4.8), layout="constrained")
    axes.plot([0, 1], [0, 1], color="0.6", linestyle=":")
    for _, _, some in binned(pairs):
        hits = int(some[:, 1].sum())
        share, ends = hits / len(some), wilson(hits, len(some))
        bars = np.maximum([[share - ends[0]], [ends[1] - share]], 0.0)
        axes.errorbar(some[:, 0].mean(), share, bars, marker="o", capsize=3, color="#2a5f8f")
        axes.annotate(
            str(len(some)),
            (some[:, 0].mean(), share),
            xytext=(6, -10),
            textcoords="offset points",
            fontsize=8,
        )
    axes.set(xlabel="probability that the verdict states", ylabel="share that was right", xlim=(-0.03, 1.03),
             ylim=(-0.03, 1.03), title=f"Brier score {brier(pairs):.3f}, {len(pairs)} cases")  # fmt: skip
    figure.savefig(file, dpi=150)
    plt.close(figure)
    return True
