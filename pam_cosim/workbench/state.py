"""What a session stands at: values that never change, so that a step back is the one before."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from pam_cosim.comparison import Comparison
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.fitting import Fit
from pam_cosim.measurement import DataSet
from pam_cosim.problems import ParameterValue
from pam_cosim.workbench.protocol import Json
from pam_cosim.workbench.steps import Step, with_step

AS_STATED = "as stated"


@dataclass(frozen=True)
class State:
    """A study between two steps.

    Attributes:
        data: the measurement, with noise levels and the roles that runs have now.
        model: the base model.
        effects: the added effects, in the order in which they were switched on.
        values: of parameters, where they differ from where they begin, by name [SI].
        fit: the last one, of this model.
        diagnosis: the last one; ``diagnosed``: the effects that the model had then.
        rungs: of the error ladder, the standing model not among them.
        milestone: what the standing model is called on the ladder, as long as nothing is changed; "": it has no place.
        chosen: here, in place of what the data set states; see ``source.MeasurementSource.read``.
        known: every value of the base model, with where it comes from.
        steps: done so far; ``loaded``: how many of them were done when the study was loaded, which stay as they are.
        file: that the model with its effects was written to, by its name in the folder of the study.
        before: the model before the last change of its effects, to be drawn for comparison.
    """

    data: DataSet
    model: str
    effects: tuple[str, ...] = ()
    values: Mapping[str, float] = field(default_factory=dict)
    fit: Fit | None = None
    diagnosis: Diagnosis | None = None
    diagnosed: tuple[str, ...] = ()
    rungs: tuple[Json, ...] = ()
    milestone: str = AS_STATED
    chosen: Json = field(default_factory=dict)
    known: tuple[ParameterValue, ...] = field(default=(), compare=False)
    steps: tuple[Step, ...] = ()
    loaded: int = 0
    file: str | None = None
    before: Comparison | None = None

    def after(self, step: Step, **changes: object) -> State:
        """The state after a step."""
        steps = with_step(self.steps, step, self.loaded)
        return replace(self, steps=steps, **changes)  # type: ignore[arg-type]


def label_of(effects: tuple[str, ...]) -> str:
    """A model in words."""
    return "base model" if not effects else "with " + " + ".join(effects)


def standing_label(state: State) -> str:
    """What the standing model is called on the ladder."""
    return state.milestone or f"{label_of(state.effects)}, by hand"


def with_rung(rungs: tuple[Json, ...], rung: Json) -> tuple[Json, ...]:
    """The ladder with one more rung, which replaces a rung of the same name directly below."""
    rungs_below = rungs[:-1] if rungs and rungs[-1]["label"] == rung["label"] else rungs
    return (*rungs_below, rung)
