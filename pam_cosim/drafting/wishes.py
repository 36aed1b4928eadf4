"""What the user says beforehand, and what the recordings hold in its light."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from pydantic import ValidationError

from pam_cosim.drafting.columns import Found, Source, check_time, find_columns, read_sources
from pam_cosim.errors import InputError
from pam_cosim.measurement.experiment import RecordingTable
from pam_cosim.wording import did_you_mean, shown


@dataclass(frozen=True)
class Wishes:
    """What the user says beforehand, all optional; see ``study.new``."""

    title: str | None = None
    model: str | None = None
    columns: Mapping[str, str] | None = None
    parameters: Mapping[str, str] | None = None
    recording: Mapping[str, object] | None = None
    muscle: str | None = None
    roles: Mapping[str, str] | None = None


@dataclass(frozen=True)
class Known:
    """The recordings as they were read.

    Attributes:
        sources: one for each file.
        columns: of all of them, with what each is.
        time: the one of time; None where an interval is stated.
        recording: as stated.
        asked: names of columns, by the bench's names, as the user says.
        formulas: likewise, of what is no column.
        stated: parameters as texts.
    """

    sources: tuple[Source, ...]
    columns: tuple[Found, ...]
    time: Found | None
    recording: RecordingTable
    asked: dict[str, str]
    formulas: dict[str, str]
    stated: dict[str, str]

    @property
    def files(self) -> list[Path]:
        """Of the user."""
        return [source.file for source in self.sources]


def known(files: Sequence[Path], wishes: Wishes) -> Known:
    """Reads the recordings and says what their columns are.

    Raises:
        InputError: a file that cannot be read, no time, a wish that cannot be met.
    """
    if not files:
        raise InputError("name the recordings, as data/*.csv")
    recording = _recording(wishes.recording or {})
    sources = read_sources(files, recording)
    names = {name for source in sources for name in source.table.columns}
    asked = {n: c for n, c in (wishes.columns or {}).items() if c in names}
    formulas = {n: c for n, c in (wishes.columns or {}).items() if c not in names}
    _check_asked(formulas, names)
    columns = find_columns(sources, asked)
    time = check_time(columns, sources, recording)
    stated = dict(wishes.parameters or {})
    return Known(tuple(sources), tuple(columns), time, recording, asked, formulas, stated)


def _recording(settings: Mapping[str, object]) -> RecordingTable:
    known = [name for name in RecordingTable.model_fields if name != "resample"]
    for name in settings:
        if name not in known:
            raise InputError(f"there is no key {shown(name)} of [recording]; {did_you_mean(name, known)}")
    made = {
        name: int(str(value)) if name.endswith("_line") and str(value).isdecimal() else _listed(name, value)
        for name, value in settings.items()
    }
    try:
        return RecordingTable.model_validate(made)
    except ValidationError as error:
        one = error.errors(include_url=False)[0]
        raise InputError(f"[recording] {one['loc'][0]}: {shown(one['input'])} cannot be used: {one['msg']}") from None


def _listed(name: str, value: object) -> object:
    several = name in ("names", "ignore") and isinstance(value, str)
    return [one.strip() for one in str(value).split(",")] if several else value


def _check_asked(formulas: Mapping[str, str], names: set[str]) -> None:
    """A text that is no column must hold one, or an operator: else it is a misspelt name."""
    for name, text in formulas.items():
        if name == "time" or not re.search(r"[-+*/^('\"]", text):
            raise InputError(f"--column {name}: no file has a column {shown(text)}; {did_you_mean(text, names)}")
