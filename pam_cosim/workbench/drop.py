"""Recordings that a person drops: what they hold, what is recognised, what is wrong and where; then a data set."""

from __future__ import annotations

import codecs
import shutil
import tempfile
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from pam_cosim import study
from pam_cosim.drafting import NewDataSet, UnsimulatedDraft
from pam_cosim.drafting.values import is_geometry
from pam_cosim.errors import InputError
from pam_cosim.files import write_bytes
from pam_cosim.measurement import any_text
from pam_cosim.measurement.data_set import FILE_NAME
from pam_cosim.measurement.experiment_tables import CheckedTable
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.reporting.account import unit_text
from pam_cosim.units import readable_factor
from pam_cosim.wording import shown
from pam_cosim.workbench.checks import names_of
from pam_cosim.workbench.paths import free_name, inside, safe_name
from pam_cosim.workbench.protocol import Json, event, failure, selected
from pam_cosim.workbench.saved import Name, Text, complaint
from pam_cosim.workbench.state_events import short_name

MOST_BYTES = 200_000_000  # of one file
MOST_TOGETHER = 2_000_000_000
MOST_FILES = 200
_ROWS = 6  # of a file that are shown
_AROUND = 2  # lines above and below one that is wrong
_BYTES = 4_000_000  # of a file, that are looked at
_LONGEST = 400  # characters of a line that are shown
_POINTS = 300  # of a curve that is shown


@dataclass
class Drop:
    """Files that were dropped, and what is known of them; in a folder of its own until they become a data set.

    Args:
        folder: of the data set to be made; missing or empty.
        files: further Modelica files.
    """

    folder: Path
    files: tuple[Path, ...] = ()
    place: Path = field(default_factory=lambda: Path(tempfile.mkdtemp(prefix="pam-cosim-drop-")))
    recordings: list[Path] = field(default_factory=list)
    _names: dict[str, str] = field(default_factory=dict)  # here, by the name that each came with
    _last: Json | None = None  # of which something could be made

    def close(self) -> None:
        """Removes what was dropped."""
        shutil.rmtree(self.place, ignore_errors=True)

    def put(self, name: str, content: bytes | bytearray) -> Json:
        """Takes a file; one that came by the same name is replaced.

        Raises:
            InputError: it is too large, or there are too many; there is no room for it.
        """
        if len(content) > MOST_BYTES:
            raise InputError(f"{shown(name)} is larger than {MOST_BYTES // 1_000_000} MB")
        file_name = self._names.get(name) or free_name(safe_name(name), self._names.values())
        target = inside(self.place, file_name)
        if target not in self.recordings and len(self.recordings) >= MOST_FILES:
            raise InputError(f"more than {MOST_FILES} files at once cannot be taken")
        other_bytes = sum(file.stat().st_size for file in self.recordings if file != target)
        if other_bytes + len(content) > MOST_TOGETHER:
            raise InputError(f"more than {MOST_TOGETHER // 1_000_000} MB together cannot be taken")
        write_bytes(target, content)
        self._names[name] = file_name
        if target not in self.recordings:
            self.recordings = sorted([*self.recordings, target])
        return self.dropped()

    def remove(self, names: Sequence[str]) -> Json:
        """Takes files away again."""
        removed_files = {inside(self.place, name) for name in names_of(names, "remove")}
        for file in removed_files & set(self.recordings):
            file.unlink(missing_ok=True)
        self.recordings = [file for file in self.recordings if file not in removed_files]
        if not self.recordings:
            self._last = None
        remaining_names = {file.name for file in self.recordings}
        self._names = {
            name: file_name
            for name, file_name in self._names.items()
            if file_name in remaining_names
        }
        return self.dropped()

    def dropped(self) -> Json:
        """The files, with their first rows."""
        return event("dropped", files=[_shown(file) for file in self.recordings])

    def draft(self, wishes: Mapping[str, Any]) -> Json:
        """What becomes of the files as they are, with what the person says; nothing is left of it."""
        with tempfile.TemporaryDirectory(prefix="pam-cosim-draft-") as scratch:
            try:
                new_data_set = self._new(Path(scratch) / self.folder.resolve().name, wishes)
            except UnsimulatedDraft as problem:
                self._last = self._drafted(problem.new_data_set, problem.text, problem.interface)
                return self._last | {"failed": failure(problem)}
            except InputError as problem:
                return self.failed(wishes, problem)
            text = (new_data_set.folder / FILE_NAME).read_text(encoding="utf-8")
            interface = study.describe(new_data_set.data.model, self.files)
            self._last = self._drafted(new_data_set, text, interface)
            return self._last

    def failed(self, wishes: Mapping[str, Any], problem: Exception) -> Json:
        """What is wrong, and what can be said of the files though nothing could be made of them: of the bench that is
        requested, or as it was when something could."""
        last = self._last or event(
            "draft",
            title=self.folder.resolve().name,
            model="",
            benches=study.benches(),
            parts=self._parts(),
            **dict.fromkeys(("runs", "names", "parameters", "guesses", "starts", "to_check"), ()),
            **dict.fromkeys(("columns", "stated"), {}),
        )
        wrong = {"failed": failure(problem), "excerpt": self._excerpt(problem)}
        fields = last | {"curves": (), "toml": ""} | wrong
        bench = str(wishes.get("model"))
        if bench in last["benches"] and bench != short_name(last["model"]):
            fields |= {"model": bench, **_quantities(study.describe(bench))}
        return fields

    def _parts(self) -> list[Json]:
        """What a bench can be put together from."""
        return [selected(part, "role name description") for part in study.rig_parts(self.files)]

    def create(self, wishes: Mapping[str, Any]) -> None:
        """Writes the data set.

        Raises:
            InputError: whatever cannot be used; nothing is written then.
        """
        self._new(self.folder, wishes)

    def _new(self, folder: Path, wishes: Mapping[str, Any]) -> NewDataSet:
        if not self.recordings:
            raise InputError("drop at least one recording")
        return study.new(folder, self.recordings, files=self.files, **_checked(wishes))

    def _excerpt(self, problem: Exception) -> Json | None:
        """The place in a file that is wrong."""
        line, file = getattr(problem, "line", None), getattr(problem, "file", None)
        place = inside(self.place, Path(str(file)).name) if file else None
        if place not in self.recordings or line is None:
            return None
        lines = _lines(place)
        first = max(line - _AROUND, 1)
        shown_lines = [text[:_LONGEST] for text in lines[first - 1 : line + _AROUND]]
        return {"first": first, "line": line, "header": lines[:1], "lines": shown_lines}

    def _drafted(self, new_data_set: NewDataSet, text: str, interface: Interface) -> Json:
        written = tomllib.loads(text)
        run_parameters = [run.get("parameters", {}) for run in written["runs"]]
        return event(
            "draft",
            failed=None,
            excerpt=None,
            title=new_data_set.data.title,
            **selected(new_data_set, "model starts to_check"),
            guesses=[selected(guess, "what taken_as why") for guess in new_data_set.guesses],
            runs=[
                selected(run, "name role describe", own=stated)
                for run, stated in zip(new_data_set.data.runs, run_parameters, strict=True)
            ],
            **_quantities(interface),
            benches=study.benches(),
            parts=self._parts(),
            columns=written.get("columns", {}),
            stated=written.get("parameters", {}),
            toml=text,
            curves=_curves(new_data_set),
        )


class Wishes(CheckedTable):
    """What a page may say, by the options of ``study.new``."""

    title: Text = ""
    model: Text = ""
    muscle: Text = ""
    valve: Text = ""
    columns: dict[Name, Text] = {}
    parameters: dict[Name, Text] = {}
    recording: dict[Name, Text] = {}
    roles: dict[Name, Text] = {}


def _checked(wishes: Mapping[str, Any]) -> Json:
    try:
        answers = Wishes.model_validate(dict(wishes))
    except ValidationError as error:
        raise InputError(complaint(error)) from None
    if any(c in answers.model for c in "/\\"):
        raise InputError(
            "a bench is named, or a Modelica class; files are given where the workbench is started"
        )
    return answers.model_dump(exclude_defaults=True)


def _quantities(interface: Interface) -> Json:
    """What a column can be taken for, and what can be stated, of a bench."""
    quantities = {**interface.inputs, **interface.outputs}.values()
    return {
        "names": [_quantity(v, input=v.name in interface.inputs) for v in quantities],
        "parameters": [
            _quantity(v, geometry=is_geometry(v), **selected(v, "value=start", v.unit))
            for v in interface.parameters.values()
        ],
    }


def _quantity(variable: Variable, **fields: object) -> Json:
    return selected(variable, "name description", unit=unit_text(variable.unit), **fields)


def _curves(new_data_set: NewDataSet) -> list[Json]:
    """Signals of the runs, as they are read, few points each."""
    signals, curves = new_data_set.data.signals, list[Json]()
    for run in new_data_set.data.runs:
        drawn_rows = np.unique(
            np.linspace(0, len(run.time) - 1, min(len(run.time), _POINTS)).astype(int)
        )
        for name, values in run.measurements.items():
            shown_values = values[drawn_rows] * readable_factor(signals[name].unit)
            curve = {"signal": name, "time": run.time[drawn_rows], "values": shown_values}
            curves.append(curve | {"unit": unit_text(signals[name].unit)})
    return curves


def _shown(file: Path) -> Json:
    """A file with its first lines, where it is a text."""
    text = file.suffix.casefold() in (".csv", ".txt", ".dat", ".tsv", ".asc", "")
    lines = [line[:_LONGEST] for line in _lines(file)[: 1 + _ROWS]] if text else []
    return {"name": file.name, "bytes": file.stat().st_size, "lines": lines}


def _lines(file: Path) -> list[str]:
    with file.open("rb") as stream:
        head = stream.read(_BYTES)
    if len(head) == _BYTES:
        head = head[
            : head.rfind(b"\n")
        ]  # no letter is cut; of two bytes each where they have as many
        head = head[
            : len(head)
            - len(head) % 2 * head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
        ]
    try:
        text, _ = any_text(head, file)
    except InputError:  # the page shows the rest; the reader of the file reports the error
        text = head.decode("utf-8", errors="replace")
    return text.splitlines()
