"""Every number that decides which effect a diagnosis names, with its unit, the reason for it and its source.

The rooms read ``CRITERIA``, and ``docs/criteria.md`` is this file as a table. Every other number is a constant of the
module that uses it.

Sources: "Kass and Raftery 1995" is Bayes factors, Journal of the American Statistical Association 90, 773-795, whose
scale is twice the logarithm of the Bayes factor, which the Bayesian information criterion approximates. "Blind score"
means that cases of ``benchmarks/hidden_effects`` showed which value serves; "chosen" means that neither theory nor a
measurement fixes it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

CHOSEN = "chosen"
BLIND = "blind score"
BAYES = "Kass and Raftery 1995"


def decides(value: Any, unit: str, reason: str, source: str = CHOSEN) -> Any:
    """A field with its default, unit ("1" for a plain number), reason and source."""
    return field(default=value, metadata={"unit": unit, "reason": reason, "source": source})


@dataclass(frozen=True)
class NoiseCriteria:
    """How an instrument's noise is told from its signal, and a slip from noise."""

    fewest_samples: int = decides(
        30, "samples", "fewer tell the noise of a signal to no better than a fifth"
    )
    orders: tuple[int, ...] = decides(
        (2, 3, 4, 5, 6),
        "1",
        "orders of differences that are tried; the first that higher ones do not lower counts",
    )
    clip: float = decides(
        3.0,
        "sd",
        "larger differences are steps of the signal and sharpen no estimate; their share is made up for",
    )
    level_tolerance: float = decides(
        0.05, "1", "a higher order must lower the estimate by more than this share"
    )
    level_spread: float = decides(
        2.0,
        "1/sqrt(samples)",
        "or by more than this, where the samples are so few that chance lowers it",
    )
    slight_rounding: float = decides(
        0.01, "of the noise variance", "steps of a record that add less do not count"
    )
    stepwise: float = decides(
        0.9, "of samples", "equal steps of a column that is held between its readings or settings"
    )
    off_step: float = decides(
        0.05,
        "of a step",
        "that units and digits of a file may put a sample of a record in steps off; others lie anywhere",
    )
    least_of_step: float = decides(
        0.1,
        "of a step",
        "noise beside rounding, at least: less is hardly seen, and no model is that exact",
    )
    assumed_share: float = decides(
        0.01,
        "of range",
        "noise assumed where nobody states it and the samples show none, as points of a figure",
    )
    same_test: float = decides(
        0.01,
        "of range",
        "that inputs and durations of two runs differ by at most, for one to repeat the other",
    )
    fewest_repeated: int = decides(
        10,
        "samples",
        "of repeated runs; fewer tell a standard deviation to no better than a quarter",
    )
    repeatability_excess: float = decides(
        0.2,
        "noise variances",
        "by which repeated runs differ more than the noise, to count in its place: less may be chance",
    )
    outlier_window: int = decides(
        7, "samples", "three neighbours on each side outvote a pair of outliers"
    )
    outlier_far: float = decides(
        6.0, "sd", "Gaussian noise alone does this once in 5e8 samples", "normal distribution"
    )
    outliers_together: int = decides(
        2, "samples", "that may be off side by side, by chance, beside the best model"
    )
    outlier_alone: float = decides(
        0.5,
        "of its size",
        "what a neighbour may be off too: a quick change of the signal takes its neighbours along",
    )
    outlier_fewest: int = decides(
        50, "samples", "of fewer, the median deviation is not known well enough"
    )
    outlier_most: float = decides(
        0.03, "of samples", "more lie far off for another reason than a slip"
    )


@dataclass(frozen=True)
class StartCriteria:
    """Where a run begins: what its first samples say, and how far start values may be from that."""

    most_samples: int = decides(
        100, "samples", "at the beginning of a run, through which a line is laid at most"
    )
    bent: float = decides(
        3.0, "sd", "of chi-square, from which on the first samples are not on a line any more"
    )
    moving: float = decides(
        4.0, "sd", "of the slope of the first samples, below which they do not show a motion"
    )
    away: float = decides(
        6.0, "sd", "of the noise, within which a first sample agrees with the model's own start"
    )
    runs: int = decides(
        3, "runs", "at least, of which one may differ, to know an offset that most have in common"
    )
    range: float = decides(
        1.0, "of range", "sd of a start value by what the runs go through in that state"
    )
    informed: float = decides(
        0.5, "1", "share of the variance beforehand that must be left: less, and the data tell it"
    )
    worth: float = decides(
        1.5, "1", "sum of squares with the model's own start over that with an estimated one, from which on it is "
        "estimated; over the first samples, or over whole runs where a constant offset of an instrument could be why",
    )  # fmt: skip
    offset: float = decides(
        0.1, "of range", "a larger reading at rest is no offset of an instrument"
    )
    pause: float = decides(
        10.0, "intervals", "a longer one is a pause, after which a run begins anew"
    )
    periods: int = decides(
        50, "periods", "of a periodic recording that are simulated before it at most"
    )
    round: float = decides(
        0.1, "sd", "of the noise, by which a periodic motion may differ from what it comes to"
    )
    steps: int = decides(
        8, "steps", "of Newton's method for the start values of a run, beside given parameters"
    )
    linear: float = decides(
        0.01, "1", "of the squares, that a further step may take away by the slopes alone"
    )
    near: float = decides(
        0.03,
        "sd",
        "of what is known of a start value beforehand, within which slopes stay the same",
    )


@dataclass(frozen=True)
class ResidualCriteria:
    """What tells structure in residuals from noise."""

    correlated: float = decides(
        4.0, "sd", "score of the lag-one correlation above which residuals are correlated: white noise does it once in "
        "3e4 data sets", "normal distribution",
    )  # fmt: skip
    correlated_of_few: float = decides(
        3.0,
        "sd",
        "the same for few samples: the score of n samples cannot exceed sqrt(n)",
        "normal distribution",
    )
    many_samples: int = decides(
        100, "samples", "from here on correlation tells by itself; below, the level helps"
    )
    level_of_few: float = decides(
        4.0,
        "sd",
        "of chi-square, above which few samples are more than the stated noise",
        "chi-square distribution",
    )
    slight_excess: float = decides(
        0.1,
        "noise variances",
        "less, a third of a standard deviation, nobody sees: it may be the form of an effect that was found",
    )
    drift: float = decides(
        0.3,
        "noise variances",
        "mean square beyond the noise, as drifts have it: a wander of half a standard deviation has a quarter",
        BLIND,
    )
    loud: float = decides(
        1.5,
        "noise variances",
        "mean square from which on a verdict mentions more noise than stated",
    )
    lags: int = decides(
        8, "samples", "distances over which the colour of the noise is told from a slow course"
    )
    reddest: float = decides(
        0.95, "1", "correlation of neighbours; redder noise cannot be told from a slow course"
    )
    colours: int = decides(
        39, "1", "steps of 0.025 in that correlation, finer than samples tell it"
    )
    longest_memory: float = decides(
        0.2, "of a series", "the autocorrelation is summed over no more; beyond, few pairs"
    )
    memory_gone: float = decides(
        2.0,
        "sd",
        "of white noise's autocorrelation, below which a lag ends the sum",
        "normal distribution",
    )


@dataclass(frozen=True)
class FitCriteria:
    """When a fit is done, and which parameters it determines."""

    evaluations: int = decides(60, "evaluations", "of each descent, at most")
    screening_evaluations: int = decides(8, "evaluations", "enough to tell one valley from another")
    precision: float = decides(
        1e-6, "of chi-square", "a step that brings less changes no estimate by a hundredth sd"
    )
    screened_starts: int = decides(
        4, "starts", "go a few steps, the best by a glance; the lowest is followed to its end"
    )
    spread_starts: int = decides(
        16, "points", "of a Sobol sequence over the bounds, that many starts begin with"
    )
    rescue_starts: int = decides(
        32, "points", "tried within the bounds where no start can be simulated"
    )
    at_noise: float = decides(
        1.2,
        "noise variances",
        "mean square of the residuals that needs no second start: little is left to find",
    )
    log_ratio: float = decides(
        100.0, "1", "bounds further apart are searched by order of magnitude"
    )
    tolerance: float = decides(
        1e-6, "1", "of the solver, relative: its error must be far below the noise"
    )
    dead: float = decides(
        1e-7, "of the largest slope", "a parameter with less does not move the model"
    )
    at_bound: float = decides(1e-6, "of the range", "an estimate this near a bound ended there")
    seen: float = decides(
        1e-6, "of the largest singular value", "directions below are not determined by the data"
    )
    blind: float = decides(
        1e-3, "1", "share of an undetermined direction that makes a parameter undetermined"
    )


@dataclass(frozen=True)
class EvidenceCriteria:
    """When one model is better than another, and good enough."""

    very_strong: float = decides(
        10.0, "1", "difference of the criterion that counts as very strong", BAYES
    )
    least_samples: float = decides(
        2.0, "independent samples", "that the BIC penalty of a parameter is reckoned from"
    )
    beyond_doubt: float = decides(
        0.02, "of the excess", "the one family whose form nobody listed leaves no more", BLIND
    )
    rival_ratio: float = decides(3.0, "times that", "every other family must leave then", BLIND)
    temperature: float = decides(
        4.0,
        "1",
        "the evidence over this weighs rivals: samples, models and noise are not what the evidence assumes",
    )
    something_else: tuple[float, ...] = decides(
        (-3.0, 5.2, 1.6, 2.2, 1.5, 1.0, 0.5), "logits", "of what no effect describes: always; more where structure is "
        "left, only the form is open, nothing was added; where nothing checks an effect, of several, of a general one",
        BLIND,
    )  # fmt: skip
    refuted: float = decides(
        2.0, "times", "error of a rival on signals that nobody fitted; more refutes it"
    )


@dataclass(frozen=True)
class SearchCriteria:
    """Which effects are tried, how long, and when the search is over."""

    rows: int = decides(
        1000, "rows", "of a linearised model: noise of neighbours averages out in them"
    )
    first_tried: int = decides(12, "effects", "that promise most are tried by themselves first")
    not_linear: float = decides(
        0.05, "of a reduction", "that slopes promise is lost: models are not linear"
    )
    stated_ratio: tuple[float, float, float] = decides(
        (0.5, 1.05, 2.0),
        "1",
        "of a parameter to what is stated of it: at least, where a search begins, at most",
    )
    looks: int = decides(
        8, "strengths", "of an effect that are looked at beside the base model, at most"
    )
    weaker: float = decides(
        0.1, "1", "factor to the next strength where an effect acts the wrong way, or breaks down"
    )
    same_strength: float = decides(
        0.2, "of a strength", "that another differs by at least, to be looked at as well"
    )
    little: float = decides(
        0.1, "1", "of the sum of squares, or of what is in proportion: less is as good as nothing"
    )
    idle: float = decides(
        1e-6, "of the sum of squares", "an effect that moves less may have slopes that say nothing"
    )
    together: int = decides(4, "models", "fitted before the next are chosen")
    leading_families: int = decides(
        3, "families", "whose members are all tried where no effect leaves noise"
    )
    likest_families: int = decides(
        2,
        "families",
        "that can do the likest to the samples as an effect of the answer, tried in its place",
    )
    rounds: int = decides(
        8, "rounds", "of fits of models with one effect, with two and with three, at most"
    )
    starts: int = decides(
        12, "models", "that further effects are reckoned on top of, and effects combined to two"
    )
    step: float = decides(
        0.6, "of the excess", "that a further effect is expected to leave at most, to be tried"
    )
    most_effects: int = decides(3, "effects", "in one explanation, at most")
    evaluations: int = decides(
        40, "evaluations", "of each descent of a candidate: some valleys are long"
    )
    precision: float = decides(
        1e-4, "of chi-square", "at which they end: creeping further leads nowhere"
    )
    screening_evaluations: int = decides(
        6, "evaluations", "tell a promising effect from a hopeless one"
    )
    screening_tolerance: float = decides(1e-5, "1", "of the solver then")
    longest_run: tuple[float, float] = decides(
        (2.0, 1e-3), "s", "of processor time, and more for each row, that a run with an effect may take: a hundred "
        "times what one needs; the effect chatters there, or the model breaks down",
    )  # fmt: skip
    combined_parameters: int = decides(
        2, "parameters", "started in all combinations of orders of magnitude"
    )
    decades: int = decides(
        1, "decades", "that the start of an effect's parameter is varied by, up and down"
    )
    pruning_excess: float = decides(
        0.5, "noise variances", "a model that leaves more is not the last one anyway"
    )


@dataclass(frozen=True)
class FoldsCriteria:
    """When an effect is named of which what remains is no noise."""

    fewest: int = decides(3, "runs", "of fewer, too little is left to fit")
    most: int = decides(5, "folds", "that runs are left out in: the usual number")
    visible: float = decides(
        0.1,
        "of the error beyond the noise",
        "squared, that an effect takes away in runs that were left out, at least",
    )
    beyond: float = decides(
        2.0,
        "times",
        "the usual error, of runs that are named because the others do not predict them",
    )
    believable: float = decides(
        1.5, "times", "more or less than stated is no slip of a ruler or a balance"
    )


@dataclass(frozen=True)
class Criteria:
    """All of them, by the question that they answer."""

    noise: NoiseCriteria = NoiseCriteria()
    starts: StartCriteria = StartCriteria()
    residuals: ResidualCriteria = ResidualCriteria()
    fit: FitCriteria = FitCriteria()
    evidence: EvidenceCriteria = EvidenceCriteria()
    search: SearchCriteria = SearchCriteria()
    folds: FoldsCriteria = FoldsCriteria()


CRITERIA = Criteria()
"""The numbers in force."""
