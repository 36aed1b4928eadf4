"""Reads ``experiment.toml`` as checked tables, each with its place.

Units, names and bounds are checked afterwards, against the bench (see ``read``).
"""

from __future__ import annotations

from pathlib import Path

from pydantic import ValidationError

from pam_cosim.errors import InputError
from pam_cosim.measurement.data_set import FILE_NAME
from pam_cosim.measurement.experiment_errors import complaint_of
from pam_cosim.measurement.experiment_tables import Experiment, located
from pam_cosim.measurement.place import Place
from pam_cosim.measurement.text_file import read_text
from pam_cosim.toml_text import line_of, parse_toml


def error_in(folder: Path, message: str, *keys: str | int) -> InputError:
    """An error about a key of the data set in a folder, with its line where the file is still there."""
    file = folder / FILE_NAME
    return Place(file, read_text(file) if file.is_file() else "", keys).error(message)


def read_experiment(file: Path) -> Experiment:
    """Reads the file and checks its structure.

    Raises:
        InputError: not readable, not TOML, an unknown or missing key, a value of the wrong kind.
    """
    text = read_text(file)
    data = parse_toml(text, file)
    try:
        experiment: Experiment = located(Experiment.model_validate(data), Place(file, text))
    except ValidationError as error:
        # An unknown key first: a misspelt key is also a missing one.
        worst = min(error.errors(include_url=False), key=lambda e: e["type"] != "extra_forbidden")
        path, message = complaint_of(worst)
        raise InputError(message, file, line_of(text, path)) from None
    return experiment
