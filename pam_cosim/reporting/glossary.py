"""Words of a report that a reader may not know, as ``docs/glossary.md`` has them."""

from __future__ import annotations

WORDS = {
    "balance": "of force, mass or energy in the model; *sensor* where an instrument is wrong, not the model",
    "ledger": (
        "the estimate of which balance fails: missing terms as unknown inputs, by a smoother, with their uncertainty"
    ),
    "residual": "measured minus model",
    "noise floor": "the mean square of residuals that the noise of the instruments explains",
    "repeatability": "standard deviation between runs of the same test (ISO 5725), the instrument's noise included",
    "compared but not fitted": (
        "of a signal that the data set records but does not list: no parameter is fitted to it, and it decides only "
        "between explanations that fit equally well without it"
    ),
    "folds": "runs are left out in turn, the model is fitted to the others and judged on those (cross-validation)",
    "Δ BIC": (
        "the Bayesian information criterion against the model without the effect; negative is better. It counts fitted "
        "runs, and held-out ones beyond the uncertainty of the parameters. Its *penalty* for a parameter is the "
        "logarithm of the effective number of fitted samples"
    ),
}


def glossary_entries() -> list[dict[str, str]]:
    """Each word with its anchor and its meaning, for a page."""
    return [
        {"word": word, "anchor": f"word-{index}", "meaning": meaning.replace("*", "")}
        for index, (word, meaning) in enumerate(WORDS.items())
    ]
