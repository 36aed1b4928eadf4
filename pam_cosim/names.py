"""What a model's name says of it: a bench, a Modelica class, or a file by its ending in any case."""

from __future__ import annotations


def is_fmu(model: str) -> bool:
    """Whether it is an FMU's file."""
    return model.lower().endswith(".fmu")


def is_modelica(model: str) -> bool:
    """Whether it is a Modelica file."""
    return model.lower().endswith(".mo")


def is_file(model: str) -> bool:
    """Whether it is a file, and not a name in a library."""
    return is_fmu(model) or is_modelica(model)
