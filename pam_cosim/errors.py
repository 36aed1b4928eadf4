"""Errors that a person can act on."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from pam_cosim.wording import printable


@dataclass
class InputError(Exception):
    """Something the user wrote cannot be used. The command line prints it and exits with status 2.

    Attributes:
        message: what is wrong and what to do, one sentence or two.
        file: the file at fault.
        line: its line, counted from 1.
        column: the column: a name in a CSV file, a number (from 1) in other text.
    """

    message: str
    file: Path | str | None = None
    line: int | None = None
    column: int | str | None = None

    def __str__(self) -> str:
        place = "" if self.file is None else str(self.file)
        if self.line is not None:
            place += f":{self.line}"
        if isinstance(self.column, int):
            place += f":{self.column}"
        elif self.column:
            place += f": column '{self.column}'"
        return printable(f"{place}: {self.message}" if place else self.message)

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        return type(self), (self.message, self.file, self.line, self.column)


class ModelError(InputError):
    """A Modelica model cannot be compiled; the message names the class or variables at fault."""


class ModelChange(InputError):
    """A Modelica file was changed while models were made of it: what was made before and after does not compare."""


class SimulationFailure(RuntimeError):
    """A run did not reach its end: the solver gave up or the FMU reported an error."""
