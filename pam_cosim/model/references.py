"""What a name refers to: a bench, a class or a file; a parameter or a ratio."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from pam_cosim.errors import InputError


def model_name(model: object) -> str:
    """The text by which a model is named; a file may be a path.

    Raises:
        InputError: it is neither.
    """
    if isinstance(model, str | Path):
        return str(model)
    raise InputError(f"a model is named by a text or a path, not by a {type(model).__name__}")


def is_fmu(model: str) -> bool:
    """Whether it is an FMU's file."""
    return model.lower().endswith(".fmu")


def is_modelica(model: str) -> bool:
    """Whether it is a Modelica file."""
    return model.lower().endswith(".mo")


def is_file(model: str) -> bool:
    """Whether it is a file, and not a name in a library."""
    return is_fmu(model) or is_modelica(model)


def sources_of(files: Sequence[Path], *models: str) -> tuple[Path, ...]:
    """The Modelica files that models need, each once: further ones, and those by which a model is named."""
    return tuple(dict.fromkeys([*files, *(Path(model) for model in models if is_modelica(model))]))


BRANCH = "branch"
"""The input of a bench that is the direction in which points at rest were reached: 1, -1, or 0."""

START_VALUES = "start values"
"""Stands for the start values of all states, where the parameters are named by which a model differentiates."""

_STATED = "/stated"


def ratio_to_stated(parameter: str) -> str:
    """The name of what a parameter is in truth over what is stated of it."""
    return parameter + _STATED


def is_ratio(name: str) -> bool:
    """Whether a name is that of such a ratio."""
    return name.endswith(_STATED)


def parameter_of(name: str) -> str:
    """The model's parameter that a ratio is of, and of other names the name itself."""
    return name.removesuffix(_STATED)
