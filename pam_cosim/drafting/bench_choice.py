"""Which bench the recordings can feed, and by which column each of its inputs and outputs."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.catalogue.ports import Ports
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.rest import correlation, span
from pam_cosim.drafting.vocabulary import AT_REST, Meaning, read_variable
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Variable
from pam_cosim.model.references import BRANCH
from pam_cosim.wording import did_you_mean, listed, shown

# What a column costs that is used nowhere, an input that nothing feeds, a column that looks imposed and is read or the
# other way round, a column that is not quite what is asked for. Only their order matters: what is recorded is used.
_UNUSED, _UNFED, _UNLIKELY, _ROUNDABOUT, _UNDRIVEN = 8.0, 4.0, 1.0, 0.25, 1e3
_ISOMETRIC = 5.0
_NAMED = 0.6  # An input that is called as the bench calls it was meant for it.
_LENGTHS = ("contraction", "length", "ratio")
_NO_SIGNALS = ("voltage", "mass", "count", "direction")
MECHANICAL = (*_LENGTHS, "force")


@dataclass(frozen=True)
class BenchChoice:
    """A bench and what feeds it.

    Attributes:
        inputs, outputs: columns by the bench's names.
        unfed: inputs that no column feeds.
        others: names of benches that would do as well.
        cost: the lower, the better it fits.
        unread: how many of its outputs nobody read.
        driven: something is measured, and what drives the runs was recorded.
    """

    ports: Ports
    inputs: dict[str, RecordedColumn]
    outputs: dict[str, RecordedColumn]
    unfed: tuple[str, ...]
    others: tuple[str, ...] = ()
    cost: float = 0.0
    unread: int = 0
    driven: bool = True

    @property
    def fed(self) -> dict[str, RecordedColumn]:
        """All of them."""
        return {**self.inputs, **self.outputs}


@dataclass(frozen=True)
class _Feed:
    """What the user and the recordings give a bench, as ``choose`` has it."""

    columns: Sequence[RecordedColumn]
    asked: Mapping[str, str]
    formulas: Mapping[str, str]
    runs: int
    stated: Collection[str]

    @property
    def signals(self) -> list[RecordedColumn]:
        """Columns of which it is known what they are, but for time and what stands around a muscle."""
        known = [c for c in self.columns if c.meaning is not None and not c.of("time")]
        return [c for c in known if not _is_parameter(c)]


def choose(
    candidates: Sequence[Ports],
    columns: Sequence[RecordedColumn],
    asked: Mapping[str, str],
    formulas: Mapping[str, str],
    runs: int,
    stated: Collection[str] = (),
) -> BenchChoice:
    """The bench that uses most of what was recorded and lacks least.

    Args:
        candidates: benches.
        columns: of the recordings.
        asked: names of columns by the bench's names, as the user says.
        formulas: what the user gives a formula for.
        runs: how many recordings there are; an input must be in all of them.
        stated: inputs whose values the user states.

    Raises:
        InputError: no bench has the names that the user says, or none can be fed.
    """
    given = _Feed(columns, asked, formulas, runs, stated)
    choices = [_feed(one, given) for one in _having(candidates, given)]
    order = sorted(choices, key=lambda c: (c.cost, c.ports.rank, c.unread))
    best = order[0]
    if not best.driven:
        raise InputError(_nothing_fits(best, columns))
    others = tuple(c.ports.name for c in order[1:] if c.cost <= best.cost)
    inputs, outputs = (
        {n: _among(c, columns, best, n in asked) for n, c in side.items()}
        for side in (best.inputs, best.outputs)
    )
    return BenchChoice(best.ports, inputs, outputs, best.unfed, others[:3], best.cost, best.unread)


def _having(candidates: Sequence[Ports], given: _Feed) -> list[Ports]:
    """The benches that have every name that the user says.

    Raises:
        InputError: there is none.
    """
    named = [name for name in (*given.asked, *given.formulas) if name != "time"]
    able = [one for one in candidates if {*named} <= {*one.inputs, *one.outputs}]
    able = [one for one in able if {*given.stated} <= {*one.inputs}]
    if able:
        return able
    said = [*named, *given.stated]
    known = dict.fromkeys(name for one in candidates for name in (*one.inputs, *one.outputs))
    unknown = [name for name in said if name not in known]
    name = next(iter([*unknown, *said]), "")
    raise InputError(f"no bench has an input or output {shown(name)}; {did_you_mean(name, known)}")


def _among(
    column: RecordedColumn, columns: Sequence[RecordedColumn], best: BenchChoice, asked: bool
) -> RecordedColumn:
    """The column, saying that others could be it too."""
    taken = {c.name for c in best.fed.values()}
    rivals = [c.name for c in columns if c.meaning == column.meaning and c.name not in taken]
    if not rivals or asked:
        return column
    why = f"it is named best or moves most; {listed(map(shown, rivals))} could be it too"
    return replace(column, why=(*column.why, why))


def meaning_of(variable: Variable) -> Meaning | None:
    """What an input or output of a bench is."""
    return read_variable(variable.name, variable.description, variable.unit)


def _feed(ports: Ports, given: _Feed) -> BenchChoice:
    """A bench with the columns that feed it best, and what that costs."""
    whole = [c for c in given.signals if len(c.values) == given.runs and c.whole]
    inputs, far_inputs = _assign(ports.inputs, whole, given)
    readable = _readable(ports)
    recorded = [c for c in given.signals if not c.in_names]
    outputs, far_outputs = _assign(
        readable, [c for c in recorded if c not in inputs.values()], given
    )
    used = [*inputs.values(), *outputs.values()]
    fed = {*inputs, *given.formulas, *given.stated}
    unfed = tuple(name for name in ports.inputs if name not in fed and name != BRANCH)
    unread = readable.keys() - outputs.keys() - given.formulas.keys()
    left = _signals_among(recorded, used)
    driven = _is_driven(ports, fed, left)
    measured = bool(outputs) or len(unread) < len(readable)
    cost = (
        _UNUSED * _unused(left, used)
        + _UNFED * len(unfed)
        + _ROUNDABOUT * (far_inputs + far_outputs)
    )
    cost += _UNLIKELY * _unlikely(inputs, outputs) + _UNDRIVEN * ((not driven) + 2 * (not measured))
    cost -= _NAMED * sum(name == column.name for name, column in inputs.items())
    cost += _ISOMETRIC * _must_be_fixed(ports, used)
    return BenchChoice(ports, inputs, outputs, unfed, (), cost, len(unread), driven and measured)


def _unused(left: Sequence[RecordedColumn], used: Sequence[RecordedColumn]) -> int:
    """How many columns are left that mean something else than those that are used."""
    known = [c.meaning for c in used]
    return len([c for c in left if c.meaning not in known])


def _readable(ports: Ports) -> dict[str, Variable]:
    """Outputs that a recording can show; what a composed bench imposes, it does not measure besides."""
    if not ports.parts:
        return dict(ports.outputs)
    imposed = {meaning_of(variable) for variable in ports.inputs.values()}
    return {
        name: variable
        for name, variable in ports.outputs.items()
        if meaning_of(variable) not in imposed
    }


def _signals_among(
    columns: Sequence[RecordedColumn], used: Sequence[RecordedColumn]
) -> list[RecordedColumn]:
    """Recorded signals that are not used."""
    left = [c for c in columns if c not in used]
    return [c for c in left if c.meaning is not None and c.meaning.kind not in _NO_SIGNALS]


def _is_driven(ports: Ports, fed: Collection[str], left: Sequence[RecordedColumn]) -> bool:
    """Whether what drives the runs was recorded.

    A bench without such inputs runs by itself: where more was recorded than it shows, something drove it.
    """
    driving = [name for name, variable in ports.inputs.items() if _drives(meaning_of(variable))]
    return any(name in fed for name in driving) if driving else not left


def _is_parameter(column: RecordedColumn) -> bool:
    """Whether a column says what stands around a muscle, or how long it is, and is no signal."""
    return column.meaning is not None and (
        column.meaning == AT_REST or "ambient" in column.meaning.roles
    )


def _must_be_fixed(ports: Ports, used: Sequence[RecordedColumn]) -> bool:
    """Whether a pull changes while nobody reads a length: then it is fixed, and a bench that lets it go is none."""
    pulls = [c for c in used if c.of("force") and not c.held]
    kinds = {c.meaning.kind for c in used if c.meaning}
    lengths = [
        m for m in map(meaning_of, ports.inputs.values()) if m is not None and m.kind in _LENGTHS
    ]
    return bool(pulls) and not kinds & set(_LENGTHS) and not lengths


def _drives(meaning: Meaning | None) -> bool:
    """Whether an input is what a run is about: all but what a supply happens to hold, and a direction."""
    return meaning is None or not ("supply" in meaning.roles or meaning.kind == "direction")


def _assign(
    variables: Mapping[str, Variable], columns: Sequence[RecordedColumn], given: _Feed
) -> tuple[dict[str, RecordedColumn], float]:
    """The best column for each variable, and how far round about that is."""
    by_name = {c.name: c for c in given.columns}
    taken = {name: by_name[given.asked[name]] for name in variables if name in given.asked}
    reserved = set(given.asked.values())
    cost = 0.0
    for name, variable in variables.items():
        meaning = meaning_of(variable)
        if name in taken or meaning is None:
            continue
        left = [c for c in columns if c not in taken.values() and c.name not in reserved]
        distance, column = _nearest(name, meaning, left)
        if column is not None:
            taken[name], cost = column, cost + distance
    return taken, cost


def _nearest(
    name: str, meaning: Meaning, columns: Sequence[RecordedColumn]
) -> tuple[float, RecordedColumn | None]:
    """The column that serves a variable best, and how far it is from what is asked for.

    Of columns that are as far, the one of that name; the best known; the one that moves most; the first.
    """
    distances = {i: _distance(column.meaning, meaning) for i, column in enumerate(columns)}
    rank = []
    for i, distance in distances.items():
        if distance is not None:
            one = columns[i]
            rank.append((distance, one.name != name, -one.known, -_moves(one), i))
    if not rank:
        return 0.0, None
    best = min(rank)
    return best[0], columns[best[4]]


def _moves(column: RecordedColumn) -> float:
    """Span of a column over its largest magnitude: of two, the one that moves is the muscle's."""
    largest = float(np.nanmax(np.abs(column.every), initial=0.0))
    return span(column.every) / largest if largest else 0.0


def _distance(column: Meaning | None, variable: Meaning) -> float | None:
    """How far a column is from what a variable asks for; None: it cannot be that."""
    if column is None:
        return None
    if column == variable:
        return 0.0
    if (
        column.roles == variable.roles
        and variable.kind == "contraction"
        and column.kind in ("length", "ratio")
    ):
        return 1.0 if column.kind == "length" else 2.0
    return None


def _unlikely(inputs: Mapping[str, RecordedColumn], outputs: Mapping[str, RecordedColumn]) -> float:
    """How many columns are imposed that do not look so, or read that do."""
    pressures = (
        c
        for c in (*outputs.values(), *inputs.values())
        if c.of("pressure") or c.of("pressure", "set")
    )
    pressure = next(pressures, None)
    read, imposed = (
        [c for c in side.values() if c.meaning and c.meaning.kind in MECHANICAL]
        for side in (outputs, inputs)
    )
    held = [c for c in read if _held(c, pressure)]
    doubt = float(len(held))
    doubt += sum(0.5 if c.of("force") else 0.4 for c in imposed if not _held(c, pressure))
    return doubt + (0.5 if len(read) > 1 and not held else 0.0)


def _held(column: RecordedColumn, pressure: RecordedColumn | None) -> bool:
    """Whether a column is held, and not just at rest where the pressure is."""
    return column.held and (
        pressure is None
        or abs(correlation(pressure.values, column.values)) < CRITERIA.recognition.follows
    )


def _nothing_fits(nearest: BenchChoice, columns: Sequence[RecordedColumn]) -> str:
    known = [
        f"{c.name} ({c.meaning})" for c in columns if c.meaning is not None and not c.of("time")
    ]
    hint = "say what columns are, as --column p='Druck 1', or the bench, --model NAME ('pam-cosim bench --list')"
    if not known:
        return f"no column is recognised among {listed(c.name for c in columns if not c.of('time'))}; {hint}"
    lacks = f"the inputs {listed(nearest.unfed)}" if nearest.unfed else "a measured output"
    said = f"what is recognised, {listed(known)}, feeds no bench; the nearest, {nearest.ports.name}, lacks {lacks}"
    return f"{said}; {hint}"
