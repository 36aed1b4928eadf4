"""Values of parameters: what the user and the files state of each run, what follows, and what only a fit determines."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.drafting.benches import Bench
from pam_cosim.drafting.columns import RecordedColumn
from pam_cosim.drafting.entries import Mapped, MappedRun, length_parameter, longest_of
from pam_cosim.drafting.headings import AT_REST, Meaning, load_in
from pam_cosim.drafting.shapes import REST_BAND, is_constant, span
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, convert, parse_quantity, readable_factor, readable_unit
from pam_cosim.wording import has_parts, listed

_NOMINAL_TOLERANCE = 0.05  # of the nominal length: a longest length as near to it is that at rest
_DATA_SHEET_TOLERANCE = 0.3  # of its value: bounds of a parameter of the fibres in a fit
_OF_A_RATING = (
    0.5,
    1.3,
)  # a jet fills at least half of an area; a flow that is stated lies within a third
# What a rule, scales, a thermometer, a gauge or the maker's drawing shows is stated, not fitted.
_MEASURED = ("m", "m2", "m3", "kg", "kg.m2", "K", "Pa", "N")
_GEOMETRY = ("m", "m2", "m3", "kg", "kg.m2", "1", "")
_ENOUGH = 3  # measures of a sleeve, one of them around, determine it


@dataclass(frozen=True)
class StatedValue:
    """A value that is known of one recording: as text for the file, and why."""

    value: str
    number: float
    why: str


def text_of(value: float, unit: str) -> str:
    """A value [SI] as ``experiment.toml`` has it, in a unit that is easy to read."""
    number = f"{value * readable_factor(unit):.6g}"
    shown = readable_unit(unit)
    shown = {"mm²": "mm2", "L": "l"}.get(shown, shown)
    return f"{number} {shown}".strip()


def check_stated(bench: Bench) -> None:
    """Raises InputError where a stated value has a unit that does not fit; names are checked when all is read."""
    for stated in (bench.evidence.stated, *bench.evidence.run_parameters):
        for name in stated.keys() & bench.settable.keys():
            try:
                parse_quantity(stated[name], bench.settable[name].unit)
            except UnitError as error:
                raise InputError(f"--parameter {name}: {error}") from None


def with_full_names(bench: Bench) -> Bench:
    """With the one parameter that has all parts of a name in their order, where the bench has none of that name."""

    def full(values: Mapping[str, str]) -> dict[str, str]:
        longer = {name: [n for n in bench.settable if has_parts(name, n)] for name in values}
        is_short = {n: n not in bench.settable and len(names) == 1 for n, names in longer.items()}
        return {longer[n][0] if is_short[n] else n: value for n, value in values.items()}

    stated, of_runs = bench.evidence.stated, bench.evidence.run_parameters
    evidence = replace(
        bench.evidence, stated=full(stated), run_parameters=tuple(map(full, of_runs))
    )
    return replace(bench, evidence=evidence)


def with_length(bench: Bench) -> Bench:
    """With the length of the muscle that a column, the user or the names of the files state."""
    name, evidence = length_parameter(bench.interface), bench.evidence
    if name is None or name in evidence.stated:
        return bench
    column = next((c for c in evidence.columns if c.meaning == AT_REST), None)
    length = bench.length
    if column is not None and span(column.samples) == 0.0:
        length = text_of(float(convert(column.samples[0], column.unit, "m")), "m")
    elif length:
        nominal, longest = parse_quantity(length, "m"), longest_of(bench.choice)
        if longest is not None and abs(longest - nominal) <= _NOMINAL_TOLERANCE * nominal:
            length = text_of(longest, "m")  # As it was measured.
    stated = {**evidence.stated, name: length} if length else evidence.stated
    return replace(bench, evidence=replace(evidence, stated=stated))


def following(bench: Bench) -> dict[str, str]:
    """Zero for each measure of a sleeve that follows from those that are stated, and would contradict them.

    Raises:
        InputError: a default contradicts what is stated, and it is unknown which one; the message states what to type.
    """
    owners = dict.fromkeys(name.rpartition(".")[0] for name in bench.evidence.stated)
    return {name: "0" for owner in owners for name in _following(f"{owner}.", bench)}


def _following(owner: str, bench: Bench) -> list[str]:
    stated, parameters = bench.evidence.stated, bench.interface.parameters
    measures = dict(bench.headings.vocabulary.measures)
    names = [owner + measure for measure in measures]
    if not parameters.keys() >= {*names}:
        return []
    given = [n for n in names if n in stated and parse_quantity(stated[n], parameters[n].unit)]
    defaults = [name for name in names if name not in stated and parameters[name].start]
    if len(given) + len(defaults) <= _ENOUGH or not defaults:
        return []
    around = [n for n in given if measures[n.removeprefix(owner)] == "around"]
    if len(given) >= _ENOUGH and around:
        return defaults
    hint = " or ".join(f"--parameter {name}=0" for name in defaults)
    raise InputError(
        f"the sleeve is determined by three of {listed(names)}: {listed(given)} is stated, and the default of "
        f"{listed(defaults)} holds too; state three, or state which measure follows from the others: {hint}"
    )


def neutral(bench: Bench) -> dict[str, str]:
    """Neutral values of what only a named muscle has, where no muscle is named: an effect may add it."""
    evidence = bench.evidence
    if bench.muscle or evidence.points:
        return {}
    values = dict(evidence.headings.vocabulary.neutral)
    parts = {n: n.rpartition(".") for n in (*bench.interface.parameters, *evidence.stated)}
    owners = {parts[n][0] for n in evidence.stated if parts[n][2] in values}
    return {
        n: values[last]
        for n, (owner, _, last) in parts.items()
        if last in values and owner not in owners
    }


# ---- values that the recordings state --------------------------------------------------------------------------------


def values_of_runs(bench: Bench, mapped: Mapped) -> list[dict[str, StatedValue]]:
    """Values that each recording states, unless the user states them: the last of the following sources counts.

    Where an input begins, loads in its name, what its columns hold in addition, remarks above its rows, the user.
    """
    evidence, settable = bench.evidence, bench.settable
    fed = bench.choice.fed.values()
    unused = [c for c in evidence.columns if c not in fed and c.meaning and c.unit]
    loads = _loads(bench)
    by_run = []
    for i, run in enumerate(mapped.runs):
        starts = {} if evidence.points else _starts(run, bench.interface)
        values = {**starts, **loads[i]}
        for column in unused:
            values |= _of_column(column, i, bench)
        values |= _of_remarks(i, bench)
        for name, value in evidence.run_parameters[i].items():
            number = parse_quantity(value, settable[name].unit) if name in settable else 0.0
            values[name] = StatedValue(value, number, "")
        by_run.append({n: v for n, v in values.items() if n not in evidence.stated})
    return by_run


def _starts(run: MappedRun, interface: Interface) -> dict[str, StatedValue]:
    """Starts of what an input drives, as ``drive.s_start`` of ``s``; those of measured states are estimated."""
    starts = {}
    for name, parameter in interface.parameters.items():
        signal = name.rpartition(".")[2].removesuffix("_start")
        values = run.inputs.get(signal)
        if not name.endswith("_start") or values is None or not np.isfinite(values).any():
            continue
        rest = run.first_rest
        part = values[rest.start : rest.stop] if rest else values[np.isfinite(values)][:1]
        first = float(np.nanmean(part))
        differs = abs(first - (parameter.start or 0.0)) > REST_BAND * span(values)
        if differs and _is_possible(first, parameter):
            starts[name] = StatedValue(text_of(first, parameter.unit), first, f"{signal} begins so")
    return starts


def _of_column(column: RecordedColumn, i: int, bench: Bench) -> dict[str, StatedValue]:
    """A load or an ambient condition that a column holds, where one parameter only can be meant."""
    values = column.values.get(i)
    is_ambient = "ambient" in column.meaning.roles
    if values is None or not (is_ambient or column.kind == "mass"):
        return {}
    if not (is_ambient or span(values) == 0.0 or is_constant(values)):
        return {}
    unit = bench.headings.units[column.kind]
    mean = float(np.nanmean(convert(values, column.unit, unit)))
    mean_value = StatedValue(
        text_of(mean, unit), mean, f"{column.name} was recorded, and this is its mean"
    )
    return dict.fromkeys(_meant(column.meaning, mean, bench), mean_value)


def _of_remarks(i: int, bench: Bench) -> dict[str, StatedValue]:
    """What lines above the rows state, of a parameter or of an input that no column feeds."""
    values: dict[str, StatedValue] = {}
    for remark in bench.evidence.remarks[i]:
        meaning = remark.meaning
        number = parse_quantity(remark.value, bench.headings.units[meaning.kind])
        names = [name for name in bench.choice.unfed if bench.meanings[name] == meaning]
        if meaning.kind == "mass" or "ambient" in meaning.roles:
            names = _meant(meaning, number, bench)
        why = f"a line above the rows states it: {remark.text}"
        values |= dict.fromkeys(names, StatedValue(remark.value, number, why))
    return values


def _meant(meaning: Meaning, value: float, bench: Bench) -> list[str]:
    """The parameter of a meaning, where there is one and it may have the value."""
    alike = bench.parameters_of(meaning)
    return [name for name, v in alike.items() if len(alike) == 1 and _is_possible(value, v)]


def _is_possible(value: float, parameter: Variable) -> bool:
    low = -np.inf if parameter.min is None else parameter.min
    high = np.inf if parameter.max is None else parameter.max
    return bool(low <= value <= high)


def _loads(bench: Bench) -> list[dict[str, StatedValue]]:
    """Loads in the names of the files, where one parameter only can be meant.

    Where a force is imposed, a weight is that force and no mass.
    """
    masses = [
        (name, v)
        for name, v in bench.interface.parameters.items()
        if v.unit == "kg" and "mass" in v.description.casefold()
    ]
    weights = all(v.unit != "N" for v in bench.interface.inputs.values())
    found = [load_in(file.stem, weights) for file in bench.evidence.files]
    loads = [load for load in found if load is not None]
    is_clear = len(masses) == 1 and len(loads) == len(found)
    if not is_clear or not all(_is_possible(mass, masses[0][1]) for _, mass in loads):
        return [{} for _ in found]
    return [
        {masses[0][0]: StatedValue(text, mass, "the file's name states it")} for text, mass in loads
    ]


# ---- which parameters can be stated, and which only a fit determines -------------------------------------------------


@dataclass(frozen=True)
class OpenParameters:
    """Parameters of a bench: free in a fit, possibly free, and those that can be measured and stated."""

    free: dict[str, Variable]
    perhaps: dict[str, Variable]
    to_state: dict[str, Variable]


def open_parameters(bench: Bench, is_warm: bool) -> OpenParameters:
    """Which parameters are free, by their descriptions.

    Points at rest determine the rubber of a muscle but nothing that takes time.

    Args:
        bench: with the words for what is calibrated.
        is_warm: a temperature was recorded; else what acts through one is not free.
    """
    words, parameters = bench.headings.vocabulary, bench.interface.parameters
    fitted, perhaps = (
        {
            name: v
            for name, v in parameters.items()
            if name.count(".") == 1
            and _is_bounded(v)
            and v.unit not in _MEASURED
            and _says(v, said)
            and not _says(v, words.chosen)
        }
        for said in (words.calibrated, words.uncertain)
    )
    points, hidden = bench.evidence.points, _hidden(bench)
    free = hidden if points else fitted
    if points:
        perhaps = {name: v for name, v in perhaps.items() if _says(v, ["friction"])}
    else:
        perhaps |= hidden
    measurable = {
        n: v
        for n, v in parameters.items()
        if n.count(".") <= 1
        and n not in {*free, *perhaps}
        and _is_measure(n, v, words.chosen)
        and (is_geometry(v) or not points)
    }
    warm = {} if is_warm else {n: v for n, v in free.items() if "K" in v.unit.replace("kg", "")}
    free = {n: v for n, v in free.items() if n not in warm}
    return OpenParameters(free, {**perhaps, **warm}, measurable)


def with_rated(opened: OpenParameters, sizes: Mapping[str, float]) -> OpenParameters:
    """With parameters free about the sizes that a data sheet states of them [SI]."""
    low, high = _OF_A_RATING
    rated = {
        n: replace(v, min=low * sizes[n], max=high * sizes[n])
        for n, v in opened.free.items()
        if n in sizes
    }
    return replace(opened, free={**opened.free, **rated})


def is_geometry(variable: Variable) -> bool:
    """Whether it is of a size, a count or a mass."""
    return variable.unit in _GEOMETRY


def _is_measure(name: str, variable: Variable, chosen: Sequence[str]) -> bool:
    """Whether it has a value and a least one, and is neither where a run begins nor a choice."""
    has_value = variable.start is not None and variable.min is not None
    return has_value and not name.endswith("_start") and not _says(variable, chosen)


def _says(variable: Variable, words: Sequence[str]) -> bool:
    description = variable.description.casefold()
    return any(word in description for word in words)


def _is_bounded(variable: Variable) -> bool:
    return variable.min is not None and variable.max is not None


def _hidden(bench: Bench) -> dict[str, Variable]:
    """Measures within the wall of a muscle that has one: where its fibres lie, and what the wall takes of its pull."""
    words, parameters = bench.headings.vocabulary, bench.interface.parameters
    deep = {n: v for n, v in parameters.items() if n.count(".") == 2 and _is_bounded(v)}
    walls = {n: v for n, v in deep.items() if _says(v, words.walls)}
    owners = {_owner(name) for name in walls}
    fibres = {
        n: _nearby(v)
        for n, v in deep.items()
        if v.start and _owner(n) in owners and _says(v, words.fibres)
    }
    return {**fibres, **walls}


def _owner(name: str) -> str:
    """The muscle of a parameter of a part of it."""
    return name.rsplit(".", 2)[0]


def _nearby(variable: Variable) -> Variable:
    """The variable with bounds about its value: those of a measure that may be zero, not stated, are no help."""
    start = variable.start or 0.0
    return replace(
        variable,
        min=start * (1.0 - _DATA_SHEET_TOLERANCE),
        max=start * (1.0 + _DATA_SHEET_TOLERANCE),
    )
