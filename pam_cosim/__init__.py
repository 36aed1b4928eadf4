"""pam-cosim: from a measurement of a pneumatic muscle to the physical effect its model lacks.

```python
import pam_cosim as pam

data = pam.read("my-rig")
print(pam.compare(data))
diagnosis = pam.diagnose(data)
print(diagnosis.verdict)
pam.add(diagnosis.verdict.effects, to=data.model, output="Better.mo")
```
"""

from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError, ModelError, SimulationFailure
from pam_cosim.products import load, save
from pam_cosim.simulation import Inputs, Trajectory
from pam_cosim.study import (
    SweepPoint,
    add,
    benches,
    build,
    compare,
    describe,
    diagnose,
    draw,
    effects,
    fit,
    read,
    simulate,
    sweep,
)

__all__ = [
    "Diagnosis",
    "InputError",
    "Inputs",
    "ModelError",
    "SimulationFailure",
    "SweepPoint",
    "Trajectory",
    "add",
    "benches",
    "build",
    "compare",
    "describe",
    "diagnose",
    "draw",
    "effects",
    "fit",
    "load",
    "read",
    "save",
    "simulate",
    "sweep",
]
