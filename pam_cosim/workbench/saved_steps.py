"""The steps of a saved study, each with what it must hold."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, model_validator

from pam_cosim.measurement.experiment_tables import CheckedTable
from pam_cosim.wording import shown
from pam_cosim.workbench.saved_values import (
    Cuts,
    Effects,
    Name,
    Names,
    Number,
    Roles,
    Starts,
    Values,
    checked_bench,
    checked_method,
    checked_modelica_file,
)


class SetStep(CheckedTable):
    """Values were set by hand [SI]."""

    do: Literal["set"]
    values: Values


class SwitchStep(CheckedTable):
    """The model was given just these effects; ``values`` were kept [SI]."""

    do: Literal["switch"]
    effects: Effects
    values: Values


class ChooseStep(CheckedTable):
    """Another base model was taken."""

    do: Literal["choose"]
    model: Annotated[Name, AfterValidator(checked_bench)]


class FitStep(CheckedTable):
    """Parameters were fitted, from these values [SI]; ``kept``: beside those that it began with, where others had been
    moved while it was stopped."""

    do: Literal["fit"]
    method: Annotated[Name, AfterValidator(checked_method)]
    free: Names
    start: Values
    kept: Values = {}


class DiagnoseStep(CheckedTable):
    """The missing effect was looked for."""

    do: Literal["diagnose"]
    time_limit: Number | Name | None = None
    exclude: Names = []
    expect: Names = []
    free: Names = []
    start: Values = {}


class TakeStep(CheckedTable):
    """A model of the ranking was taken: its values, and those that were kept [SI]."""

    do: Literal["take"]
    effects: Effects
    values: Values
    kept: Values


class AddStep(CheckedTable):
    """The model with effects was written, with these values [SI]."""

    do: Literal["add"]
    effects: Effects
    values: Values = {}
    file: Annotated[Name, AfterValidator(checked_modelica_file)]


class RolesStep(CheckedTable):
    """Runs were fitted or held out."""

    do: Literal["roles"]
    roles: Roles


class CutStep(CheckedTable):
    """A run was cut; how all runs are cut and begin since then, and the values that were kept [SI]."""

    do: Literal["cut"]
    run: Name
    cuts: Cuts
    starts: Starts
    values: Values

    @model_validator(mode="after")
    def _is_of_its_run(self) -> CutStep:
        if self.run not in self.cuts:
            raise ValueError(f"cuts lacks {shown(self.run)}")
        return self


class BeginStep(CheckedTable):
    """How a run begins was chosen; how all runs begin since then, and the values that were kept [SI]."""

    do: Literal["begin"]
    run: Name
    starts: Starts
    values: Values


class StartStep(CheckedTable):
    """Start values were set by hand [SI]; ``moved``: these, and the others of their runs stayed where they were."""

    do: Literal["start"]
    values: Values
    moved: Names

    @model_validator(mode="after")
    def _moves_its_values(self) -> StartStep:
        stray = next((name for name in self.moved if name not in self.values), None)
        if stray is not None:
            raise ValueError(f"values lacks {shown(stray)}")
        return self


AnyStep = (
    SetStep
    | SwitchStep
    | ChooseStep
    | FitStep
    | DiagnoseStep
    | TakeStep
    | AddStep
    | RolesStep
    | CutStep
    | BeginStep
    | StartStep
)
