"""What a saved study may hold: its steps and everything beside them, checked by pydantic before any of it is used.

The file may come from somebody else. Names become arguments of scripts and commands, so that each is of a known kind:
unknown keys, steps and methods are errors that name their place.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    FiniteFloat,
    TypeAdapter,
    ValidationError,
    model_validator,
)
from pydantic_core import ErrorDetails

from pam_cosim.fitting import METHODS
from pam_cosim.measurement import StartMode
from pam_cosim.model.references import is_file, is_ratio
from pam_cosim.wording import did_you_mean, shown
from pam_cosim.workbench.paths import is_name_here

LONGEST_NAME = 5000  # letters; quoted names of Modelica may be long
MOST = 10_000  # steps, names or values in one list

_CLASS = re.compile(r"\.?(?:[^\W\d]\w*|'(?:[^'\\]|\\.)+')(?:\.(?:[^\W\d]\w*|'(?:[^'\\]|\\.)+'))*")


def _visible(text: str) -> str:
    hidden = next((c for c in text if not c.isprintable()), None)
    if hidden is not None:
        raise ValueError(f"holds the character {ascii(hidden)}, which cannot be seen")
    return text


def _legible(text: str) -> str:
    hidden = next(
        (c for c in text if not c.isprintable() and unicodedata.category(c) != "Zs"), None
    )
    if hidden is not None:
        raise ValueError(f"holds the character {ascii(hidden)}, which cannot be seen")
    return text


def _class_name(text: str) -> str:
    if not _CLASS.fullmatch(text):
        raise ValueError(f"{shown(text)} is no name of a Modelica class")
    return text


def _bench(text: str) -> str:
    if is_file(text):
        raise ValueError(f"{shown(text)} is a file; a saved study names classes only")
    return _class_name(text)


def _effect(text: str) -> str:
    return text if is_ratio(text) else _class_name(text)


def _method(text: str) -> str:
    if text not in METHODS:
        raise ValueError(
            f"there is no method {shown(text)} to fit with; {did_you_mean(text, METHODS)}"
        )
    return text


def _modelica_file(text: str) -> str:
    if not text.endswith(".mo") or not is_name_here(text):
        raise ValueError(f"{shown(text)} is no name of a Modelica file of the study's folder")
    return text


def _product_file(text: str) -> str:
    if not text.endswith(".npz") or not is_name_here(text):
        raise ValueError(f"{shown(text)} is no name of a product in the study's folder")
    return text


def _number(value: object) -> object:
    """A number that JSON has as an integer of any length."""
    if isinstance(value, bool) or not isinstance(value, int):
        return value
    try:
        return float(value)
    except OverflowError:
        raise ValueError("the number is too large") from None


Number = Annotated[FiniteFloat, BeforeValidator(_number)]
Name = Annotated[str, Field(min_length=1, max_length=LONGEST_NAME), AfterValidator(_visible)]
Text = Annotated[str, Field(max_length=LONGEST_NAME), AfterValidator(_legible)]
Effect = Annotated[Name, AfterValidator(_effect)]
Names = Annotated[list[Name], Field(max_length=MOST)]
Effects = Annotated[list[Effect], Field(max_length=MOST)]
Values = Annotated[dict[Name, Number], Field(max_length=MOST)]
Roles = Annotated[dict[Name, Literal["fit", "holdout"]], Field(max_length=MOST)]
Cuts = Annotated[
    dict[Name, Annotated[list[Number | None], Field(min_length=2, max_length=2)]],
    Field(max_length=MOST),
]
Starts = Annotated[dict[Name, StartMode], Field(max_length=MOST)]


class CheckedTable(BaseModel):
    """A table of known keys, of values that are taken as they are."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


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
    model: Annotated[Name, AfterValidator(_bench)]


class FitStep(CheckedTable):
    """Parameters were fitted, from these values [SI]."""

    do: Literal["fit"]
    method: Annotated[Name, AfterValidator(_method)]
    free: Names
    start: Values


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
    file: Annotated[Name, AfterValidator(_modelica_file)]


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
_STEP: TypeAdapter[Any] = TypeAdapter(Annotated[AnyStep, Field(discriminator="do")])


class SavedLevel(CheckedTable):
    """One signal on a rung of the ladder."""

    rms: Number | None
    noise: Number | None
    chi2: Number | None
    text: Text
    noise_text: Text


class SavedRung(CheckedTable):
    """A rung of the ladder."""

    label: Text
    fit: Annotated[dict[Name, SavedLevel], Field(max_length=MOST)]
    holdout: Annotated[dict[Name, SavedLevel], Field(max_length=MOST)]
    chi2_fit: Number | None
    chi2_holdout: Number | None


class SavedContent(CheckedTable):
    """The whole file, but for what each step holds."""

    format: Literal["pam-cosim workbench 1"]
    model: Name
    effects: Effects
    values: Values
    diagnosed: Effects
    milestone: Text
    file: Annotated[Name, AfterValidator(_modelica_file)] | None
    roles: Roles
    cuts: Cuts = {}
    starts: Starts = {}
    ladder: Annotated[list[SavedRung], Field(max_length=MOST)]
    steps: Annotated[list[Annotated[AnyStep, Field(discriminator="do")]], Field(max_length=MOST)]
    fit: Annotated[Name, AfterValidator(_product_file)] | None
    diagnosis: Annotated[Name, AfterValidator(_product_file)] | None
    time: Number


def checked_content(content: Any, models: Mapping[str, object] | set[str]) -> SavedContent:
    """The content of a saved study; ``models``: files that the person who opens it named.

    Raises:
        ValueError: something in it cannot be; names the place.
    """
    try:
        made = SavedContent.model_validate(content)
    except ValidationError as error:
        raise ValueError(_complaint(error)) from None
    if made.model not in models:
        try:
            _bench(made.model)
        except ValueError as problem:
            raise ValueError(f"model: {problem}") from None
    return made


def checked_step(content: Any) -> dict[str, Any]:
    """A step as plain data, of known keys and kinds alone.

    Raises:
        ValueError: it is none; names the place.
    """
    try:
        made: BaseModel = _STEP.validate_python(content)
    except ValidationError as error:
        raise ValueError(_complaint(error)) from None
    return plain_step(made)


def plain_step(step: BaseModel) -> dict[str, Any]:
    """A step as plain data: what was said of it, and nothing that was not."""
    return step.model_dump(exclude_unset=True)


def _complaint(error: ValidationError) -> str:
    worst = min(error.errors(include_url=False), key=lambda one: one["type"] != "extra_forbidden")
    place = ".".join(part if isinstance(part, str) else str(part + 1) for part in worst["loc"])
    return f"{shown(place)[1:-1]}: {_words(worst)}" if place else _words(worst)


def _words(error: ErrorDetails) -> str:
    match error["type"]:
        case "extra_forbidden":
            return "unknown key"
        case "missing":
            return "is missing"
        case "value_error":
            return str(error["ctx"]["error"])
        case "literal_error" | "union_tag_invalid":
            expected = error["ctx"].get("expected") or error["ctx"].get("expected_tags")
            found = error["ctx"].get("tag", error["input"])
            return f"{shown(found)} is not possible; it is one of {expected}"
    return f"{shown(error['input'])}: {error['msg']}"
