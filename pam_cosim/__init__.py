"""pam-cosim: from a measurement to the physical effect that its model lacks.

```python
import pam_cosim as pam

data = pam.read("my-rig")
print(pam.compare(data))
diagnosis = pam.diagnose(data)
print(diagnosis.verdict)
pam.add(diagnosis, output="Better.mo")
```
"""

# ruff: noqa: F401
from typing import TYPE_CHECKING

from pam_cosim import study as _study
from pam_cosim.lazy_names import LazyNames

if TYPE_CHECKING:
    from pam_cosim.analysis import (
        FrequencyResponse,  # of frequency_response: amplitude and phase by frequency
        LinearModel,  # of linearise: the matrices A, B, C and D
        LinearModels,  # of linearise_along: linear models along a run
        Observation,  # of observe: estimated states over time
        OperatingPoint,  # about which a model was linearised
    )
    from pam_cosim.cosimulation import (
        Controller,  # a Python function as a component of a system
        CoupledRun,  # the run of a system
        Rig,  # of start: a model in the middle of a run
        System,  # of couple: components and their connections
        controller,  # makes a Controller of a function
    )
    from pam_cosim.diagnosis import (
        Check,  # of check: what a data set can determine
        Diagnosis,  # of diagnose: the verdict, the candidates and their fits
    )
    from pam_cosim.errors import (
        InputError,  # an input that cannot be used, with its place
        ModelError,  # a Modelica model that cannot be compiled
        SimulationFailure,  # a run that did not reach its end
    )
    from pam_cosim.problems import (
        Problem,  # of problem: data set, model, and every value with its source
    )
    from pam_cosim.simulation import (
        Inputs,  # inputs over time
        Trajectory,  # of simulate: signals over time
    )
    from pam_cosim.study import (
        add,
        bench,
        benches,
        build,
        check,
        compare,
        couple,
        describe,
        diagnose,
        draw,
        effects,
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
    from pam_cosim.sweeps import (
        Sweep,  # of sweep: a sequence of runs
        SweepPoint,  # one run of a sweep
    )

__all__ = [
    "Check",
    "Controller",
    "CoupledRun",
    "Diagnosis",
    "FrequencyResponse",
    "InputError",
    "Inputs",
    "LinearModels",
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
    "controller",
]
__all__ += _study.__all__

if not TYPE_CHECKING:
    _NAMES = LazyNames(__file__)
    __doc__ += f"\nThe steps of a study:\n{_study._NAMES.text()}\n\nWhat they take and return:\n{_NAMES.text()}"

    def __getattr__(name: str) -> object:
        """Loads names on first use: the command can be interrupted while it loads (``cli.process``)."""
        return (_study._NAMES if name in _study.__all__ else _NAMES).load(__name__, name)

    def __dir__() -> list[str]:
        return __all__
