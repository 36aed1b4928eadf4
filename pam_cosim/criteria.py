"""Every number that decides what a study says, with its unit, the reason for it and where it comes from.

The rooms ask ``CRITERIA``; reports and documents print from it, and ``docs/criteria.md`` is this file as a table. A
number that only trades time for an accuracy far below the noise, such as the step control of a descent, stays with
its algorithm. The particle swarm's settings are the published ones and stay with the swarm.

Sources: "Kass and Raftery 1995" is Bayes factors, Journal of the American Statistical Association 90, 773-795, whose
scale is twice the logarithm of the Bayes factor, which the Bayesian information criterion approximates. "Blind score"
means that cases of ``benchmarks/hidden_effects`` showed which value serves; "chosen" means that neither theory nor a
measurement fixes it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, fields, is_dataclass
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
class StaticCriteria:
    """Which rows of a quasi-static measurement are a curve."""

    level: float = decides(
        0.02,
        "of range",
        "values that are nearer to one another are one: a set pressure, load or length as it was read",
    )
    shared: float = decides(
        2.0, "rows", "at each such value, on average; values that hardly come again are none"
    )
    constant: float = decides(1e-6, "of its size", "an input that varies less is one value")
    turn: float = decides(
        0.05, "of range", "a pressure that goes back by less has not turned: it is noise"
    )
    fewest: int = decides(3, "rows", "of a curve, on average; fewer are scattered points")
    near: float = decides(
        0.01, "of range", "within which a value that is held out is one of the file's"
    )


@dataclass(frozen=True)
class RecognitionCriteria:
    """How a new data set is drafted from recordings: what counts as rest, as held, as a step, as another run."""

    window: float = decides(
        0.01, "of samples", "means over so many are compared to tell rest from motion"
    )
    most_in_window: int = decides(30, "samples", "more would miss short rests of long recordings")
    fewest_in_window: int = decides(5, "samples", "fewer are no mean")
    still: float = decides(
        0.005, "of range", "means that differ by less are of a signal at rest, if noise is smaller"
    )
    still_noise: float = decides(
        4.0, "sd", "of the difference of two such means, below which it is noise"
    )
    noise_samples: int = decides(
        4000, "samples", "noise is estimated from pieces of so many, of a long recording"
    )
    noise_pieces: int = decides(5, "pieces", "spread over the recording")
    stepwise: float = decides(
        0.9, "of samples", "neighbours that are equal, of an input that is held between steps"
    )
    imposed: float = decides(
        0.2, "of range", "a column that moves less within runs than between them is held in each"
    )
    away: float = decides(
        5.0, "sd", "of the noise, from which on a reading at rest is away from zero"
    )
    offset: float = decides(
        0.1, "of range", "a reading at rest beyond it is no offset of an instrument"
    )
    unloaded: float = decides(
        0.05, "of the largest", "pressure below which the muscle counts as without pressure"
    )
    atmosphere: tuple[float, float] = decides(
        (90e3, 108e3), "Pa", "what a gauge of absolute pressure reads at rest"
    )
    ambient: float = decides(
        101325.0, "Pa", "ambient pressure where a recording says absolute", "standard atmosphere"
    )
    noiseless: float = decides(
        1e-5, "of range", "scatter below is of computed numbers, and no instrument's noise"
    )
    gaps: float = decides(
        0.1,
        "of samples",
        "a column that lacks more is measured, or an input that is logged on change",
    )
    long: int = decides(20000, "rows", "of a run, from which on means over several are proposed")
    follows: float = decides(
        0.5, "1", "correlation with the pressure, either way, from which on a column follows it"
    )
    constant: float = decides(
        10.0, "sd", "span of a column that is noise alone", "normal distribution"
    )
    alike: float = decides(
        0.02, "of the largest", "traits of runs that differ by less do not tell them apart"
    )
    steady: float = decides(
        0.3, "of its mean", "a supply pressure varies by less, and stays above the other"
    )
    held_out: float = decides(0.25, "of runs", "that are held out to be judged")
    uneven: float = decides(
        3.0, "median steps", "longer steps are of no clock, where nothing else says time"
    )
    most_points: int = decides(
        2000, "rows", "of a table without time; more points at rest nobody waits for"
    )
    levels_to_hold_out: int = decides(
        4, "values", "of what is imposed in a table; of fewer none is held out"
    )
    points_to_hold_out: int = decides(
        8, "values", "the same along a single curve, which needs most of them"
    )
    longest: float = decides(
        0.1, "m", "of a contraction that a file's name tells by its number alone"
    )
    near_data_sheet: float = decides(
        0.3, "of its value", "how far a fit may go from the fibres of a muscle's data"
    )
    nominal: float = decides(
        0.05, "of the length", "a longest length nearer to the nominal one is that at rest"
    )
    runs_to_hold_out: int = decides(
        3, "runs", "of fewer none is held out: they are needed for the fit"
    )
    pause: float = decides(
        10.0, "intervals", "of the usual length; a longer one is a pause of the logger"
    )
    pauses_listed: int = decides(3, "places", "at which time goes back that are named")


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
class WhereCriteria:
    """Which rules say where the error sits."""

    bands: int = decides(4, "1", "bands of each output: coarse enough to be remembered")
    least_samples: int = decides(2, "samples", "that a rule is about: one may be off by chance")
    least_value: float = decides(
        0.02, "1", "share of the error times what it exceeds the time share by; less is chance"
    )
    rules_per_signal: int = decides(3, "rules", "more are not read")
    still: float = decides(0.02, "of the fastest rate", "slower counts as rest or holding")
    edge_at_zero: float = decides(1e-3, "of range", "an edge this near zero is called zero")


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
class UncertaintyCriteria:
    """How certain estimates and predictions are, and which estimates the data confuse."""

    interval: float = decides(1.96, "sd", "half width of a 95 % interval", "normal distribution")
    tail: float = decides(0.025, "of samples", "on either side of a 95 % band")
    samples: int = decides(
        200, "samples", "of the parameters: the ends of a 95 % band are known to a seventh of an sd"
    )
    wider: float = decides(
        1.5, "sd", "of the posterior as it is about the optimum, that samples are drawn from"
    )
    least_effective: float = decides(
        20.0, "samples", "of equal weight, below which ends of a band are rough"
    )
    discarded_samples: int = decides(
        20, "samples", "the first ones, which know where the search began"
    )
    reflections: int = decides(1000, "reflections", "of a sample at the bounds, at most")
    same_hit: float = decides(1e-9, "quarter periods", "within which two hits of one wall are one")
    unseen: float = decides(
        10.0,
        "times the bounds' distance",
        "sd of what keeps a parameter that no sample sees finite",
    )
    parallel: float = decides(
        1e-3,
        "1",
        "relative difference of the slopes by two parameters' logarithms, below which they may be one",
    )
    exchange: float = decides(
        1.2, "1", "factor by which one of two is raised, and the other lowered, to see it"
    )
    unchanged: float = decides(
        0.02, "sd", "rms change of the residuals then, below which only their product is known"
    )
    profile_rise: float = decides(
        3.84,
        "1",
        "of chi-square along a profile, where the 95 % interval ends",
        "chi-square distribution",
    )
    flat: float = decides(
        0.1,
        "1",
        "rise of a profile below which others make up for all; a rise at their bounds is not the data's then",
    )
    profile_step: float = decides(
        0.7, "sd", "first step of a profile: three or four of them to the interval's end"
    )
    profile_points: int = decides(8, "points", "of a profile on each side, at most")
    profile_evaluations: int = decides(
        12, "evaluations", "to fit the others again at each, from the point before"
    )
    follows: float = decides(
        0.1, "1", "power of one parameter that another follows along a flat profile, at least"
    )
    off_course: float = decides(0.1, "of its course", "what the follower may be off that power")
    confused: float = decides(0.95, "1", "correlation of two estimates from which on a fit says so")
    loud: float = decides(
        1.5, "noise variances", "a verdict mentions that the noise is more than the stated one"
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
class LedgerCriteria:
    """When a balance fails, and when an instrument does."""

    at_noise: float = decides(
        1.3, "noise variances", "mean square of the residuals that leaves nothing to explain"
    )
    spacing: float = decides(0.04, "s", "between nodes of a run of middle length, at most")
    fewest_nodes: int = decides(50, "nodes", "of a short run")
    most_nodes: int = decides(400, "nodes", "of a long run: a matter of time")
    accuracy: float = decides(2e-4, "of a state's range", "that a step may be wrong by")
    refinements: int = decides(3, "rounds", "of making a grid finer")
    far_below: float = decides(
        0.2, "sd", "of a sample, by which a finer grid must change the outputs to be worth it"
    )
    parallel: float = decides(
        1e-6, "1", "sine squared below which two terms push the same way and are one"
    )
    free_prior: float = decides(
        5.0, "1", "the range of a free parameter over this is its prior standard deviation"
    )
    sensor_gain: float = decides(
        0.1, "1", "prior standard deviation of a factor of a reading: instruments are that good"
    )
    sensor_offset: float = decides(
        0.1, "of range", "prior standard deviation of an offset of a reading"
    )
    sensor_lags: int = decides(
        12, "1", "time constants tried for a reading that lags, in even ratios"
    )
    sensor_rounds: int = decides(3, "rounds", "of moving the free parameters beside a fault")
    sensor_promising: float = decides(
        0.5, "of the error", "that a fault may leave to be looked at again"
    )
    sensor_settled: float = decides(
        1.0, "1", "change of the deviance at which those rounds end: far below what is strong"
    )


@dataclass(frozen=True)
class LearningCriteria:
    """When a formula describes a missing term."""

    most_forms: int = decides(4, "addends", "more describe a measurement, not a term")
    most_ramps: int = decides(
        8, "addends", "of a spline: two variables, a line and three bends each"
    )
    parts_to_start_from: tuple[float, ...] = decides(
        (1.0, 0.1),
        "1",
        "of what a spline should be to first order; with all of it a model may break down",
    )
    rounding: float = decides(
        0.03, "of the span of a variable", "width of a bend: a tenth of the way between two"
    )
    still: float = decides(
        1e-15, "SI unit", "a variable that spans less rests, as a speed where points are at rest"
    )
    bends: int = decides(
        3, "bends", "of a spline in each variable; the samples between two are a quarter"
    )
    worth: float = decides(
        0.03, "of the error left", "in runs that were not asked, that a further addend must take"
    )
    least: float = decides(0.005, "of the whole term", "the same")
    described: float = decides(
        0.3, "variances of the term", "mean square that is its own uncertainty: enough said"
    )
    blocks: int = decides(4, "parts", "of a single run that take the place of runs")
    certain: float = decides(
        3.0, "1", "a deviation below the median's over this counts no more, lest few samples rule"
    )
    shape_span: float = decides(
        3.0, "times", "up and down, in which the number inside a form is sought"
    )
    signed: float = decides(
        0.1,
        "of the largest size",
        "that a variable must reach on both sides of zero to have a sign",
    )
    extreme: float = decides(
        0.02, "quantile", "on either side, beyond which values do not set a variable's size"
    )
    constant: float = decides(1e-3, "of its size", "a variable that varies less says nothing")
    same: float = decides(0.9995, "1", "correlation of two variables of which one is enough")


@dataclass(frozen=True)
class NextExperimentCriteria:
    """Which further runs are thought of."""

    factors: tuple[float, ...] = decides(
        (0.5, 0.75, 1.25, 1.5), "1", "on inputs and loads: within reach of most rigs"
    )
    paces: tuple[float, ...] = decides((0.5, 2.0), "1", "factors on all times")
    joined: int = decides(3, "changes", "best ones of a run, of which two are made together")
    listed_rules: int = decides(5, "rules", "of where the error sits, that describe a missing term")
    rivals: int = decides(
        4, "models", "that a run is designed for where none leaves noise: their pairs are six"
    )
    members: int = decides(
        3, "models", "of each explanation that is left: laws of its families that fit as well"
    )
    drawn: int = decides(
        40, "courses", "drawn at random within the limits of a rig before any is improved"
    )
    improved: int = decides(80, "courses", "made out of the best ones: twice as many as were drawn")
    parents: int = decides(6, "courses", "the best ones, out of which further ones are made")
    as_good: float = decides(
        0.8, "of chi-square", "of the best course, from which on a simpler one is taken"
    )
    levels: tuple[int, int] = decides(
        (2, 12), "levels", "of the inputs in a drawn course: what a person can follow"
    )
    recorded_levels: int = decides(
        60, "levels", "of a recorded course that is improved; more say the same"
    )
    cycles: tuple[float, float] = decides((0.5, 20.0), "a run", "of sines: slower ones are ramps")
    rows: int = decides(
        400, "samples", "of a course while courses are compared; all of them count in the end"
    )


@dataclass(frozen=True)
class DoubtCriteria:
    """When a person should look at the data before an effect is said to be missing."""

    far_off: float = decides(
        0.5, "of what a signal moves", "rms error from which a model explains little"
    )
    beyond_noise: float = decides(5.0, "sd", "of the noise, that anything doubtful is beyond")
    mended: float = decides(
        0.3, "of an error", "that a simple mistake may leave, if it is to explain it"
    )
    alike: float = decides(
        0.02, "of a factor or of an offset", "by which it may differ from a known one"
    )
    passed: float = decides(
        0.03, "of a signal's span", "beyond zero, or beyond what a model allows, counts as passed"
    )
    opposite: float = decides(
        0.02, "of a signal's span", "that runs differ by, in the data and in the model"
    )
    near: float = decides(
        0.02, "of the inputs' spans", "between samples at the same inputs, and in the model"
    )
    fewest: int = decides(20, "samples", "at the same inputs, to compare two runs by")
    most: int = decides(2000, "samples", "of a run that are looked at for that")


@dataclass(frozen=True)
class ResolutionCriteria:
    """What data could tell, before a model is fitted to them."""

    instrument: float = decides(
        0.005, "of what a signal spans", "noise of an instrument that is not there yet"
    )
    sharper: float = decides(
        0.8, "1", "factor on the deviation of parameters, above which a measurement helps little"
    )
    listed: int = decides(5, "measurements", "that would help, at most")
    still: float = decides(1e-9, "of its largest value", "a signal that moves less stands still")
    strongest: float = decides(1e3, "stated strengths", "that anybody would meet an effect at")


@dataclass(frozen=True)
class RunCriteria:
    """What is read off one run of a model, and how long it may take."""

    longest: tuple[float, float] = decides(
        (30.0, 1e-2), "s", "of processor time, and more for each row: a thousand times what a run needs; the model "
        "chatters there, or its values make it stiff beyond use",
    )  # fmt: skip
    steady_part: float = decides(
        0.1,
        "of a run",
        "its last part, over which a steady value is averaged and a settled variable stays where it is",
    )
    settled: float = decides(
        0.002,
        "of the whole change",
        "what moves more in the last part has not settled; where it comes to rest exponentially, "
        "the time to 90 % of the change is known to a hundredth then",
    )
    failures_kept: int = decides(10, "messages", "kinds of breakdown that are kept")
    rows_without_compiler: int = decides(
        10_000,
        "rows",
        "fitted or compared, up to which a model that is looked at, compared or briefly fitted is not compiled; "
        "measured: docs/speed.md",
    )


@dataclass(frozen=True)
class Criteria:
    """All of them, by the question that they answer."""

    recognition: RecognitionCriteria = RecognitionCriteria()
    noise: NoiseCriteria = NoiseCriteria()
    starts: StartCriteria = StartCriteria()
    static: StaticCriteria = StaticCriteria()
    residuals: ResidualCriteria = ResidualCriteria()
    where: WhereCriteria = WhereCriteria()
    fit: FitCriteria = FitCriteria()
    uncertainty: UncertaintyCriteria = UncertaintyCriteria()
    evidence: EvidenceCriteria = EvidenceCriteria()
    search: SearchCriteria = SearchCriteria()
    folds: FoldsCriteria = FoldsCriteria()
    ledger: LedgerCriteria = LedgerCriteria()
    learning: LearningCriteria = LearningCriteria()
    next_experiment: NextExperimentCriteria = NextExperimentCriteria()
    resolution: ResolutionCriteria = ResolutionCriteria()
    doubts: DoubtCriteria = DoubtCriteria()
    run: RunCriteria = RunCriteria()


@dataclass(frozen=True)
class Criterion:
    """One number: ``name`` as "group.field", its value, unit, reason and source."""

    name: str
    value: Any
    unit: str
    reason: str
    source: str

    @property
    def group(self) -> str:
        """The question that it answers, a field of ``Criteria``."""
        return self.name.partition(".")[0]

    @property
    def text(self) -> str:
        """The value as documents print it."""
        values = self.value if isinstance(self.value, tuple) else (self.value,)
        return ", ".join(f"{v:g}" for v in values)


def every_criterion(criteria: Criteria | None = None) -> Iterator[Criterion]:
    """All numbers, in the order in which data meets them."""
    for group in fields(criteria := criteria or CRITERIA):
        members = getattr(criteria, group.name)
        assert is_dataclass(members)
        for f in fields(members):
            yield Criterion(f"{group.name}.{f.name}", getattr(members, f.name), **f.metadata)


CRITERIA = Criteria()
"""The numbers in force."""
VERDICT = ("noise", "starts", "residuals", "fit", "evidence", "search", "folds")
"""The groups whose numbers a verdict may depend on; the others draft, describe, plan and draw."""
