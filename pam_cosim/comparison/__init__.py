"""Trajectory and data set -> residuals, scores, and where the error sits."""

from pam_cosim.comparison.coloured_noise import (
    approximate_log_likelihood,
    noise_log_likelihood,
)
from pam_cosim.comparison.compare import Comparison, compare, scored
from pam_cosim.comparison.condition_table import (
    STATISTICS,
    Condition,
    ConditionTable,
    Statistic,
    check_conditions,
    write_tables,
)
from pam_cosim.comparison.conventions import Convention, likely_convention
from pam_cosim.comparison.error_regions import Rule, samples_in, where
from pam_cosim.comparison.outliers import outliers, without_outliers
from pam_cosim.comparison.plausibility import Doubt, place_in
from pam_cosim.comparison.residual_statistics import (
    ResidualStatistics,
    Series,
    autocorrelation,
    lag_one,
    residual_statistics,
    series_of,
)
from pam_cosim.comparison.residuals import (
    RunComparison,
    simulate_run,
    simulate_runs,
    warnings_of,
)
from pam_cosim.comparison.rounding import (
    expected_squares,
    slope,
    standardized_residuals,
    usual_square,
)
from pam_cosim.comparison.scores import SignalScore, chi2_reduced, score

__all__ = [
    "STATISTICS",
    "Comparison",
    "Condition",
    "ConditionTable",
    "Convention",
    "Doubt",
    "ResidualStatistics",
    "Rule",
    "RunComparison",
    "Series",
    "SignalScore",
    "Statistic",
    "check_conditions",
    "chi2_reduced",
    "noise_log_likelihood",
    "approximate_log_likelihood",
    "compare",
    "expected_squares",
    "lag_one",
    "likely_convention",
    "outliers",
    "place_in",
    "autocorrelation",
    "residual_statistics",
    "score",
    "scored",
    "series_of",
    "simulate_run",
    "simulate_runs",
    "samples_in",
    "slope",
    "usual_square",
    "warnings_of",
    "standardized_residuals",
    "where",
    "without_outliers",
    "write_tables",
]
