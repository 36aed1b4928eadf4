"""What is told of a new data set: what was recognised, what was guessed, what to check and to type next."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from shlex import quote

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting import open_parameters
from pam_cosim.drafting.contraction import LONGEST
from pam_cosim.drafting.direction import SENSES
from pam_cosim.drafting.document import Draft
from pam_cosim.drafting.feeding import BenchChoice, meaning_of
from pam_cosim.drafting.mapped import ColumnEntry, Mapped, MappedRecording
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.rest import begins_still
from pam_cosim.drafting.vocabulary import Meaning
from pam_cosim.drafting.zeros import ABSOLUTE_GAUGE
from pam_cosim.measurement import DataSet
from pam_cosim.measurement.pieces import PAUSES
from pam_cosim.measurement.recording import LEFT_OUT
from pam_cosim.model.interface import Interface
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, listed, shown

_FEWEST_ROWS = 2  # that a recording may have


@dataclass(frozen=True)
class Guess:
    """One line of what is told: a column or a run, what it is taken for, and why ("": the file says so)."""

    what: str
    taken_as: str
    why: str = ""


@dataclass(frozen=True)
class NewDataSet(Printed):
    """What was written.

    Attributes:
        folder: of the data set.
        data: as it reads from there.
        model: the bench, as ``experiment.toml`` names it.
        guesses: what each column, run and signal was taken for.
        to_check: sentences about what only the experimenter knows.
        next_commands: to type next.
        starts: recordings that begin elsewhere than the model by itself, in sentences.
    """

    folder: Path
    data: DataSet
    model: str
    guesses: tuple[Guess, ...]
    to_check: tuple[str, ...]
    next_commands: tuple[str, ...]
    starts: tuple[str, ...] = ()

    @property
    def headline(self) -> str:
        """What was written, and what to know before anything else: where recordings begin."""
        lines = [f"{self.folder}: {_counted(len(self.data.runs))}, bench {self.model}"]
        return "\n".join([*lines, *(f"  {sentence}" for sentence in self.starts)])

    def __str__(self) -> str:
        rows = [(g.what, g.taken_as, g.why) for g in self.guesses]
        widths = [max(len(row[k]) for row in rows) for k in (0, 1)]
        lines = [self.headline]
        lines += [f"  {a:<{widths[0]}}  {b:<{widths[1]}}  {c}".rstrip() for a, b, c in rows]
        lines += [
            "to check, and to state in experiment.toml:",
            *(f"  - {one}" for one in self.to_check),
        ]
        return "\n".join([*lines, "next:", *(f"  {one}" for one in self.next_commands)])


def _counted(runs: int) -> str:
    return f"{runs} run" if runs == 1 else f"{runs} runs"


def guesses(made: Draft, choice: BenchChoice, time: RecordedColumn | None) -> tuple[Guess, ...]:
    """A line for each column, for the noise of each signal, and for each recording that is held out."""
    columns = {**choice.fed, **({"time": time} if time is not None else {})}
    rows = [
        _of_column(name, entry, columns.get(name), made) for name, entry in made.entries.items()
    ]
    rows += [Guess(name, "not read", why) for name, why in made.ignored.items()]
    for name, sigma in made.sigmas.items():
        unit = made.interface.outputs[name].unit
        noise = "left out" if sigma.value is None else format_quantity(sigma.value, unit)
        rows.append(Guess(f"sigma of {name}", noise, f"guessed: {sigma.why}"))
    for file, role in zip(made.files, made.roles, strict=True):
        if role.why:
            rows.append(Guess(file, role.role, f"guessed: {role.why}"))
    return tuple(rows + _of_points(made))


def _of_column(name: str, entry: ColumnEntry, column: RecordedColumn | None, made: Draft) -> Guess:
    """What a column was taken for, and why."""
    what = column.name if column is not None else entry.formula or ""
    kind = "" if name == "time" else " (input)" if name in made.interface.inputs else " (measured)"
    why = "guessed: " + "; ".join(entry.why) if entry.why else ""
    return Guess(what, f"{name}{_unit_or_words(entry, column)}{kind}", why)


def _unit_or_words(entry: ColumnEntry, column: RecordedColumn | None) -> str:
    """The unit of a column; of directions, what its words or numbers mean."""
    if entry.words:
        return f": {', '.join(f'{word} = {way}' for word, way in entry.words.items())}"
    if column is None:
        return ""
    if column.senses:
        return f": {', '.join(f'{value:g} = {SENSES[sense]}' for value, sense in column.senses.items())}"
    return f" [{column.unit}]" if column.unit else ""


def _begins_still(course: MappedRecording) -> bool:
    return begins_still(course.time, list(course.every.values()))


def _unknown_directions(made: Draft) -> list[str]:
    """Columns of directions of which no word is known."""
    return [
        f"nothing tells which way {entry.column or name} means by {listed(entry.words)}: write up or down for each"
        for name, entry in made.entries.items()
        if entry.words and not set(entry.words.values()) & {"up", "down"}
    ]


def _of_points(made: Draft) -> list[Guess]:
    """Directions by the order of rows, and rows that are held out."""
    if made.points is None:
        return []
    rows = []
    for file, branch, aside in zip(
        made.files, made.points.branch, made.points.hold_out, strict=True
    ):
        if branch:
            whys = {"order": "guessed: the rows go up and come back", "none": "its rows tell none"}
            rows.append(
                Guess(
                    f"order of {file}",
                    f"branch = {branch}",
                    whys.get(branch, "guessed: the file's name"),
                )
            )
        for name, taken in aside.items():
            rows.append(
                Guess(
                    file,
                    f"held out: {name} = {listed(taken)}",
                    "guessed: they lie within what is fitted",
                )
            )
    return rows


def losses(data: DataSet) -> tuple[str, ...]:
    """Rows that are left out and pauses of the recordings, each with the runs that have them."""
    notes: dict[str, list[str]] = {}
    for run in data.runs:
        for note in run.notes:
            if note.startswith((LEFT_OUT, PAUSES)):
                notes.setdefault(note, []).append(run.name)
    return tuple(f"{listed(runs)}: {note}" for note, runs in notes.items())


def to_check(made: Draft, mapped: Mapped, choice: BenchChoice) -> tuple[str, ...]:
    """What only the experimenter knows."""
    return tuple(
        [
            *_unknown_muscle(made),
            *_unknown_geometry(made),
            *(
                [made.why_model.removeprefix("guessed: ") + "; --model takes another"]
                if made.why_model
                else []
            ),
            *_freely_moving(made, choice),
            *_never_at_rest(made, mapped),
            *_unfed_inputs(made),
            *_absolute_supply(made),
            *_unknown_directions(made),
            *_nothing_held_out(made),
            *_moving_starts(made, mapped),
            *_few_rows(made, mapped),
            _free(made),
        ]
    )


def _unknown_muscle(made: Draft) -> Iterator[str]:
    if made.usual_muscle:
        hint = "--muscle DMSP-20 ('pam-cosim bench --list' has them all), its measures, or files called DMSP-20-300..."
        yield f"which muscle it is, nobody says: it is taken for the bench's own; {hint}"


def _unknown_geometry(made: Draft) -> Iterator[str]:
    told = [name for name in made.to_state if all(name in run for run in made.told)]
    unknown = [name for name in made.to_state if name not in made.stated and name not in told]
    names = [name for name in unknown if open_parameters.is_geometry(made.to_state[name])]
    if names:
        yield f"geometry and load are the bench's own until you state yours under [parameters]: {listed(names)}"


def _unfed_inputs(made: Draft) -> Iterator[str]:
    for name in made.unfed:
        if name not in made.stated:
            hint = f"state its value, or --column {name}=..., or of each file --parameter {name}@FILE=..."
            yield f"no column was recognised as the input {name}: {hint}"


def _absolute_supply(made: Draft) -> Iterator[str]:
    """A supply, which never rests at the ambient pressure, beside a pressure that was found to be absolute."""
    absolute = [e.name for e in made.entries.values() if any(ABSOLUTE_GAUGE in w for w in e.why)]
    variables = {**made.interface.inputs, **made.interface.outputs}
    supply = Meaning("pressure", frozenset({"supply"}))
    for name, entry in made.entries.items():
        if absolute and name in variables and meaning_of(variables[name]) == supply:
            column = entry.column or name
            yield (
                f"{listed(absolute)} is of an absolute gauge: if {name} is too, take the ambient pressure off under "
                f'[columns], as in {name} = {{ column = {shown(column)}, offset = "-1.013 bar" }}'
            )


def _freely_moving(made: Draft, choice: BenchChoice) -> Iterator[str]:
    """Lengths that are taken for imposed and move, as those of a muscle that lifts a load do."""
    if made.points is not None or not choice.others:
        return
    for name, column in choice.moving_lengths.items():
        yield (
            f"{name} is taken for imposed, and {column.name} moves: if the muscle itself moved it, against a load that "
            f"hangs or a spring, say --model '{choice.others[0]}'"
        )


def _never_at_rest(made: Draft, mapped: Mapped) -> Iterator[str]:
    """Contractions counted from the longest length, where the muscle has pressure in every row."""
    counted = [e.name for e in made.entries.values() if any(LONGEST in why for why in e.why)]
    pressures = _pressures(made.interface, mapped)
    if not counted or not pressures.size:
        return
    least = CRITERIA.recognition.unloaded * float(np.nanmax(pressures))
    if float(np.nanmin(pressures)) > least:
        yield (
            f"{listed(counted)} is counted from the longest length that was recorded, and in no row is the muscle "
            "without pressure: its length at rest is longer; measure it, and write it in the formula under [columns]"
        )


def _pressures(interface: Interface, mapped: Mapped) -> Array:
    """Every pressure in the muscle, or the set points, that was recorded."""
    for roles in ((), ("set",)):
        wanted = Meaning("pressure", frozenset(roles))
        names = [
            name
            for name, variable in {**interface.outputs, **interface.inputs}.items()
            if meaning_of(variable) == wanted
        ]
        found = [c.every[name] for c in mapped.courses for name in names if name in c.every]
        if found:
            return np.concatenate(found)
    return np.empty(0)


def _few_rows(made: Draft, mapped: Mapped) -> Iterator[str]:
    """Recordings that are as short as one may be."""
    counts = zip(made.files, mapped.courses, strict=True)
    few = [file for file, course in counts if len(course.time) <= _FEWEST_ROWS]
    if few and made.points is None:
        yield f"two rows determine neither noise nor parameters: record more, or leave out {listed(few)}"


def _nothing_held_out(made: Draft) -> Iterator[str]:
    points = made.points is not None and any(made.points.hold_out)
    if not points and all(role.role != "holdout" for role in made.roles):
        yield f"nothing is held out of {_counted(len(made.roles))}: nothing checks a fit on data it has not seen"


def _moving_starts(made: Draft, mapped: Mapped) -> Iterator[str]:
    moving = [c.first_rest is None and not _begins_still(c) for c in mapped.courses]
    files = [file for file, moves in zip(made.files, moving, strict=True) if moves]
    if files and made.points is None:
        yield f"not at rest at the start, where the model is: {listed(files)}"


def _free(made: Draft) -> str:
    free = [name for name in made.free if name not in made.stated]
    if free:
        return f"free for the fit: {listed(free)}"
    return "nothing is free: see [fit] for what may be, or let diagnose look"


def next_commands(folder: Path, extra: Sequence[Path]) -> tuple[str, ...]:
    """Commands, with the files that they need."""
    more = "".join(f" --file {quote(str(file))}" for file in extra)
    return tuple(
        f"pam-cosim {word} {quote(str(folder))}{more}" for word in ("compare", "check", "diagnose")
    )
