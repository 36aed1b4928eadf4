"""A new data set from recordings: what is recognised becomes ``experiment.toml`` and is read as any other."""

from __future__ import annotations

import csv
import os
import shutil
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.catalogue import vocabulary_of
from pam_cosim.compiler import ClassTree
from pam_cosim.drafting.benches import Bench, class_name, stated_interface, take_bench
from pam_cosim.drafting.data_sheets import opening_unit, ratings
from pam_cosim.drafting.document import Draft, document
from pam_cosim.drafting.entries import Mapped, map_columns, with_directions
from pam_cosim.drafting.evidence import DraftRequests, gather
from pam_cosim.drafting.headings import MECHANICAL, Headings
from pam_cosim.drafting.questions import (
    NewDataSet,
    below_zero,
    guesses,
    losses,
    next_commands,
    questions,
)
from pam_cosim.drafting.recordings import Source
from pam_cosim.drafting.roles import (
    Role,
    check_imposed,
    interpolation_of,
    points_draft,
    roles,
    sigma_of,
    stated_roles,
)
from pam_cosim.drafting.values import (
    StatedValue,
    check_stated,
    following,
    neutral,
    open_parameters,
    values_of_runs,
    with_full_names,
    with_length,
    with_rated,
)
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.files import is_vacant
from pam_cosim.measurement import DataSet, read_data_set
from pam_cosim.measurement.data_set import FILE_NAME
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_file
from pam_cosim.units import format_quantity
from pam_cosim.wording import listed

_NOT_IN_NAMES = frozenset('\\/:*?"<>|@')


def draft(
    folder: Path,
    files: Sequence[Path],
    requests: DraftRequests,
    tree: ClassTree,
    describe: Callable[[str], Interface],
    simulate: Callable[[DataSet], object],
    extra: Sequence[Path] = (),
) -> NewDataSet:
    """Drafts the data set, simulates its first run, and puts it in place.

    Args:
        folder: missing or empty.
        files: one recording each; they are copied.
        requests: what the user states.
        tree: the library and the user's files.
        describe: gives the interface of a model.
        simulate: simulates the runs of a data set.
        extra: further Modelica files that the model needs; only named in what to type next.

    Raises:
        InputError: whatever cannot be used, with file, line and column; a model that cannot be simulated with what was
            recorded. Nothing is written then.
    """
    folder = _without_detour(folder)
    _check_place(folder)
    if not files:
        raise InputError("name the recordings, as data/*.csv")
    for file, others in ((file, files[:i]) for i, file in enumerate(files)):
        if file.resolve() in {other.resolve() for other in others}:
            raise InputError("the file is named twice", file)  # its samples would count twice
    with _temporary_sibling(folder) as place:
        model = requests.model
        if model is not None and is_file(model):
            model = str(place / _copies([Path(model)], place)[0])
        interface = stated_interface(model, tree, describe)
        opening = opening_unit(requests.valve or "")
        headings = Headings(vocabulary_of(tree, model if interface else None), opening)
        names = {*interface.inputs, *interface.outputs} if interface else set[str]()
        evidence = gather(files, requests, headings, names)
        if evidence.points:
            evidence = replace(evidence, columns=tuple(with_directions(evidence.columns, headings)))
        requests = replace(requests, model=model)
        bench = take_bench(place, class_name(folder), requests, interface, evidence, tree, describe)
        bench = with_length(with_full_names(bench))
        recordings = list(dict.fromkeys(evidence.files))
        copy_of = dict(zip(recordings, _copies(recordings, place), strict=True))
        copy_of |= {
            s.file: _anew(s, copy_of[s.file], place) for s in evidence.sources if s.is_merged
        }
        check_stated(bench)
        drafted = _draft(requests, folder, bench, [copy_of[file] for file in evidence.files])
        text = document(drafted)
        (place / FILE_NAME).write_text(text, encoding="utf-8", newline="\n")
        data = _read(place, {copy: file for file, copy in copy_of.items()}, describe)
        report = guesses(drafted), (*losses(data), *questions(drafted))
        commands = next_commands(folder, extra, bench.name)
        new_data_set = NewDataSet(folder, data, bench.name, *report, commands)
        try:
            _simulated(data, drafted, simulate)
        except InputError as problem:
            raise UnsimulatedDraft(problem, new_data_set, text, bench.interface) from None
        _put(place, folder)
    return new_data_set


class UnsimulatedDraft(InputError):
    """A draft whose first run cannot be simulated; nothing of it is written.

    Attributes:
        new_data_set: the draft.
        text: of its ``experiment.toml``.
        interface: of its bench.
    """

    def __init__(
        self, problem: InputError, new_data_set: NewDataSet, text: str, interface: Interface
    ) -> None:
        super().__init__(problem.message, problem.file, problem.line, problem.column)
        self.new_data_set, self.text, self.interface = new_data_set, text, interface

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        problem = InputError(self.message, self.file, self.line, self.column)
        return type(self), (problem, self.new_data_set, self.text, self.interface)


def _draft(requests: DraftRequests, folder: Path, bench: Bench, copies: Sequence[str]) -> Draft:
    """The content of ``experiment.toml``."""
    interface, evidence = bench.interface, bench.evidence
    valves, areas = ratings(requests.valve or "", bench)
    values = {name: f"{area:.6g}" for name, area in areas.items()}
    plain = "the muscle is not named: its fibres have no friction and cover nothing, unless an effect is added"
    follows: dict[str, tuple[str, str]] = {}
    for found, why in (
        (following(bench), "zero, for it follows from the measures that are stated"),
        (neutral(bench), plain),
        (values, f"the data sheet of the valves: {requests.valve}"),
    ):
        follows |= {name: (value, why) for name, value in found.items()}
    if evidence.points:
        check_imposed(bench)
    mapped = map_columns(bench, valves)
    values_by_run = values_of_runs(bench, mapped)
    guessed = _guessed_roles(bench, mapped, values_by_run)
    by_run = any(role.role == "holdout" for role in guessed) or bool(requests.roles)
    measured = {*bench.choice.outputs, *evidence.formulas}
    outputs = {n: bench.meanings[n].kind for n in interface.outputs if n in measured}
    return Draft(
        title=requests.title or folder.resolve().name,
        bench=bench,
        mapped=mapped,
        files=copies,
        ignored=_ignored(bench),
        sigmas={name: sigma_of(name, bench, mapped.runs) for name in outputs},
        follows=follows,
        run_values=values_by_run,
        open=with_rated(open_parameters(bench, "temperature" in outputs.values()), areas),
        roles=stated_roles(guessed, evidence.sources, requests.roles or {}),
        interpolation=interpolation_of(bench),
        points=points_draft(mapped.runs, bench, by_run) if evidence.points else None,
        valve=requests.valve or "",
        rated=areas,
    )


def _guessed_roles(
    bench: Bench, mapped: Mapped, values_by_run: Sequence[Mapping[str, StatedValue]]
) -> list[Role]:
    """Which recordings are held out; none, where the length or load of a recording is unknown."""
    evidence = bench.evidence
    for name in bench.choice.unfed:
        is_stated = all(name in {**evidence.stated, **run} for run in evidence.run_parameters)
        if bench.meanings[name].kind in MECHANICAL and not is_stated:
            return [Role("fit") for _ in mapped.runs]
    traits = [{n: value.number for n, value in run.items()} for run in values_by_run]
    return roles(mapped.runs, bench.interface, traits)


_IGNORED_KINDS = {
    "count": "a count of rows or cycles",
    "direction": "a direction, which follows from the time series",
    "voltage": "a voltage; a formula can scale it",
    "angle": "an angle; a formula can scale it",
}


def _ignored(bench: Bench) -> dict[str, str]:
    """Columns that are not read, and why."""
    evidence = bench.evidence
    names = {column.meaning: name for name, column in bench.choice.fed.items()}
    reasons: dict[str, str] = {}
    if not any(source.is_merged for source in evidence.sources):
        reasons = dict.fromkeys(evidence.recording.ignore or (), "as you state")
        for source in evidence.sources:
            reasons |= dict.fromkeys(source.texts, "a column of text")
    for column in (c for c in evidence.columns if c.name not in bench.used):
        meaning = column.meaning
        around = column.kind == "mass" or not meaning.roles.isdisjoint(("ambient", "rest"))
        what = "a parameter" if around else "neither an input nor an output of this bench"
        why = _IGNORED_KINDS.get(column.kind, f"{meaning}, {what}")
        if not meaning:
            why = "; ".join(column.why) or "it is not recognised"
        elif meaning in names and column.kind not in _IGNORED_KINDS:
            name = names[meaning]
            why = f"it may be {name} instead; --column {name}='{column.name}' selects it"
        reasons[column.name] = why
    return reasons


def _simulated(data: DataSet, drafted: Draft, simulate: Callable[[DataSet], object]) -> None:
    """Simulates the first run.

    Raises:
        InputError: it cannot be simulated, with what is likely wrong and what to type.
    """
    try:
        simulate(replace(data, runs=data.runs[:1]))
    except SimulationFailure as failure:
        for name, least, say in below_zero(drafted):
            begins = f"{name} begins at {format_quantity(least, 'm')}, outside the muscle: which reading is zero?"
            raise InputError(f"{begins} State it, as in {say}") from None
        unknown = [*drafted.unfed, *(n for n in drafted.open.to_state if not drafted.is_known(n))]
        hint = (
            f"state what the rig has, --parameter NAME=VALUE, of {listed(unknown)}; or --model NAME"
        )
        fed = listed(f"{n} = {column.name}" for n, column in drafted.bench.choice.fed.items())
        message = (
            f"{drafted.bench.choice.ports.name} ({fed}) cannot be simulated with what was recorded"
        )
        raise InputError(f"{message}: {failure}; {hint}") from None


# ---- the place of a new data set: drafted in a sibling folder, and moved there as a whole or not at all -------------


def _without_detour(folder: Path) -> Path:
    """The same place, not named by way of folders that are not there: they would have to be made for it."""
    if ".." in folder.parts and not folder.parent.exists():
        return Path(os.path.realpath(folder))
    return folder


def _check_place(folder: Path) -> None:
    """Raises InputError where there is something already, or nothing can be made."""
    if is_vacant(folder) and not folder.is_symlink():
        return
    what = "this is no folder"
    if folder.is_dir() and not folder.is_symlink():
        what = "the folder is not empty, and nothing is overwritten"
    raise InputError(f"{what}; name a new one for the data set", folder)


@contextmanager
def _temporary_sibling(folder: Path) -> Iterator[Path]:
    """A new folder on the disk of the data set's place, removed at the end.

    Raises:
        InputError: nothing can be written there.
    """
    parent = folder.absolute().parent
    while not parent.exists() and parent != parent.parent:
        parent = parent.parent
    try:
        temporary = tempfile.TemporaryDirectory(
            dir=parent, prefix=".new-", ignore_cleanup_errors=True
        )
    except OSError as error:
        raise InputError(f"the data set cannot be written: {error.strerror}", folder) from None
    with temporary as name:
        place = Path(name) / "set"
        place.mkdir()
        yield place


def _copies(files: Sequence[Path], place: Path) -> list[str]:
    """Copies under their own names; where two are called alike, with a number."""
    copies, taken = [], {Path(FILE_NAME).stem}
    for file in files:
        letters = [c if c.isprintable() and c not in _NOT_IN_NAMES else "_" for c in file.stem]
        stem = "".join(letters) or "run"
        name, number = stem, 2
        while name.casefold() in taken or (place / f"{name}{file.suffix}").exists():
            name, number = f"{stem}-{number}", number + 1
        taken.add(name.casefold())
        try:
            shutil.copyfile(file, place / f"{name}{file.suffix}")
        except OSError as error:
            raise InputError(f"the file cannot be copied: {error.strerror}", file) from None
        copies.append(f"{name}{file.suffix}")
    return copies


def _anew(source: Source, copy: str, place: Path) -> str:
    """The name of a text with the rows of a recording, in place of the copy of its file."""
    (place / copy).unlink()
    columns = source.table.columns.values()
    heads = (c.name + (f" [{c.unit}]" if c.unit else "") for c in columns)
    rows = [[f"{v:.12g}" if np.isfinite(v) else "" for v in c.values] for c in columns]
    name = str(Path(copy).with_suffix(".csv"))
    with (place / name).open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([list(heads), *zip(*rows, strict=True)])
    return name


def _read(place: Path, origin: Mapping[str, Path], describe: Callable[[str], Interface]) -> DataSet:
    """The data set as it reads; an error names the file that the user gave."""
    try:
        return read_data_set(place, describe)
    except InputError as error:
        file = Path(str(error.file)) if error.file is not None else None
        if file is not None and file.name in origin:
            raise type(error)(error.message, origin[file.name], error.line, error.column) from None
        raise type(error)(
            error.message
        ) from None  # Of a statement of the user, or of a draft that was removed.


def _put(place: Path, folder: Path) -> None:
    """Moves the draft to its place."""
    _check_place(folder)
    try:
        folder.absolute().parent.mkdir(parents=True, exist_ok=True)
        if folder.is_dir():
            folder.rmdir()
        os.replace(place, folder)
    except OSError as error:
        raise InputError(f"the data set cannot be written: {error.strerror}", folder) from None
