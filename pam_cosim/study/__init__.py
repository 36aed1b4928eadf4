"""The steps of a study as one function each; ``pam_cosim`` offers them all.

A function is loaded when it is requested: a command that simulates loads nothing that diagnoses.
"""

from typing import TYPE_CHECKING

from pam_cosim.lazy_names import LazyNames

if TYPE_CHECKING:
    from pam_cosim.simulation.models import (
        build,  # makes the FMU of a model
        describe,  # the inputs, outputs and parameters of a model
    )
    from pam_cosim.study.additions import add  # writes a model with the effects of a diagnosis
    from pam_cosim.study.comparisons import compare  # compares a model with a data set
    from pam_cosim.study.coupling import (
        couple,  # makes a system of FMUs and controllers
        read_system,  # reads a system from TOML or SSP
        start,  # starts a run that is driven step by step
        write_system,  # writes a system as SSP
    )
    from pam_cosim.study.data_sets import (
        new,  # drafts a data set from the files of a laboratory
        read,  # reads a data set
    )
    from pam_cosim.study.diagnoses import (
        check,  # what a data set can determine, before any fit
        diagnose,  # finds the effects that a model lacks
        draw,  # draws a product as PNG
        live,  # draws the progress of a fit or a diagnosis in a notebook
    )
    from pam_cosim.study.dynamics import (
        frequency_response,  # the response of a model to sines of an input
        linearise,  # the linear model about an operating point
        linearise_along,  # the linear models at several times of a run
    )
    from pam_cosim.study.fits import (
        fit,  # fits the free parameters to a data set
        profile,  # the profile likelihood of each fitted parameter
    )
    from pam_cosim.study.library import (
        bench,  # composes a bench from parts
        benches,  # the names of the benches
        effects,  # the catalogue of effects
        rig_parts,  # the parts that a bench is composed of
    )
    from pam_cosim.study.many_runs import sweep  # simulates many runs of a model
    from pam_cosim.study.observing import observe  # estimates signals that are not measured
    from pam_cosim.study.plans import plan  # designs the next experiment
    from pam_cosim.study.predictions import predict  # predicts a run with 95 % bands
    from pam_cosim.study.problems import problem  # resolves every value of a data set and a model
    from pam_cosim.study.products import (
        load,  # reads a saved product
        save,  # saves a product
    )
    from pam_cosim.study.runs import simulate  # simulates one run of a model

__all__ = [
    "add",
    "bench",
    "benches",
    "build",
    "check",
    "compare",
    "couple",
    "describe",
    "diagnose",
    "draw",
    "effects",
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

if not TYPE_CHECKING:
    _NAMES = LazyNames(__file__)
    __doc__ += _NAMES.text()

    def __getattr__(name: str) -> object:
        return _NAMES.load(__name__, name)

    def __dir__() -> list[str]:
        return __all__
