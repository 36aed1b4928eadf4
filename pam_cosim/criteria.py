"""Every number that decides which effect a diagnosis names, with its unit, the reason for it and its source.

The rooms read ``CRITERIA``, and ``docs/criteria.md`` is this file as a table. The text below a number is
"unit | reason" or "unit | reason | source"; without a source the number is chosen: neither theory nor a measurement
fixes it. Every other number is a constant of the module that uses it.

Sources: "Kass and Raftery 1995" is Bayes factors, Journal of the American Statistical Association 90, 773-795, whose
scale is twice the logarithm of the Bayes factor, which the Bayesian information criterion approximates. "Blind score"
means that cases of ``benchmarks/hidden_effects`` showed which value serves.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class NoiseCriteria:
    """How an instrument's noise is separated from its signal, and an outlier from noise."""

    fewest_samples: int = 30
    """samples | fewer determine the noise of a signal to no better than a fifth"""
    orders: tuple[int, ...] = (2, 3, 4, 5, 6)
    """1 | orders of differences that are tried; the first that higher orders do not lower counts"""
    clip: float = 3.0
    """sd | larger differences are steps of the signal and are left out; their share is compensated"""
    level_tolerance: float = 0.05
    """1 | a higher order must lower the estimate by more than this share"""
    level_spread: float = 2.0
    """1/sqrt(samples) | or by more than this, where chance alone lowers the estimate of few samples"""
    slight_rounding: float = 0.01
    """of the noise variance | smaller rounding of a record is neglected"""
    stepwise: float = 0.9
    """of samples | share of equal steps above which a column is held between its readings or settings"""
    off_step: float = 0.05
    """of a step | largest distance of a sample of a rounded record from its steps, due to units and digits of a file"""
    least_of_step: float = 0.1
    """of a step | smallest noise assumed with rounding: a smaller one is not visible, and no model is that exact"""
    assumed_share: float = 0.01
    """of range | noise assumed where none is stated and the samples show none, as for points of a figure"""
    same_test: float = 0.01
    """of range | largest difference of inputs and durations of two runs that repeat each other"""
    fewest_repeated: int = 10
    """samples | of repeated runs; fewer determine a standard deviation to no better than a quarter"""
    repeatability_excess: float = 0.2
    """noise variances | excess of the scatter of repeated runs above which it replaces the noise; less may be chance"""
    outlier_window: int = 7
    """samples | three neighbours on each side outvote a pair of outliers"""
    outlier_far: float = 6.0
    """sd | Gaussian noise alone does this once in 5e8 samples | normal distribution"""
    outliers_together: int = 2
    """samples | adjacent outliers, compared with the best model, that chance explains"""
    outlier_alone: float = 0.5
    """of its size | deviation of a neighbour above which a fast change of the signal explains both"""
    outlier_fewest: int = 50
    """samples | fewer do not determine the median deviation well enough"""
    outlier_most: float = 0.03
    """of samples | more distant samples have another reason than errors of a logger"""


@dataclass(frozen=True)
class StartCriteria:
    """Where a run begins: what its first samples indicate, and how far start values may be from that."""

    most_samples: int = 100
    """samples | at the beginning of a run, which a line is fitted to at most"""
    bent: float = 3.0
    """sd | of chi-square, above which the first samples are not on a line any more"""
    moving: float = 4.0
    """sd | of the slope of the first samples, below which they do not show a motion"""
    away: float = 6.0
    """sd | of the noise, within which a first sample agrees with the model's own start"""
    runs: int = 3
    """runs | fewest of which one may differ and still leave an offset that most have in common"""
    range: float = 1.0
    """of range | prior sd of a start value, relative to the range of that state in the runs"""
    informed: float = 0.5
    """1 | share of the prior variance that remains; with less the data determine the start value"""
    worth: float = 1.5
    """1 | sum of squares with the model's own start over that with an estimated one, from which on it is estimated;
    over the first samples, or over whole runs where a constant offset of an instrument is an alternative"""
    offset: float = 0.1
    """of range | a larger reading at rest is no offset of an instrument"""
    pause: float = 10.0
    """intervals | a longer one is a pause of the logger"""
    periods: int = 50
    """periods | of a periodic recording that are simulated before it at most"""
    round: float = 0.1
    """sd | of the noise, by which a periodic motion may differ from its limit"""
    steps: int = 8
    """steps | of Newton's method for the start values of a run at given parameters"""
    linear: float = 0.01
    """1 | of the squares: a smaller linearised reduction by another step ends the iteration"""
    near: float = 0.03
    """sd | of the prior of a start value, within which slopes stay the same"""


@dataclass(frozen=True)
class ResidualCriteria:
    """What distinguishes structure in residuals from noise."""

    correlated: float = 4.0
    """sd | score of the lag-one correlation above which residuals are correlated: white noise does it once in 3e4 data
    sets | normal distribution"""
    correlated_of_few: float = 3.0
    """sd | the same for few samples: the score of n samples cannot exceed sqrt(n) | normal distribution"""
    many_samples: int = 100
    """samples | from here on correlation alone decides; with fewer samples the level decides too"""
    level_of_few: float = 4.0
    """sd | of chi-square, above which few samples are more than the stated noise | chi-square distribution"""
    slight_excess: float = 0.1
    """noise variances | below this excess (0.3 sd rms) a residual may be a small error in the form of an effect"""
    drift: float = 0.3
    """noise variances | excess as drifts have it: a wander of half a standard deviation has a quarter | blind score"""
    loud: float = 1.5
    """noise variances | mean square above which a verdict mentions more noise than stated"""
    far_above: float = 9.0
    """noise variances | mean square above which white residuals are no noise: few levels are three times off"""
    lags: int = 8
    """samples | distances over which the colour of the noise is distinguished from a slow time series"""
    reddest: float = 0.95
    """1 | correlation of neighbours; redder noise cannot be distinguished from a slow time series"""
    colours: int = 39
    """1 | steps of 0.025 in that correlation, finer than samples determine it"""
    longest_memory: float = 0.2
    """of a series | the autocorrelation is summed over no more; beyond, there are few pairs"""
    memory_gone: float = 2.0
    """sd | of white noise's autocorrelation, below which a lag ends the sum | normal distribution"""


@dataclass(frozen=True)
class FitCriteria:
    """When a fit is done, and which parameters it determines."""

    evaluations: int = 60
    """evaluations | of each descent, at most"""
    screening_evaluations: int = 8
    """evaluations | enough to distinguish valleys"""
    precision: float = 1e-6
    """of chi-square | a smaller reduction changes no estimate by a hundredth sd"""
    screened_starts: int = 4
    """starts | best initial guesses, which go a few steps; the lowest is followed to its end"""
    spread_starts: int = 16
    """points | of a Sobol sequence over the bounds, that many starts begin with"""
    rescue_starts: int = 32
    """points | tried within the bounds where no start can be simulated"""
    at_noise: float = 1.2
    """noise variances | mean square of the residuals below which no second start is needed"""
    log_ratio: float = 100.0
    """1 | bounds with a larger ratio are searched by order of magnitude"""
    tolerance: float = 1e-6
    """1 | of the solver, relative: its error must be far below the noise"""
    dead: float = 1e-7
    """of the largest slope | a parameter with less does not move the model"""
    at_bound: float = 1e-6
    """of the range | an estimate this near a bound ended there"""
    seen: float = 1e-6
    """of the largest singular value | directions below are not determined by the data"""
    blind: float = 1e-3
    """1 | share of an undetermined direction that makes a parameter undetermined"""


@dataclass(frozen=True)
class EvidenceCriteria:
    """When one model is better than another, and good enough."""

    very_strong: float = 10.0
    """1 | difference of the criterion that counts as very strong | Kass and Raftery 1995"""
    least_samples: float = 2.0
    """independent samples | at least, in the BIC penalty of a parameter"""
    beyond_doubt: float = 0.02
    """of the excess | largest remainder of the one family that is named although its law is not listed | blind score"""
    least_rms: float = 0.5
    """sd rms | in a signal, that a further effect takes away at least to be called missing | blind score"""
    least_share: float = 0.05
    """of the excess | of the base model, that a further effect takes away otherwise | blind score"""
    visible: float = 0.1
    """of the error beyond the noise | squared, in a signal, or in runs that were left out, that an effect takes away at
    least: what is worth less beside what remains may stand in for a part of that"""
    rival_ratio: float = 3.0
    """times that | smallest remainder of every other family in that case | blind score"""
    temperature: float = 4.0
    """1 | divisor of the evidence that weighs rivals: samples, models and noise are not what the evidence assumes"""
    something_else: tuple[float, ...] = (-3.0, 5.2, 1.6, 2.2, 1.5, 1.0, 0.5)
    """logits | that no listed effect is the cause: always; in addition where structure remains, only the form is open,
    nothing was added; where nothing checks an effect, with several effects, with a general one | blind score"""
    refuted: float = 2.0
    """times | ratio of the errors on signals that were not fitted, above which a rival is refuted"""
    detection_limit: float = 0.3
    """of what a signal moves | smallest rms error that is found, above which data show nothing that matters"""


@dataclass(frozen=True)
class SearchCriteria:
    """Which effects are tried, how long, and when the search is over."""

    patience: int = 10_000_000
    """rows | that are simulated without visible progress, where no limit is stated, before a search ends: one to two
    minutes of processor time"""
    rows: int = 1000
    """rows | of a linearised model: noise of neighbours averages out in them"""
    first_tried: int = 12
    """effects | with the best predicted criterion, which are tried alone first"""
    not_linear: float = 0.05
    """of a gain | error of a linearised prediction: models are not linear"""
    stated_ratio: tuple[float, float, float] = (0.5, 1.05, 2.0)
    """1 | of a parameter to its stated value: at least, at the start of a search, at most"""
    looks: int = 8
    """strengths | of an effect that are simulated with the base model, at most"""
    weaker: float = 0.1
    """1 | factor to the next strength where an effect acts the wrong way, or the simulation fails"""
    same_strength: float = 0.2
    """of a strength | smallest difference of another strength that is simulated as well"""
    little: float = 0.1
    """1 | of the sum of squares, or of the proportional change: less counts as nothing"""
    idle: float = 1e-6
    """of the sum of squares | slopes of an effect with a smaller influence may be meaningless"""
    together: int = 4
    """models | fitted before the next are chosen"""
    leading_families: int = 3
    """families | of which a member promises most beside a model, and all of whose members are looked at there"""
    starts: int = 12
    """models | the best of their families, which a further effect is added to by prediction"""
    rounds: int = 8
    """rounds | of fits of models with so many effects, at most"""
    most_effects: int = 8
    """effects | in one explanation, at most"""
    evaluations: int = 40
    """evaluations | of each descent of a candidate: some valleys are long"""
    precision: float = 1e-4
    """of chi-square | reduction at which these descents end: slower ones lead nowhere"""
    screening_evaluations: int = 6
    """evaluations | enough to distinguish a likely effect from an unlikely one"""
    screening_tolerance: float = 1e-5
    """1 | of the solver in these evaluations"""
    longest_run: tuple[int, int] = (10_000, 50)
    """steps | of the solver, and more for each row, that a run with an effect may take: fifty times what is usual; the
    effect chatters there"""
    combined_parameters: int = 2
    """parameters | started in all combinations of orders of magnitude"""
    decades: int = 1
    """decades | up and down, by which the initial guess of an effect's parameter is varied"""
    pruning_excess: float = 0.5
    """noise variances | a model with a larger excess is not the last one anyway"""


@dataclass(frozen=True)
class FoldsCriteria:
    """When an effect is named although the residuals have structure."""

    fewest: int = 3
    """runs | of fewer, too few are left to fit"""
    most: int = 5
    """folds | that runs are left out in: the usual number"""
    beyond: float = 2.0
    """times | the usual error, of runs that are named because the others do not predict them"""
    believable: float = 1.5
    """times | a larger ratio to the stated value is no error of a ruler or a balance"""


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
