"""What is told of a new data set: what was recognised, what was guessed, what to check and to type next."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from shlex import quote

from pam_cosim.drafting.direction import SENSES
from pam_cosim.drafting.document import Draft
from pam_cosim.drafting.feeding import BenchChoice
from pam_cosim.drafting.mapped import ColumnEntry
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.measurement import DataSet
from pam_cosim.measurement.pieces import PAUSES
from pam_cosim.measurement.table import LEFT_OUT
from pam_cosim.measurement.wrapped_clocks import WRAPPED
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, listed, runs_in_words


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
        lines = [f"{self.folder}: {runs_in_words(len(self.data.runs))}, bench {self.model}"]
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
    for file, role in zip(made.recordings, made.roles, strict=True):
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


def _of_points(made: Draft) -> list[Guess]:
    """Directions by the order of rows, and rows that are held out."""
    if made.points is None:
        return []
    rows = []
    for file, branch, aside in zip(
        made.recordings, made.points.branch, made.points.hold_out, strict=True
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
    """Rows that are left out, pauses and full counters of the recordings, each with the runs that have them."""
    notes: dict[str, list[str]] = {}
    for run in data.runs:
        for note in run.notes:
            if note.startswith((LEFT_OUT, PAUSES, WRAPPED)):
                notes.setdefault(note, []).append(run.name)
    return tuple(f"{listed(runs)}: {note}" for note, runs in notes.items())


def next_commands(folder: Path, extra: Sequence[Path]) -> tuple[str, ...]:
    """Commands, with the files that they need."""
    more = "".join(f" --file {quote(str(file))}" for file in extra)
    return tuple(
        f"pam-cosim {word} {quote(str(folder))}{more}" for word in ("compare", "check", "diagnose")
    )
