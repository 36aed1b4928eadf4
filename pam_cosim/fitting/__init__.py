"""Data set and model -> fitted parameters with intervals."""

from pam_cosim.fitting.bounded_linear import bounded_least_squares
from pam_cosim.fitting.chosen_starts import with_starts
from pam_cosim.fitting.combinations import Combination
from pam_cosim.fitting.discrepancy import Discrepancy, discrepancies
from pam_cosim.fitting.estimate import Estimate, estimates
from pam_cosim.fitting.fit import Fit, fit, profile
from pam_cosim.fitting.free import Free, base_parameters, free_parameter, model_parameter
from pam_cosim.fitting.holdout_uncertainty import HoldoutUncertainty
from pam_cosim.fitting.linear import (
    Linear,
    bounded_step,
    coloured_deviance,
    linearised,
    prior_rows,
    reduction_by,
    residual_rows,
    rows_of_series,
)
from pam_cosim.fitting.methods import METHODS, GlobalSearch, summary
from pam_cosim.fitting.options import FitOptions
from pam_cosim.fitting.parameter_file import (
    check_parameter_file,
    parameters_in,
    read_parameters,
    units_in,
    write_parameters,
)
from pam_cosim.fitting.parameter_posterior import ParameterPosterior, parameter_posterior
from pam_cosim.fitting.predictive_bands import Band, PredictiveBands, predictive_bands
from pam_cosim.fitting.profile import Profile, Profiles
from pam_cosim.fitting.solve import spread_starts
from pam_cosim.fitting.start_estimates import estimated_starts, runs_without_start, simulated
from pam_cosim.fitting.tracker import Convergence, FitProgress, Progress
from pam_cosim.fitting.without_priors import WithoutPriors, without_priors

__all__ = [
    "METHODS",
    "Band",
    "Combination",
    "Convergence",
    "Discrepancy",
    "Estimate",
    "Fit",
    "FitOptions",
    "Free",
    "GlobalSearch",
    "HoldoutUncertainty",
    "Linear",
    "ParameterPosterior",
    "PredictiveBands",
    "Profile",
    "Profiles",
    "Progress",
    "FitProgress",
    "WithoutPriors",
    "base_parameters",
    "check_parameter_file",
    "discrepancies",
    "bounded_least_squares",
    "bounded_step",
    "estimated_starts",
    "estimates",
    "fit",
    "free_parameter",
    "linearised",
    "model_parameter",
    "parameter_posterior",
    "parameters_in",
    "predictive_bands",
    "prior_rows",
    "profile",
    "read_parameters",
    "units_in",
    "reduction_by",
    "residual_rows",
    "coloured_deviance",
    "rows_of_series",
    "runs_without_start",
    "simulated",
    "spread_starts",
    "summary",
    "with_starts",
    "without_priors",
    "write_parameters",
]
