"""Fit and catalogue of effects -> which effect is missing."""

from pam_cosim.diagnosis.candidate import Candidate
from pam_cosim.diagnosis.diagnose import Diagnosis, diagnose
from pam_cosim.diagnosis.verdict import Verdict

__all__ = ["Candidate", "Diagnosis", "Verdict", "diagnose"]
