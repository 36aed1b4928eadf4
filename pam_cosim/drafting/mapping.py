"""From columns of the files to names and units of the bench: entries of ``[columns]``, and the numbers they give."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.column_entry import named_entry, unit_to_state
from pam_cosim.drafting.feeding import BenchChoice, meaning_of
from pam_cosim.drafting.mapped import ColumnEntry, Mapped, MappedRecording
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.requests import ReadRecordings
from pam_cosim.drafting.rest import rests
from pam_cosim.drafting.signs import signed_entry
from pam_cosim.drafting.sources import RecordingSource
from pam_cosim.drafting.vocabulary import Meaning, fits
from pam_cosim.drafting.zeros import SET_PRESSURE, with_zero, without_offsets
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.model.interface import Interface
from pam_cosim.units import convert, parse_quantity

_FORCE = Meaning("force")


def map_columns(choice: BenchChoice, interface: Interface, known: ReadRecordings) -> Mapped:
    """Entries for what is named, signed, scaled or zeroed otherwise than the bench has it."""
    variables = {**interface.inputs, **interface.outputs}
    entries: dict[str, ColumnEntry] = {}
    if known.time is not None:
        entries["time"] = ColumnEntry(
            "time", known.time.name, unit_to_state(known.time), why=known.time.why
        )
    arrays: dict[str, dict[int, Array]] = {}
    for name, column in choice.fed.items():
        entries[name], arrays[name] = named_entry(
            name, column, variables[name], interface, known.stated, known.ambient_pressure
        )
        if column.in_names:
            held = {i: float(values[0]) for i, values in arrays[name].items()}
            entries[name] = ColumnEntry(name, why=entries[name].why, held=held)
    for name, formula in known.formulas.items():
        entries[name] = ColumnEntry(name, formula=formula)
    times = {
        i: _time(i, source, known.time, known.recording) for i, source in enumerate(known.sources)
    }
    pressure = _first(interface, arrays, Meaning("pressure"), SET_PRESSURE)
    for name in sorted(arrays, key=lambda name: meaning_of(variables[name]) != _FORCE):
        force = _first(interface, arrays, _FORCE)
        entries[name], arrays[name] = signed_entry(
            entries[name], arrays[name], choice, variables[name], pressure, force
        )
    courses = _courses(interface, times, arrays, moving=not known.points)
    if known.points:
        return Mapped(entries, courses)
    for name in arrays:
        entries[name] = with_zero(entries[name], name, choice, interface, courses, pressure)
    return Mapped(entries, _courses(interface, times, without_offsets(arrays, entries, times)))


def longest_of(choice: BenchChoice) -> float | None:
    """The longest length [m] in any recording of a column that is one; None: there is none."""
    lengths = [c for c in choice.fed.values() if c.of("length") and not c.in_names]
    return max((float(np.nanmax(convert(c.every, c.unit, "m"))) for c in lengths), default=None)


def _time(
    i: int, source: RecordingSource, time: RecordedColumn | None, recording: RecordingTable
) -> Array:
    """(n,) [s]; of points at rest, their numbers."""
    if time is not None:
        return convert(time.values[i], time.unit, "s")
    count = len(next(iter(source.table.columns.values())).values)
    step = 1.0 if recording.interval is None else parse_quantity(recording.interval.value, "s")
    return np.arange(count, dtype=np.float64) * step


def _first(
    interface: Interface, arrays: Mapping[str, dict[int, Array]], *meanings: Meaning
) -> dict[int, Array] | None:
    """The numbers of a column that is the first of what is asked for, or the next."""
    variables = {**interface.inputs, **interface.outputs}
    found = [name for one in meanings for name in arrays if meaning_of(variables[name]) == one]
    return arrays[found[0]] if found else None


def _courses(
    interface: Interface,
    times: Mapping[int, Array],
    arrays: Mapping[str, Mapping[int, Array]],
    moving: bool = True,
) -> tuple[MappedRecording, ...]:
    """The recordings; ``moving``: over time, so that they may rest."""
    made = []
    for i, time in times.items():
        inputs = {n: v[i] for n, v in arrays.items() if n in interface.inputs and i in v}
        outputs = {n: v[i] for n, v in arrays.items() if n in interface.outputs and i in v}
        quick = [
            v for n, v in outputs.items() if not fits(interface.outputs[n].unit, "temperature")
        ]
        at_rest = rests(time, [*inputs.values(), *quick]) if moving else []
        made.append(MappedRecording(time, inputs, outputs, tuple(at_rest)))
    return tuple(made)
