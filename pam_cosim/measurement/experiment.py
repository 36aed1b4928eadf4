"""The structure of ``experiment.toml``: which tables and keys there are; checked by pydantic.

Units, names and bounds are checked afterwards, against the bench (see ``read``).
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from pydantic import ValidationError

from pam_cosim.errors import InputError
from pam_cosim.measurement.experiment_errors import complaint_of
from pam_cosim.measurement.experiment_tables import (
    Experiment,
)
from pam_cosim.measurement.text_file import read_text
from pam_cosim.toml_text import line_of, parse_toml

FILE_NAME = "experiment.toml"


@dataclass(frozen=True)
class ExperimentFile:
    """``experiment.toml`` as read, with its text, so that a later complaint can name the line."""

    file: Path
    text: str
    content: Experiment

    @cached_property
    def run_names(self) -> tuple[str, ...]:
        """The name of each table of ``[[runs]]``: the path of its file without the suffix, and which part of it."""
        files = [Path(run.file) for run in self.content.runs]
        listed, seen = Counter(files), Counter[Path]()
        names = []
        for file in files:
            seen[file] += 1
            part = f" part {seen[file]}" if listed[file] > 1 else ""
            names.append(f"{file.with_suffix('').as_posix()}{part}")
        return tuple(names)

    def is_part(self, index: int) -> bool:
        """Whether a run is one of several of its file."""
        return (
            self.run_names[index] != Path(self.content.runs[index].file).with_suffix("").as_posix()
        )

    def error(self, message: str, *path: str | int) -> InputError:
        """An error about the key at ``path``, with its line."""
        return InputError(message, self.file, line_of(self.text, path))


def error_in(folder: Path, message: str, *path: str | int) -> InputError:
    """An error about a key of the data set in a folder, with its line where the file is still there."""
    file = folder / FILE_NAME
    return (
        InputError(message, file, line_of(read_text(file), path))
        if file.is_file()
        else InputError(message, file)
    )


def read_experiment(file: Path) -> ExperimentFile:
    """Reads the file and checks its structure.

    Raises:
        InputError: not readable, not TOML, an unknown or missing key, a value of the wrong kind.
    """
    text = read_text(file)
    data = parse_toml(text, file)
    try:
        return ExperimentFile(file, text, Experiment.model_validate(data))
    except ValidationError as error:
        # An unknown key first: a misspelt key is also a missing one.
        worst = min(
            error.errors(include_url=False), key=lambda one: one["type"] != "extra_forbidden"
        )
        path, message = complaint_of(worst)
        raise InputError(message, file, line_of(text, path)) from None
