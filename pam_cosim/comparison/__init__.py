"""Trajectory and data set -> residuals, scores, and where the error sits."""

from pam_cosim.comparison.compare import Comparison, compare
from pam_cosim.comparison.outliers import outliers, without_outliers
from pam_cosim.comparison.residuals import RunComparison, simulate_run, start_time
from pam_cosim.comparison.scores import SignalScore, chi2_reduced, score
from pam_cosim.comparison.where import Rule, where
from pam_cosim.comparison.whiteness import lag_one

__all__ = [
    "Comparison",
    "Rule",
    "RunComparison",
    "SignalScore",
    "chi2_reduced",
    "compare",
    "lag_one",
    "outliers",
    "score",
    "simulate_run",
    "start_time",
    "where",
    "without_outliers",
]
