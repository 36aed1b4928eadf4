"""The steps of a study as one function each; ``pam_cosim`` offers them all.

A function is loaded when it is asked for: a command that simulates loads nothing that diagnoses.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pam_cosim.simulation.models import build, describe
    from pam_cosim.study.additions import add
    from pam_cosim.study.comparisons import compare
    from pam_cosim.study.coupling import couple, read_system, start, write_system
    from pam_cosim.study.data_sets import new, read
    from pam_cosim.study.diagnoses import check, diagnose, draw, live
    from pam_cosim.study.dynamics import frequency_response, linearise, linearise_along
    from pam_cosim.study.fits import fit, profile
    from pam_cosim.study.judged_fmu import build_with_data, evidence
    from pam_cosim.study.library import bench, benches, effects, rig_parts
    from pam_cosim.study.many_runs import sweep
    from pam_cosim.study.observing import observe
    from pam_cosim.study.plans import plan
    from pam_cosim.study.predictions import predict
    from pam_cosim.study.problems import problem
    from pam_cosim.study.products import load, save
    from pam_cosim.study.runs import simulate

__all__ = [
    "add",
    "bench",
    "benches",
    "build",
    "build_with_data",
    "check",
    "compare",
    "couple",
    "describe",
    "diagnose",
    "draw",
    "effects",
    "evidence",
    "fit",
    "frequency_response",
    "linearise",
    "linearise_along",
    "live",
    "load",
    "new",
    "observe",
    "plan",
    "predict",
    "problem",
    "profile",
    "read",
    "read_system",
    "rig_parts",
    "save",
    "simulate",
    "start",
    "sweep",
    "write_system",
]

# The homes of the functions, by module.
_MODULES = {
    "pam_cosim.simulation.models": ("build", "describe"),
    "pam_cosim.study.additions": ("add",),
    "pam_cosim.study.comparisons": ("compare",),
    "pam_cosim.study.coupling": ("couple", "read_system", "start", "write_system"),
    "pam_cosim.study.data_sets": ("new", "read"),
    "pam_cosim.study.diagnoses": ("check", "diagnose", "draw", "live"),
    "pam_cosim.study.dynamics": ("frequency_response", "linearise", "linearise_along"),
    "pam_cosim.study.observing": ("observe",),
    "pam_cosim.study.judged_fmu": ("build_with_data", "evidence"),
    "pam_cosim.study.fits": ("fit", "profile"),
    "pam_cosim.study.library": ("bench", "benches", "effects", "rig_parts"),
    "pam_cosim.study.many_runs": ("sweep",),
    "pam_cosim.study.plans": ("plan",),
    "pam_cosim.study.predictions": ("predict",),
    "pam_cosim.study.problems": ("problem",),
    "pam_cosim.study.products": ("load", "save"),
    "pam_cosim.study.runs": ("simulate",),
}
_HOMES = {name: module for module, names in _MODULES.items() for name in names}

if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        if name in _HOMES:
            return getattr(import_module(_HOMES[name]), name)
        raise AttributeError(f"module 'pam_cosim.study' has no attribute '{name}'")
