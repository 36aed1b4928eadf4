"""What a session stands at: values that never change, so that a step back is the one before."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from pam_cosim.comparison import Comparison
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.fitting import Fit
from pam_cosim.measurement import DataSet
from pam_cosim.workbench.protocol import Rung
from pam_cosim.workbench.steps import Step


@dataclass(frozen=True)
class State:
    """A study between two steps.

    Attributes:
        data: the measurement, with noise levels and the roles that runs have now.
        model: the base model.
        effects: what it has beside, in the order in which they were switched on.
        values: of parameters, where they differ from where they begin, by name [SI].
        free: names of what a fit moves; None: all that may be.
        fit: the last one, of this model.
        diagnosis: the last one.
        rungs: of the error ladder, the standing model not among them.
        steps: done so far.
        file: that the model with its effects was written to, relative to the folder of the study.
        before: the model before the last change of its effects, to be drawn beside.
    """

    data: DataSet
    model: str
    effects: tuple[str, ...] = ()
    values: Mapping[str, float] = field(default_factory=dict)
    free: tuple[str, ...] | None = None
    fit: Fit | None = None
    diagnosis: Diagnosis | None = None
    rungs: tuple[Rung, ...] = ()
    steps: tuple[Step, ...] = ()
    file: str | None = None
    before: Comparison | None = None
