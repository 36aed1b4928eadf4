"""pam-cosim: from a measurement to the physical effect that its model lacks.

```python
import pam_cosim as pam

data = pam.read("my-rig")
print(pam.compare(data))
diagnosis = pam.diagnose(data)
print(diagnosis.verdict)
pam.add(diagnosis.verdict.effects, to=data.model, output="Better.mo")
```
"""

import warnings
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pam_cosim.analysis import (
        FrequencyResponse,
        LinearCourse,
        LinearModel,
        Observation,
        OperatingPoint,
    )
    from pam_cosim.cosimulation import Controller, CoupledRun, Rig, System, controller
    from pam_cosim.diagnosis import Check, Diagnosis
    from pam_cosim.errors import InputError, ModelError, SimulationFailure
    from pam_cosim.problems import Problem
    from pam_cosim.simulation import Inputs, Trajectory
    from pam_cosim.study import (
        add,
        bench,
        benches,
        build,
        build_with_data,
        check,
        compare,
        couple,
        describe,
        diagnose,
        draw,
        effects,
        evidence,
        fit,
        frequency_response,
        linearise,
        linearise_along,
        live,
        load,
        new,
        observe,
        plan,
        predict,
        problem,
        profile,
        read,
        read_system,
        rig_parts,
        save,
        simulate,
        start,
        sweep,
        write_system,
    )
    from pam_cosim.sweeps import Sweep, SweepPoint

__all__ = [
    "Check",
    "Controller",
    "CoupledRun",
    "Diagnosis",
    "FrequencyResponse",
    "InputError",
    "Inputs",
    "LinearCourse",
    "LinearModel",
    "ModelError",
    "Observation",
    "OperatingPoint",
    "Problem",
    "Rig",
    "SimulationFailure",
    "Sweep",
    "SweepPoint",
    "System",
    "Trajectory",
    "add",
    "bench",
    "benches",
    "build",
    "build_with_data",
    "check",
    "compare",
    "controller",
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

# Where a name is looked for; the functions of a study load what they need when they are asked for.
_ROOMS = (
    "study",
    "errors",
    "simulation",
    "sweeps",
    "analysis",
    "cosimulation",
    "problem",
    "diagnosis",
)

if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        """Loads what is asked for first: the command can be interrupted while it loads (``cli.process``)."""
        if name in __all__:
            for room in _ROOMS:
                module = import_module(f"pam_cosim.{room}")
                if hasattr(module, name):
                    return getattr(module, name)
        renaming = import_module("pam_cosim.renamed").PYTHON.get(name)
        if renaming is not None:
            warnings.warn(renaming.message(f"pam_cosim.{name}"), DeprecationWarning, stacklevel=2)
            return __getattr__(renaming.new)
        raise AttributeError(f"module 'pam_cosim' has no attribute '{name}'")
