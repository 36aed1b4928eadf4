"""What a value in a saved study may be: names, numbers and files that steer nothing."""

from __future__ import annotations

import re
import unicodedata
from typing import Annotated, Literal

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Field,
    FiniteFloat,
)

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


def checked_bench(text: str) -> str:
    """The name of a class."""
    if is_file(text):
        raise ValueError(f"{shown(text)} is a file; a saved study names classes only")
    return _class_name(text)


def _effect(text: str) -> str:
    return text if is_ratio(text) else _class_name(text)


def checked_method(text: str) -> str:
    """The name of a method to fit with."""
    if text not in METHODS:
        raise ValueError(
            f"there is no method {shown(text)} to fit with; {did_you_mean(text, METHODS)}"
        )
    return text


def checked_modelica_file(text: str) -> str:
    """The name of a Modelica file of the study's folder."""
    if not text.endswith(".mo") or not is_name_here(text):
        raise ValueError(f"{shown(text)} is no name of a Modelica file of the study's folder")
    return text


def checked_product_file(text: str) -> str:
    """The name of a product in the study's folder."""
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
