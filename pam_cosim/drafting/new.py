"""A new data set from recordings: what is recognised becomes ``experiment.toml`` and is read as any other."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.compiler import ClassTree
from pam_cosim.drafting import open_parameters, values
from pam_cosim.drafting.bench import Bench, class_name, take_bench
from pam_cosim.drafting.column_statistics import is_held, is_repeated, is_switch, span
from pam_cosim.drafting.columns import names_in
from pam_cosim.drafting.contraction import length_parameter
from pam_cosim.drafting.document import Draft, document
from pam_cosim.drafting.feeding import MECHANICAL, meaning_of
from pam_cosim.drafting.folder import (
    check_place,
    copy_files,
    put,
    read_draft,
    temporary_sibling,
    without_detour,
)
from pam_cosim.drafting.mapped import Mapped, MappedRecording
from pam_cosim.drafting.mapping import longest_of, map_columns
from pam_cosim.drafting.noise import Sigma, sigma_of
from pam_cosim.drafting.points import check_imposed, drafted
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.requests import DraftRequests, ReadRecordings, known, recording_table
from pam_cosim.drafting.roles import Role, roles, stated_roles
from pam_cosim.drafting.sleeve import following_measures
from pam_cosim.drafting.stated_value import StatedValue, check_stated, stated_values, text_of
from pam_cosim.drafting.summary import NewDataSet, guesses, losses, next_commands
from pam_cosim.drafting.to_check import to_check
from pam_cosim.drafting.vocabulary import AT_REST, Meaning
from pam_cosim.drafting.wide import tidied
from pam_cosim.drafting.words import MEASURED_IN_COUNTS
from pam_cosim.errors import InputError
from pam_cosim.measurement.data_set import FILE_NAME
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, convert, parse_quantity

_MOST_ROWS = 20000  # rows of a run, above which means over several rows are proposed
_NOMINAL_TOLERANCE = 0.05  # of the nominal length: a longest length as near to it is that at rest


def draft(
    folder: Path,
    files: Sequence[Path],
    wishes: DraftRequests,
    tree: ClassTree,
    describe: Callable[[str], Interface],
    extra: Sequence[Path] = (),
) -> NewDataSet:
    """Drafts the data set and puts it in place.

    Args:
        folder: missing or empty.
        files: one recording each; they are copied.
        wishes: what the user says.
        tree: the library and the user's files.
        describe: gives the interface of a model.
        extra: further Modelica files that the model needs; only named in what to type next.

    Raises:
        InputError: whatever cannot be used, with file, line and column; nothing is written then.
    """
    folder = without_detour(folder)
    check_place(folder)
    with temporary_sibling(folder) as place:
        files = _tidied(files, place, wishes)
        recorded = known(files, wishes)
        bench = take_bench(place, class_name(folder), wishes, recorded, tree, describe)
        recorded = _with_length(recorded, bench)
        copy_of = dict(zip(files, copy_files(files, place), strict=True))
        try:
            for stated in (recorded.stated, *recorded.own):
                check_stated(stated, bench.interface)
        except UnitError as error:
            raise InputError(f"--parameter {error}") from None
        follows = following_measures(recorded.stated, bench.interface)
        recorded = replace(recorded, stated={**recorded.stated, **follows})
        if recorded.points:
            known_of = [{**recorded.stated, **own} for own in recorded.own]
            check_imposed(bench.choice.unfed, known_of, bench.interface)
        mapped = map_columns(bench.choice, bench.interface, recorded)
        made = _content(
            wishes.title or folder.resolve().name,
            bench,
            recorded,
            mapped,
            [copy_of[file] for file in recorded.files],
            wishes.roles or {},
        )
        made = replace(made, follows=tuple(follows))
        (place / FILE_NAME).write_text(document(made), encoding="utf-8", newline="\n")
        data = read_draft(place, {copy: file for file, copy in copy_of.items()}, describe)
        put(place, folder)
    check = (*losses(data), *to_check(made, mapped, bench.choice))
    told = guesses(made, bench.choice, recorded.time), check
    return NewDataSet(folder, data, bench.name, *told, next_commands(folder, extra))


def _tidied(files: Sequence[Path], place: Path, wishes: DraftRequests) -> list[Path]:
    """The files, of which tables with a quantity along the top have a row for each point."""
    stated = recording_table(wishes.recording or {})
    apart = [place.parent / f"tidied-{i}" for i in range(len(files))]
    for folder in apart:
        folder.mkdir()
    return [tidied(file, folder, stated) for file, folder in zip(files, apart, strict=True)]


def _with_length(recorded: ReadRecordings, bench: Bench) -> ReadRecordings:
    """With the length of the muscle that a column or the names of the files tell."""
    name = length_parameter(bench.interface)
    if name is None or name in recorded.stated:
        return recorded
    column = next((c for c in recorded.columns if c.meaning == AT_REST), None)
    if column is not None and span(column.every) == 0.0:
        length = text_of(float(convert(column.every[0], column.unit, "m")), "m")
        return replace(recorded, stated={**recorded.stated, name: length})
    if bench.muscle is None or not bench.muscle.length:
        return recorded
    length = bench.muscle.length
    nominal, longest = parse_quantity(length, "m"), longest_of(bench.choice)
    if longest is not None and abs(longest - nominal) <= _NOMINAL_TOLERANCE * nominal:
        length = text_of(longest, "m")  # As it was measured.
    return replace(recorded, stated={**recorded.stated, name: length})


def _content(
    title: str,
    bench: Bench,
    recorded: ReadRecordings,
    mapped: Mapped,
    copies: Sequence[str],
    stated: Mapping[str, str],
) -> Draft:
    """What the file says."""
    interface, choice = bench.interface, bench.choice
    told = _recorded_values(bench, recorded, mapped)
    guessed = _guessed_roles(bench, recorded, mapped, told)
    by_run = any(role.role == "holdout" for role in guessed) or bool(stated)
    measured = {*choice.outputs, *recorded.formulas}
    outputs = [name for name in interface.outputs if name in measured]
    shown = _only_shown(outputs, interface)
    fitted = [name for name in outputs if name not in shown]
    columns = {name: column for name, column in choice.fed.items() if not column.in_names}
    return Draft(
        title=title,
        model=bench.name,
        why_model=bench.why,
        interface=interface,
        recording=recorded.recording,
        entries=mapped.entries,
        ignored=_ignored(bench, recorded, mapped),
        sigmas={name: _sigma(name, bench, recorded, mapped) for name in fitted},
        shown=shown,
        stated=recorded.stated,
        unfed=[n for n in choice.unfed if not all(n in run for run in told)],
        free=open_parameters.free(interface, recorded.points),
        perhaps=open_parameters.perhaps(interface, recorded.points),
        to_state=open_parameters.to_state(interface, recorded.points),
        files=copies,
        roles=stated_roles(guessed, recorded.sources, stated),
        told=told,
        interpolation=[
            _interpolation(_set_columns(bench, recorded, i), i) for i in range(len(mapped.courses))
        ],
        resample=_means(mapped.courses),
        clocks=recorded.clocks,
        columns=tuple(dict.fromkeys(c.name for c in recorded.columns if not c.in_names)),
        having={name: sorted(column.places) for name, column in columns.items()},
        usual_muscle=bench.usual and _no_size(recorded, interface),
        parts=[source.part for source in recorded.sources],
        points=drafted(mapped.courses, interface, recorded.files, by_run)
        if recorded.points
        else None,
    )


def _only_shown(outputs: Sequence[str], interface: Interface) -> list[str]:
    """The outputs that nothing is fitted to, where there are others."""
    temperatures = [name for name in outputs if _is_temperature(interface.outputs[name])]
    return temperatures if len(outputs) > 1 else []


def _guessed_roles(
    bench: Bench,
    recorded: ReadRecordings,
    mapped: Mapped,
    told: Sequence[Mapping[str, StatedValue]],
) -> list[Role]:
    """Which recordings are held out; none, where nobody knows yet what differs between them."""
    if _unknown_mechanics(bench, recorded):
        return [Role("fit") for _ in mapped.courses]
    traits = [{n: one.number for n, one in run.items() if not one.is_start} for run in told]
    return roles(mapped.courses, bench.interface, traits, paced=not recorded.points)


def _recorded_values(
    bench: Bench, recorded: ReadRecordings, mapped: Mapped
) -> list[dict[str, StatedValue]]:
    """What each recording tells of itself, as far as the user does not state it."""
    interface = bench.interface
    left = [column for column in recorded.columns if column not in bench.choice.fed.values()]
    of_names = values.in_names(recorded.files, interface)
    of_columns = values.recorded(left, interface, len(recorded.sources))
    of_names = [
        {**names, **values.constant_values(mapped, i, interface)}
        for i, names in enumerate(of_names)
    ]
    own = [stated_values(one, interface) for one in recorded.own]
    told = [
        {
            **({} if recorded.points else values.starts(course, interface)),
            **names,
            **columns,
            **said,
        }
        for course, names, columns, said in zip(
            mapped.courses, of_names, of_columns, own, strict=True
        )
    ]
    return [{name: one for name, one in run.items() if name not in recorded.stated} for run in told]


def _no_size(recorded: ReadRecordings, interface: Interface) -> bool:
    """Whether the bench has a muscle of which no length is stated."""
    name = length_parameter(interface)
    return name is not None and not any(name in own for own in (recorded.stated, *recorded.own))


def _unknown_mechanics(bench: Bench, recorded: ReadRecordings) -> bool:
    """Whether several recordings were taken at lengths or loads that nobody says, and that may differ."""
    if len(recorded.sources) < 2:
        return False
    by_name = {name: meaning_of(bench.interface.inputs[name]) for name in bench.choice.unfed}
    mechanical = [name for name, one in by_name.items() if one and one.kind in MECHANICAL]
    unstated = [name for name in mechanical if name not in recorded.stated]
    return any(name not in own for name in unstated for own in recorded.own)


def _is_temperature(variable: Variable) -> bool:
    """A thermometer lags behind the gas: it is compared, and nothing is fitted to it."""
    meaning = meaning_of(variable)
    return meaning is not None and meaning.kind == "temperature"


def _sigma(name: str, bench: Bench, recorded: ReadRecordings, mapped: Mapped) -> Sigma:
    if name in recorded.formulas:
        return Sigma(
            None, "it is of a formula of yours: the software estimates it from the samples"
        )
    if recorded.points:
        return Sigma(
            None, "the rows are points at rest: the software estimates it from neighbouring ones"
        )
    return sigma_of(name, bench.interface.outputs[name].unit, mapped.courses, recorded.files)


def _set_columns(bench: Bench, recorded: ReadRecordings, run: int) -> list[RecordedColumn]:
    """The columns of a recording that feed inputs, as they are or by a formula."""
    inputs = bench.interface.inputs
    formulas = [text for name, text in recorded.formulas.items() if name in inputs]
    names = {name for text in formulas for name in names_in(text)}
    read = [c for c in recorded.columns if c.name in names]
    fed = [c for c in bench.choice.inputs.values() if not c.in_names]
    return [c for c in (*fed, *read) if run in c.values]


def _interpolation(columns: Sequence[RecordedColumn], run: int) -> str:
    """``previous`` where what is imposed keeps its value between steps."""
    for column in columns:
        values = column.values[run]
        keeps = is_held(values) and (is_repeated(values) or not _is_read(column))
        if column.logged_on_change or keeps or is_switch(values):
            return "previous"
    return "linear"


def _is_read(column: RecordedColumn) -> bool:
    """Whether a column is what an instrument read, and no command or set point: between samples it goes on."""
    return column.meaning is not None and column.meaning in map(Meaning, MEASURED_IN_COUNTS)


def _means(courses: Sequence[MappedRecording]) -> str:
    """An interval that leaves as many rows as a fit needs; "" where there are no more."""
    longest = max(courses, key=lambda one: len(one.time))
    if len(longest.time) <= _MOST_ROWS:
        return ""
    interval = float(np.ptp(longest.time)) / _MOST_ROWS
    return f"{float(f'{1e3 * interval:.1g}'):g} ms"


def _ignored(bench: Bench, recorded: ReadRecordings, mapped: Mapped) -> dict[str, str]:
    """Columns that are not read, and why."""
    used = {entry.column for entry in mapped.entries.values()} | {
        c.name for c in bench.choice.fed.values()
    }
    for entry in mapped.entries.values():
        used |= names_in(entry.formula or "")
    by_meaning = {column.meaning: name for name, column in bench.choice.fed.items()}
    texts = {name: "a column of text" for source in recorded.sources for name in source.texts}
    left = [
        column for column in recorded.columns if column.name not in used and not column.in_names
    ]
    said = {name: "as you say" for name in recorded.recording.ignore or ()}
    return said | texts | {column.name: _why_ignored(column, by_meaning) for column in left}


_IGNORED_KINDS = {
    "count": "a count of rows or cycles",
    "direction": "a direction, which the course in time tells by itself",
    "voltage": "a voltage; a formula under [columns] can scale it",
}


def _why_ignored(column: RecordedColumn, by_meaning: Mapping[Meaning | None, str]) -> str:
    """Why a column is not read."""
    meaning = column.meaning
    if meaning is None:
        return "; ".join(column.why) or "nobody knows what it is"
    if meaning.kind in _IGNORED_KINDS:
        return _IGNORED_KINDS[meaning.kind]
    if meaning in by_meaning:
        name = by_meaning[meaning]
        return f"it could be {name} too; --column {name}='{column.name}' would take it"
    parameter = meaning.kind == "mass" or meaning.roles & {"ambient", "rest"}
    return f"{meaning}, " + (
        "a parameter" if parameter else "which this bench neither takes nor shows"
    )
