"""What a saved study may hold: its steps and everything beside them, checked by pydantic before any of it is used.

The file may come from somebody else. Names become arguments of scripts and commands, so that each is of a known kind:
unknown keys, steps and methods are errors that name their place.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    Field,
    TypeAdapter,
    ValidationError,
)
from pydantic_core import ErrorDetails

from pam_cosim.measurement.experiment_tables import CheckedTable
from pam_cosim.wording import shown
from pam_cosim.workbench.saved_steps import AnyStep
from pam_cosim.workbench.saved_values import (
    MOST,
    Cuts,
    Effects,
    Name,
    Number,
    Roles,
    Starts,
    Text,
    Values,
    checked_bench,
    checked_modelica_file,
    checked_product_file,
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
    file: Annotated[Name, AfterValidator(checked_modelica_file)] | None
    roles: Roles
    cuts: Cuts = {}
    starts: Starts = {}
    ladder: Annotated[list[SavedRung], Field(max_length=MOST)]
    steps: Annotated[list[Annotated[AnyStep, Field(discriminator="do")]], Field(max_length=MOST)]
    fit: Annotated[Name, AfterValidator(checked_product_file)] | None
    diagnosis: Annotated[Name, AfterValidator(checked_product_file)] | None
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
            checked_bench(made.model)
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
