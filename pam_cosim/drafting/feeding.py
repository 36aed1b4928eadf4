"""Which recorded columns feed a bench best, and what that costs."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

from pam_cosim.catalogue.ports import Ports
from pam_cosim.drafting.column_statistics import LEAST_CORRELATION, correlation, span
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.vocabulary import AT_REST, Meaning, read_variable
from pam_cosim.drafting.words import LENGTHS
from pam_cosim.model.interface import Variable
from pam_cosim.model.references import BRANCH
from pam_cosim.units import UnitError, convert

# What a column costs that is used nowhere, an input that nothing feeds, a column that looks imposed and is read or the
# other way round. Only their order matters: what is recorded is used.
_UNUSED, _UNFED, _UNLIKELY, _UNDRIVEN = 8.0, 4.0, 1.0, 1e3
_ISOMETRIC = 5.0
_NAMED = 0.6  # An input that is called as the bench calls it was meant for it.
_NO_SIGNALS = ("voltage", "mass", "count", "direction")
NEAR = _UNLIKELY
"""What a bench that lets go what another one imposes may cost more, to be named beside it."""
MECHANICAL = (*LENGTHS, "force")


@dataclass(frozen=True)
class BenchChoice:
    """A bench and what feeds it.

    Attributes:
        inputs, outputs: columns by the bench's names.
        unfed: inputs that no column feeds.
        others: names of benches that would do as well.
        cost: the lower, the better it fits.
        roundabout: how far columns are from what is asked for, as a length is from a contraction.
        unread: how many of its outputs nobody read.
        driven: something is measured, and what drives the runs was recorded.
    """

    ports: Ports
    inputs: dict[str, RecordedColumn]
    outputs: dict[str, RecordedColumn]
    unfed: tuple[str, ...]
    others: tuple[str, ...] = ()
    cost: float = 0.0
    roundabout: float = 0.0
    unread: int = 0
    driven: bool = True

    @property
    def moving_lengths(self) -> dict[str, RecordedColumn]:
        """What is imposed although a muscle that lifts a load would move it so, by the inputs that it feeds."""
        lengths = {n: c for n, c in self.inputs.items() if c.meaning and c.meaning.kind in LENGTHS}
        return {n: c for n, c in lengths.items() if not (c.in_names or c.held)}

    @property
    def fed(self) -> dict[str, RecordedColumn]:
        """All of them."""
        return {**self.inputs, **self.outputs}


@dataclass(frozen=True)
class Feed:
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


def meaning_of(variable: Variable) -> Meaning | None:
    """What an input or output of a bench is."""
    return read_variable(variable.name, variable.description, variable.unit)


def fed_bench(ports: Ports, given: Feed) -> BenchChoice:
    """A bench with the columns that feed it best, and what that costs."""
    whole = [c for c in given.signals if len(c.values) == given.runs and c.whole]
    inputs, far_inputs = _assign(ports.inputs, whole, given)
    readable = _readable(ports)
    recorded = [c for c in given.signals if not c.in_names]
    left_for_outputs = [c for c in recorded if c not in inputs.values()]
    outputs, far_outputs = _assign(readable, left_for_outputs, given)
    used = [*inputs.values(), *outputs.values()]
    fed = {*inputs, *given.formulas, *given.stated}
    unfed = tuple(name for name in ports.inputs if name not in fed and name != BRANCH)
    unread = readable.keys() - outputs.keys() - given.formulas.keys()
    left = _signals_among(recorded, used)
    driven = _is_driven(ports, fed, left)
    measured = bool(outputs) or len(unread) < len(readable)
    cost = _UNUSED * _unused(left, used) + _UNFED * len(unfed)
    cost += _UNLIKELY * _unlikely(inputs, outputs) + _UNDRIVEN * ((not driven) + 2 * (not measured))
    cost -= _NAMED * sum(name == column.name for name, column in inputs.items())
    cost += _ISOMETRIC * _must_be_fixed(ports, used)
    return BenchChoice(
        ports,
        inputs,
        outputs,
        unfed,
        cost=cost,
        roundabout=far_inputs + far_outputs,
        unread=len(unread),
        driven=driven and measured,
    )


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
    imposed = [meaning_of(variable) for variable in ports.inputs.values()]
    kinds |= {meaning.kind for meaning in imposed if meaning}
    return bool(pulls) and not kinds & set(LENGTHS)


def _drives(meaning: Meaning | None) -> bool:
    """Whether an input is what a run is about: all but what a supply happens to hold, and a direction."""
    return meaning is None or not ("supply" in meaning.roles or meaning.kind == "direction")


def _assign(
    variables: Mapping[str, Variable], columns: Sequence[RecordedColumn], given: Feed
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

    Of columns that are as far, the one of that name; one that moves; the best known; the one that moves most; the
    first.
    """
    distances = [(_distance(column.meaning, meaning), column) for column in columns]
    known = [distance for distance, _ in distances if distance is not None]
    if not known:
        return 0.0, None
    rivals = [column for distance, column in distances if distance == min(known)]
    if len(rivals) == 1:
        return min(known), rivals[0]
    rank = [
        (one.name != name, not one.moves, -one.known, -_span_in(rivals[0].unit, one), i)
        for i, one in enumerate(rivals)
    ]
    return min(known), rivals[min(rank)[-1]]


def _span_in(unit: str, column: RecordedColumn) -> float:
    """How far a column goes, in that unit where it can be: of two, the one that moves more is the muscle's."""
    own = span(column.every)
    with suppress(UnitError):
        return float(convert(own, column.unit, unit, difference=True))
    return own


def _distance(column: Meaning | None, variable: Meaning) -> float | None:
    """How far a column is from what a variable asks for; None: it cannot be that."""
    if column is None:
        return None
    if column == variable:
        return 0.0
    if column.roles != variable.roles or variable.kind != "contraction":
        return None
    return {"length": 1.0, "ratio": 2.0}.get(column.kind)


def _unlikely(inputs: Mapping[str, RecordedColumn], outputs: Mapping[str, RecordedColumn]) -> float:
    """How many columns are imposed that do not look so, or read that do."""
    used = [*outputs.values(), *inputs.values()]
    pressures = [c for c in used if c.of("pressure") or c.of("pressure", "set")]
    pressure = pressures[0] if pressures else None
    read, imposed = _mechanical(outputs), _mechanical(inputs)
    held = [c for c in read if _held(c, pressure)]
    doubt = float(len(held))
    doubt += sum(0.5 if c.of("force") else 0.4 for c in imposed if not _held(c, pressure))
    return doubt + (0.5 if len(read) > 1 and not held else 0.0)


def _mechanical(side: Mapping[str, RecordedColumn]) -> list[RecordedColumn]:
    return [c for c in side.values() if c.meaning and c.meaning.kind in MECHANICAL]


def _held(column: RecordedColumn, pressure: RecordedColumn | None) -> bool:
    """Whether a column is held, and not just at rest where the pressure is."""
    if not column.held or pressure is None:
        return column.held
    return abs(correlation(pressure.values, column.values)) < LEAST_CORRELATION
