"""Many runs of one model: which, what is kept of each, where they are made, and their one result."""

from pam_cosim.sweeps.design import DESIGNS, Design, design_of
from pam_cosim.sweeps.result import Sweep, SweepPoint
from pam_cosim.sweeps.scalars import FUNCTIONS, Scalar, read_scalars
from pam_cosim.sweeps.spans import MOST_RUNS
from pam_cosim.sweeps.sweep import SweepPlan, make_sweep, partial_of, same

__all__ = [
    "DESIGNS",
    "Design",
    "FUNCTIONS",
    "MOST_RUNS",
    "SweepPlan",
    "Scalar",
    "Sweep",
    "SweepPoint",
    "design_of",
    "make_sweep",
    "partial_of",
    "read_scalars",
    "same",
]
