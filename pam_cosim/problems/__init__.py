"""Data set, model and stated values -> a problem: every value with its source, resolved once."""

from pam_cosim.problems.corrections import (
    Correction,
    annotation_of,
    corrections_in,
    corrections_of,
    parsed_correction,
)
from pam_cosim.problems.problem import ModelValues, ParameterValue, Problem
from pam_cosim.problems.resolution import problem

__all__ = [
    "Correction",
    "ModelValues",
    "ParameterValue",
    "Problem",
    "annotation_of",
    "corrections_in",
    "corrections_of",
    "parsed_correction",
    "problem",
]
