"""Rivals that a diagnosis leaves -> the runs that would decide between them."""

from pam_cosim.diagnosis.planning.design import plan
from pam_cosim.diagnosis.planning.limits import Limits, Range, limits_of
from pam_cosim.diagnosis.planning.run_plan import PlannedRun, RunPlan, Separation

__all__ = ["Limits", "PlannedRun", "Range", "RunPlan", "Separation", "limits_of", "plan"]
