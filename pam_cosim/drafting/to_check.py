"""What only the experimenter knows of a new data set, in sentences that say how to state it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting import open_parameters
from pam_cosim.drafting.column_statistics import span
from pam_cosim.drafting.contraction import LONGEST
from pam_cosim.drafting.document import Draft
from pam_cosim.drafting.feeding import BenchChoice, meaning_of
from pam_cosim.drafting.mapped import Mapped
from pam_cosim.drafting.rest import begins_still
from pam_cosim.drafting.time_column import NO_UNIT
from pam_cosim.drafting.vocabulary import Meaning
from pam_cosim.drafting.zeros import ABSOLUTE_GAUGE, NO_PRESSURE
from pam_cosim.measurement.markers import input_marker_of, marker_of
from pam_cosim.model.interface import Interface
from pam_cosim.units import format_quantity
from pam_cosim.units.grammar import ATMOSPHERES
from pam_cosim.wording import listed, runs_in_words, shown

_FEWEST_ROWS = 2  # that a recording may have


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
            *_rows_at_rest(made),
            *_guessed_clock(made, mapped),
            *_further_clocks(made),
            *_markers(made, choice),
            *_freely_moving(made, choice),
            *_never_at_rest(made, mapped),
            *_below_zero(made, mapped),
            *_absolute_points(made, mapped),
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


def _rows_at_rest(made: Draft) -> Iterator[str]:
    if made.points is not None:
        yield (
            "no column is the time, so that each row is taken for a point at rest: where rows are samples of a "
            "recording, say how far they are apart, --recording interval='1 ms'"
        )


def _further_clocks(made: Draft) -> Iterator[str]:
    for clock in made.clocks:
        yield (
            f"{clock.name} is taken for the clock of {listed(clock.columns)}, and to have the zero of "
            f"{made.entries['time'].column}: if it has another one, write the offset under [[runs.loggers]]"
        )


def _guessed_clock(made: Draft, mapped: Mapped) -> Iterator[str]:
    """How long a recording lasts by a unit of time that nobody wrote."""
    entry = made.entries.get("time")
    guess = next((why for why in entry.why if NO_UNIT in why), "") if entry else ""
    if entry and entry.unit not in (None, "s") and guess:
        longest = max(range(len(mapped.courses)), key=lambda i: span(mapped.courses[i].time))
        lasts = format_quantity(span(mapped.courses[longest].time), "s")
        yield (
            f"{guess}, so that {made.recordings[longest]} lasts {lasts}: if it does not, write the unit of "
            "time under [columns]"
        )


def _markers(made: Draft, choice: BenchChoice) -> Iterator[str]:
    """Numbers that may mark missing samples, and how to say so; words that were met are said again."""
    for name, column in choice.fed.items():
        is_input = name in made.interface.inputs
        if column.in_names or (is_input and made.points is not None):
            continue
        values = column.every[np.isfinite(column.every)]
        value = input_marker_of(values) if is_input else marker_of(values)
        if value is not None:
            rest = values[values != value]
            words = ",".join([*(made.recording.missing or ()), f"{value:.15g}"])
            yield (
                f"{column.name} is {value:.15g} in {len(values) - len(rest)} of {len(values)} samples, and between "
                f"{rest.min():g} and {rest.max():g} in all others: where that number marks a missing sample, say "
                f"--recording 'missing={words}'"
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
    least = NO_PRESSURE * float(np.nanmax(pressures))
    if float(np.nanmin(pressures)) > least:
        yield (
            f"{listed(counted)} is counted from the longest length that was recorded, and in no row is the muscle "
            "without pressure: its length at rest is longer; measure it, and write it in the formula under [columns]"
        )


def _below_zero(made: Draft, mapped: Mapped) -> Iterator[str]:
    """Contractions of which a muscle would be far longer than at rest: their zero is that of the instrument."""
    if made.points is not None:
        return
    variables = {**made.interface.inputs, **made.interface.outputs}
    for name in dict.fromkeys(name for course in mapped.courses for name in course.every):
        if meaning_of(variables[name]) != Meaning("contraction") or name in made.stated:
            continue
        values = np.concatenate([c.every[name] for c in mapped.courses if name in c.every])
        least = float(np.nanmin(values))
        if least < -CRITERIA.starts.offset * span(values):
            reading = format_quantity(least, variables[name].unit)
            yield (
                f"{name} goes down to {reading}, as if the muscle were longer than at rest: its zero is that of "
                f'the instrument; put it right under [columns], as in {name} = {{ ..., offset = "20 mm" }}'
            )


def _absolute_points(made: Draft, mapped: Mapped) -> Iterator[str]:
    """Pressures of points at rest that begin at that of the atmosphere, where the muscle does nothing."""
    if made.points is None:
        return
    outputs = made.interface.outputs
    low, high = ATMOSPHERES
    pressures = _pressures(made.interface, mapped)
    if not pressures.size or not low <= float(np.nanmin(pressures)) <= high:
        return
    least = pressures <= high
    read = [n for n in outputs if all(n in c.every for c in mapped.courses)]
    shown_by = {n: np.abs(np.concatenate([c.every[n] for c in mapped.courses])) for n in read}
    if any(np.nanmax(v[least]) <= NO_PRESSURE * np.nanmax(v) for v in shown_by.values()):
        reading = format_quantity(float(np.nanmin(pressures)), "Pa")
        yield (
            f"the least pressure is {reading}, and the muscle does nothing there: if the gauge is an absolute one, "
            'take the ambient pressure off under [columns], as in p = { ..., offset = "-1.013 bar" }'
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
    counts = zip(made.recordings, mapped.courses, strict=True)
    few = [file for file, course in counts if len(course.time) <= _FEWEST_ROWS]
    if few and made.points is None:
        yield f"two rows determine neither noise nor parameters: record more, or leave out {listed(few)}"


def _nothing_held_out(made: Draft) -> Iterator[str]:
    points = made.points is not None and any(made.points.hold_out)
    if not points and all(role.role != "holdout" for role in made.roles):
        runs = runs_in_words(len(made.roles))
        hint = "a file may stand under [[runs]] twice, with from and to, as fit and as holdout"
        more = "" if made.points is not None else f"; {hint}"
        yield f"nothing is held out of {runs}: nothing checks a fit on data it has not seen{more}"


def _moving_starts(made: Draft, mapped: Mapped) -> Iterator[str]:
    moving = [
        c.first_rest is None and not begins_still(c.time, list(c.every.values()))
        for c in mapped.courses
    ]
    files = [file for file, moves in zip(made.recordings, moving, strict=True) if moves]
    if files and made.points is None:
        yield f"not at rest at the start, where the model is: {listed(files)}"


def _free(made: Draft) -> str:
    free = [name for name in made.free if name not in made.stated]
    if free:
        return f"free for the fit: {listed(free)}"
    return "nothing is free: see [fit] for what may be, or let diagnose look"


def _unknown_directions(made: Draft) -> list[str]:
    """Columns of directions of which no word is known."""
    return [
        f"nothing tells which way {entry.column or name} means by {listed(entry.words)}: write up or down for each"
        for name, entry in made.entries.items()
        if entry.words and not set(entry.words.values()) & {"up", "down"}
    ]
