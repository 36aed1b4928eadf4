"""The report of a new data set: what was recognised and guessed, what only the experimenter knows, what to type."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from shlex import quote

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.benches import NO_PRESSURE
from pam_cosim.drafting.columns import NO_UNIT, RecordedColumn, scaling
from pam_cosim.drafting.data_sheets import EXAMPLES
from pam_cosim.drafting.document import Draft, bounds
from pam_cosim.drafting.entries import ABSOLUTE_GAUGE, LONGEST, SENSES, ColumnEntry, readings_of
from pam_cosim.drafting.headings import LENGTHS, MECHANICAL, PRESSURE, SET_PRESSURE, meant
from pam_cosim.drafting.shapes import begins_still, span
from pam_cosim.drafting.values import is_geometry
from pam_cosim.measurement import DataSet
from pam_cosim.measurement.markers import input_marker_of, marker_of
from pam_cosim.measurement.pieces import PAUSES
from pam_cosim.measurement.table import LEFT_OUT
from pam_cosim.measurement.wrapped_clocks import WRAPPED
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_fmu
from pam_cosim.units import format_quantity
from pam_cosim.units.grammar import ATMOSPHERES
from pam_cosim.wording import Printed, listed, runs_in_words, shown

_FEWEST_ROWS = 2  # that a recording may have


@dataclass(frozen=True)
class Guess:
    """One line of the report: a column or a run, what it is taken for, and why ("": the file states it)."""

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
        to_check: sentences about what only the experimenter knows, what decides most first.
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
            *(f"  - {line}" for line in self.to_check),
        ]
        return "\n".join([*lines, "next:", *(f"  {line}" for line in self.next_commands)])


def next_commands(folder: Path, extra: Sequence[Path], model: str) -> tuple[str, ...]:
    """Commands, with the files that they need; of an FMU nothing can be diagnosed."""
    more = "".join(f" --file {quote(str(file))}" for file in extra)
    words = ("compare", "check", *(() if is_fmu(model) else ("diagnose",)))
    return tuple(f"pam-cosim {word} {quote(str(folder))}{more}" for word in words)


# ---- what was recognised ---------------------------------------------------------------------------------------------


def guesses(draft: Draft) -> tuple[Guess, ...]:
    """A line for each column, for the noise of each signal, and for each recording that is held out."""
    time = draft.evidence.time
    columns = {**draft.bench.choice.fed, **({"time": time} if time is not None else {})}
    entries = draft.mapped.entries.items()
    rows = [_of_column(name, entry, columns.get(name), draft) for name, entry in entries]
    rows += [Guess(name, "not read", why) for name, why in draft.ignored.items()]
    for reason in dict.fromkeys(why for _, why in draft.follows.values()):
        values = {n: value for n, (value, why) in draft.follows.items() if why == reason}
        rows.append(Guess(", ".join(values), ", ".join(values.values()), f"guessed: {reason}"))
    for name, sigma in draft.sigmas.items():
        unit = draft.interface.outputs[name].unit
        noise = "left out" if sigma.value is None else format_quantity(sigma.value, unit)
        rows.append(Guess(f"sigma of {name}", noise, f"guessed: {sigma.why}"))
    named = list(zip(draft.recordings, draft.roles, strict=True))
    rows += [Guess(f, role.role, f"guessed: {role.why}") for f, role in named if role.why]
    for i, (file, _) in enumerate(named if draft.points else ()):
        rows += _of_points(draft, i, file)
    return tuple(rows)


def _of_column(name: str, entry: ColumnEntry, column: RecordedColumn | None, draft: Draft) -> Guess:
    """What a column was taken for, and why."""
    what = column.name if column is not None else entry.formula or ""
    kind = "" if name == "time" else " (input)" if name in draft.interface.inputs else " (measured)"
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


def _of_points(draft: Draft, i: int, file: str) -> Iterator[Guess]:
    """Directions by the order of rows, and rows that are held out."""
    assert draft.points is not None
    branch = draft.points.branch[i]
    if branch:
        whys = {"order": "guessed: the rows go up and come back", "none": "its rows tell none"}
        yield Guess(
            f"order of {file}", f"branch = {branch}", whys.get(branch, "guessed: the file's name")
        )
    for name, taken in draft.points.hold_out[i].items():
        yield Guess(
            file,
            f"held out: {name} = {listed(taken)}",
            "guessed: they lie within the range of the fitted rows",
        )


def losses(data: DataSet) -> tuple[str, ...]:
    """Rows that are left out, pauses and full counters of the recordings, each with the runs that have them."""
    notes: dict[str, list[str]] = {}
    for run in data.runs:
        for note in run.notes:
            if note.startswith((LEFT_OUT, PAUSES, WRAPPED)):
                notes.setdefault(note, []).append(run.name)
    return tuple(f"{listed(runs)}: {note}" for note, runs in notes.items())


# ---- what only the experimenter knows --------------------------------------------------------------------------------


def questions(draft: Draft) -> tuple[str, ...]:
    """What only the experimenter knows: the rig first, then the columns, then the runs."""
    topics = (
        _what_holds_it, _what_drives_it, _valve_data, _which_muscle, _geometry, _which_bench, _rows_at_rest, _clocks,
        _below_zero, _markers, _never_at_rest, _absolute, _angles, _runs, _free,
    )  # fmt: skip
    return tuple(sentence for question in topics for sentence in question(draft))


def _what_holds_it(draft: Draft) -> Iterator[str]:
    """Whether the load end hangs, is sprung or is held, where the recordings do not determine that."""
    choice = draft.bench.choice
    recorded = {c.kind for c in draft.evidence.signals}
    for name, column in choice.moving_lengths.items():
        if draft.points is None and choice.freer:
            yield (
                f"{name} is taken for imposed, and {column.name} moves: if the muscle itself moved it, against a load "
                f"that hangs or a spring, use --model '{choice.freer}'"
            )
    forces = [n for n, c in choice.inputs.items() if c.kind == "force"]
    if forces and draft.points is None:
        yield (
            f"{forces[0]} is taken for a force that a machine imposes: if a load hangs or a spring pulls, and "
            f"{choice.inputs[forces[0]].name} is the reading of a load cell, name the bench, --model NAME "
            "('pam-cosim bench --list')"
        )
    has_body = any(meaning.kind in MECHANICAL for meaning in draft.bench.meanings.values())
    if draft.bench.why and not recorded & set(MECHANICAL) and not draft.points and not has_body:
        yield (
            "neither a length nor a force was recorded, so that this is taken for a vessel of fixed volume: if it "
            "is a muscle, state what holds it, --model NAME ('pam-cosim bench --list')"
        )


def _what_drives_it(draft: Draft) -> Iterator[str]:
    """Inputs without a value, pressures that are imposed, voltages, and one command for two valves."""
    unfed = draft.unfed
    for name in unfed:
        description = draft.interface.inputs[name].description
        hint = f"--parameter '{name}=...', --column {name}=..., or of each file --parameter {name}@FILE=..."
        yield f"no column and no line of the files states the input {name} ({description}): {hint}"
    unused = [c for c in draft.evidence.columns if c.name not in draft.bench.used]
    volts = [c for c in unused if c.kind == "voltage"]
    for column in volts:
        roles = draft.evidence.headings.roles_of(column.name)
        valve = "u_out" if "exhaust" in roles else "u_in" if "inlet" in roles else ""
        size = ("p_set", "60 kPa/V") if not valve else (valve, "40 mA/V")
        yield (
            f"{column.name} is a voltage and is not read: if it drives the rig, state what it commands, as in --column "
            f"{scaling(size[0], column.name, size[1])}, or the valve, as in --model 'proportional-pressure-valve and "
            f"hanging-load' --column {quote(f'u={column.name}')}"
        )
    pressure = [n for n, c in draft.bench.choice.inputs.items() if c.of("pressure")]
    if pressure and draft.points is None:
        yield (
            f"nothing was recorded that drives the pressure, so that {pressure[0]} is taken as imposed: valves, supply "
            "and gas are no part of the model then; if a column drives them, state which, as --column NAME=COLUMN "
            "--model NAME"
        )
    halves = {c.name for c in draft.bench.choice.inputs.values() if c.formula}
    for command in halves:
        yield (
            f"does one command, {command}, drive both valves? It is taken so: above zero it opens the inlet, below the "
            "exhaust, in full at 1 without a dead band; scale the formulas under [columns] where it is not so"
        )


def _valve_data(draft: Draft) -> Iterator[str]:
    """Calibrations of valves, which a data sheet states."""
    names = [n for n, v in draft.free.items() if "area" in v.description]
    if names and not draft.valve:
        yield (
            f"flow area of the valves: {listed(names)} is free; where a data sheet states the area or the nominal flow "
            f"at an input, add {EXAMPLES}"
        )


def _which_muscle(draft: Draft) -> Iterator[str]:
    bench = draft.bench
    length = [measure for measure, _ in bench.headings.vocabulary.measures][:1]
    names = [n for n in draft.interface.parameters if n.rpartition(".")[2] in length]
    is_ready = not bench.why and not bench.composed
    if not names or bench.muscle or is_ready or {*names} & {*draft.evidence.stated_names}:
        return
    name = next((n for n in names if n in draft.open.to_state), "")
    more = f", or its measures, --parameter '{name}=250 mm' and more" if name else ""
    yield (
        "the muscle is not stated: the bench's default is used without the friction of its fibres; add --muscle "
        f"DMSP-20-300 (type and length in mm; 'pam-cosim bench --list' has the types){more}"
    )


def _geometry(draft: Draft) -> Iterator[str]:
    unknown = [
        n for n, v in draft.open.to_state.items() if is_geometry(v) and not draft.is_known(n)
    ]
    if unknown:
        yield f"geometry and load are the bench's own until you state yours under [parameters]: {listed(unknown)}"


def _which_bench(draft: Draft) -> Iterator[str]:
    if draft.bench.why:
        yield draft.bench.why.removeprefix("guessed: ") + "; for another, --model NAME"


def _rows_at_rest(draft: Draft) -> Iterator[str]:
    if draft.points is not None:
        yield (
            "no column is the time, so that each row is taken for a point at rest: where rows are samples of a "
            "recording, state their distance, --recording interval='1 ms'"
        )


def _clocks(draft: Draft) -> Iterator[str]:
    """Files of several clocks, and how long a recording lasts by a guessed unit of time."""
    sources = [s for s in draft.evidence.sources if s.is_merged]
    merged = [" with ".join(f.name for f in (s.file, *s.loggers)) for s in sources]
    if merged:
        yield (
            f"{listed(merged)}: several clocks, of one zero as it is taken; every time of any has a row of its own in "
            "what is written; where a clock has another zero, correct its times in the file"
        )
    entry = draft.mapped.entries.get("time")
    guess = next((why for why in entry.why if NO_UNIT in why), "") if entry else ""
    if entry and entry.unit not in (None, "s") and guess:
        runs = draft.mapped.runs
        longest = max(range(len(runs)), key=lambda i: span(runs[i].time))
        lasts = format_quantity(span(runs[longest].time), "s")
        yield (
            f"{guess}, so that {draft.recordings[longest]} lasts {lasts}: if it does not, write the unit of "
            "time under [columns]"
        )


def _markers(draft: Draft) -> Iterator[str]:
    """Numbers that may mark missing samples, and the option for that; it repeats the words that were found."""
    for name, column in draft.bench.choice.fed.items():
        is_input = name in draft.interface.inputs
        if is_input and draft.points is not None:
            continue
        values = column.samples[np.isfinite(column.samples)]
        value = input_marker_of(values) if is_input else marker_of(values)
        if value is not None:
            unmarked = values[values != value]
            words = ",".join([*(draft.evidence.recording.missing or ()), f"{value:.15g}"])
            yield (
                f"{column.name} is {value:.15g} in {len(values) - len(unmarked)} of {len(values)} samples, and between "
                f"{unmarked.min():g} and {unmarked.max():g} in all others: where that number marks a missing sample, "
                f"add --recording 'missing={words}'"
            )


def _pressures(draft: Draft) -> Array:
    """Every pressure in the muscle, or the set points, that was recorded."""
    wanted = (PRESSURE, SET_PRESSURE)
    names = [n for kind in wanted for n, meaning in draft.bench.meanings.items() if meaning == kind]
    return readings_of(draft.mapped, names)


def _never_at_rest(draft: Draft) -> Iterator[str]:
    """Contractions counted from the longest length, where the muscle has pressure in every row."""
    entries = draft.mapped.entries.values()
    counted = [e.name for e in entries if any(LONGEST in why for why in e.why)]
    pressures = _pressures(draft)
    if (
        counted
        and pressures.size
        and float(np.nanmin(pressures)) > NO_PRESSURE * float(np.nanmax(pressures))
    ):
        yield (
            f"{listed(counted)} is counted from the longest length that was recorded, and in no row is the muscle "
            "without pressure: its length at rest is longer; measure it, and write it in the formula under [columns]"
        )


def below_zero(draft: Draft) -> Iterator[tuple[str, float, str]]:
    """Contractions of which a muscle would be far longer than at rest: signal, least value, and what to type."""
    fed = draft.bench.choice.fed.items() if draft.points is None else ()
    for name, column in fed:
        values = readings_of(draft.mapped, [name])
        if draft.bench.meanings[name] != meant("contraction") or not values.size:
            continue
        least = float(np.nanmin(values))
        if least < -CRITERIA.starts.offset * span(values):
            far = format_quantity(-least, "m")
            term = column.name if column.name.isidentifier() else f"'{column.name}'"
            term += "" if column.stated else f' * "1 {column.unit}"'
            turned = (draft.mapped.entries[name].formula or "").startswith("-")
            formula = f'"{far}" - {term}' if turned else f'{term} + "{far}"'
            yield name, least, f"--column {quote(f'{name}={formula}')}"


def _below_zero(draft: Draft) -> Iterator[str]:
    for name, least, say in below_zero(draft):
        yield (
            f"{name} goes down to {format_quantity(least, 'm')}, as if the muscle were longer than at rest: its zero "
            f"is that of the instrument; which reading is zero? State it, as in {say}"
        )


def _absolute(draft: Draft) -> Iterator[str]:
    """A supply in a recording whose other pressure is absolute; points that begin at the pressure of the atmosphere."""
    entries = draft.mapped.entries
    absolute = [e.name for e in entries.values() if any(ABSOLUTE_GAUGE in why for why in e.why)]
    supplies = [
        n
        for n, meaning in draft.bench.meanings.items()
        if meaning == meant("pressure", "supply") and n in entries
    ]
    for name in supplies if absolute else ():
        column = entries[name].column or name
        yield (
            f"{listed(absolute)} is of an absolute gauge: if {name} is too, take the ambient pressure off under "
            f'[columns], as in {name} = {{ column = {shown(column)}, offset = "-1.013 bar" }}'
        )
    pressures, (low, high) = _pressures(draft), ATMOSPHERES
    if draft.points is None or not pressures.size or not low <= float(np.nanmin(pressures)) <= high:
        return
    read = [
        n for n in draft.interface.outputs if all(n in run.signals for run in draft.mapped.runs)
    ]
    shown_by = [np.abs(readings_of(draft.mapped, [n])) for n in read]
    if any(np.nanmax(v[pressures <= high]) <= NO_PRESSURE * np.nanmax(v) for v in shown_by):
        yield (
            f"the least pressure is {format_quantity(float(np.nanmin(pressures)), 'Pa')}, and the muscle does nothing "
            "there: if the gauge is an absolute one, take the ambient pressure off under [columns], as in "
            'p = { ..., offset = "-1.013 bar" }'
        )


def _angles(draft: Draft) -> Iterator[str]:
    """Angles that are not read, as of a pulley; directions of which no word is known."""
    lengths = any(c.kind in LENGTHS for c in draft.bench.choice.fed.values())
    for column in draft.evidence.columns:
        if column.kind == "angle" and not lengths and column.name not in draft.bench.used:
            yield (
                f"{column.name} is an angle: if the load hangs on a pulley, state its radius, as in --column "
                f"{scaling('x', column.name, '20 mm/rad')}"
            )
    for name, entry in draft.mapped.entries.items():
        if entry.words and not set(entry.words.values()) & {"up", "down"}:
            yield (
                f"the directions that {entry.column or name} means by {listed(entry.words)} are unknown: write up or "
                "down for each under [columns]"
            )


def _runs(draft: Draft) -> Iterator[str]:
    """Runs that nothing checks, that begin in motion, or that have too few rows."""
    over_time = draft.points is None
    held_out = any(role.role == "holdout" for role in draft.roles)
    if not held_out and (draft.points is None or not any(draft.points.hold_out)):
        hint = (
            "; a file may stand under [[runs]] twice, with from and to, as fit and as holdout"
            * over_time
        )
        runs = runs_in_words(len(draft.roles))
        yield f"nothing is held out of {runs}: no fit is checked on other data{hint}"
    named = list(zip(draft.recordings, draft.mapped.runs, strict=True)) if over_time else []
    moving = [
        f
        for f, run in named
        if not (run.first_rest or begins_still(run.time, list(run.signals.values())))
    ]
    if moving:
        yield f"not at rest at the start, where the model is: {listed(moving)}"
    few = [file for file, run in named if len(run.time) <= _FEWEST_ROWS]
    if few:
        yield f"two rows determine neither noise nor parameters: record more, or leave out {listed(few)}"


def _free(draft: Draft) -> Iterator[str]:
    free = list(draft.free)
    if free:
        yield f"free for the fit, since they are not calibrated: {listed(free)}"
    elif draft.open.perhaps:
        yield "nothing is free: see [fit] for what may be, or let diagnose look"
    else:
        yield f"nothing is free: {_free_example(draft.interface)}"


def _free_example(interface: Interface) -> str:
    """What to write under [fit], by a parameter of the model that a fit can change."""
    for name, v in interface.parameters.items():
        if v.kind == "Real" and v.start:
            low, high = sorted((v.start / 2, 2 * v.start))
            low, high = (
                (low if v.min is None else max(v.min, low)),
                (high if v.max is None else min(v.max, high)),
            )
            limited = replace(v, min=low, max=high)
            return f"write under [fit] what a fit may change, such as {bounds(name, limited)}"
    return "the model has no parameter that a fit can change"
