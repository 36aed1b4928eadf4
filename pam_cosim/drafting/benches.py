"""The bench of a new data set: the one that the user names, or the one that the recordings feed best."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf
from pathlib import Path

import numpy as np

from pam_cosim.catalogue.bench_parts import BenchPart, rig_parts
from pam_cosim.catalogue.composed_bench import compose_bench
from pam_cosim.catalogue.ports import Ports, ports
from pam_cosim.compiler import ClassTree
from pam_cosim.drafting.columns import NO_UNIT, RecordedColumn
from pam_cosim.drafting.evidence import DraftRequests, Evidence, used_in
from pam_cosim.drafting.headings import (
    LENGTHS,
    MECHANICAL,
    PRESSURE,
    SET_PRESSURE,
    Headings,
    Meaning,
    alike,
    muscle_in,
)
from pam_cosim.drafting.recordings import Source
from pam_cosim.drafting.shapes import LEAST_CORRELATION, correlation, span
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.references import BRANCH, is_file
from pam_cosim.units import UnitError, convert
from pam_cosim.units.grammar import STANDARD_ATMOSPHERE
from pam_cosim.wording import did_you_mean, listed, shown

NO_PRESSURE = 0.05  # of the largest pressure; a muscle counts as without pressure below
# What speaks against a bench. Only their order matters: what is recorded is used.
_UNDRIVEN, _UNUSED, _UNFED, _BODILESS, _UNLIKELY = 1e3, 8.0, 4.0, 2.0, 1.0
_ISOMETRIC = 5.0
_NAMED = 0.6  # An input that is called as the bench calls it was meant for it.
_SUFFIX = "Rig"


@dataclass(frozen=True)
class BenchChoice:
    """A bench and what feeds it.

    Attributes:
        inputs, outputs: columns by the bench's names.
        unfed: inputs that no column feeds.
        alternatives: names of benches that fit as well.
        freer: a bench that reads the lengths that this one imposes; "": there is none, or it imposes none that move.
        order: the lower, the better it fits: what speaks against it, the rank of the bench, how far columns are from
            what is requested, as a length is from a contraction, and how many of its outputs are not read.
        measured: something is measured; ``driven``: and what drives the runs was recorded.
    """

    ports: Ports
    inputs: dict[str, RecordedColumn]
    outputs: dict[str, RecordedColumn]
    unfed: tuple[str, ...]
    alternatives: tuple[str, ...] = ()
    freer: str = ""
    order: tuple[float, ...] = ()
    measured: bool = True
    driven: bool = True

    @property
    def moving_lengths(self) -> dict[str, RecordedColumn]:
        """What is imposed although a muscle that lifts a load would move it so, by the inputs that it feeds."""
        lengths = {n: c for n, c in self.inputs.items() if c.kind in LENGTHS}
        return {n: c for n, c in lengths.items() if not c.held}

    @property
    def fed(self) -> dict[str, RecordedColumn]:
        """All columns that are used."""
        return {**self.inputs, **self.outputs}


@dataclass(frozen=True)
class Bench:
    """A bench, what was recorded of the rig, and what feeds it.

    Attributes:
        name: as ``experiment.toml`` has it.
        why: empty where the user states it.
        muscle: named by the files or the user, "": not stated; ``length``: its length as a text, or "".
        composed: it was put together from parts.
    """

    choice: BenchChoice
    name: str
    interface: Interface
    evidence: Evidence
    why: str = ""
    muscle: str = ""
    length: str = ""
    composed: bool = False

    @property
    def headings(self) -> Headings:
        """By which inputs and outputs are read."""
        return self.evidence.headings

    @property
    def signals(self) -> dict[str, Variable]:
        """Inputs and outputs."""
        return {**self.interface.inputs, **self.interface.outputs}

    @cached_property
    def meanings(self) -> dict[str, Meaning]:
        """What the inputs and outputs are."""
        return self.headings.meanings(self.signals)

    @property
    def settable(self) -> dict[str, Variable]:
        """Parameters, and inputs whose values can be stated."""
        return {**self.interface.parameters, **self.interface.inputs}

    def parameters_of(self, meaning: Meaning) -> dict[str, Variable]:
        """The parameters of a meaning.

        What is around a rig is recorded as it is, and not against itself: a gauge pressure of the room is none.
        """
        return {
            name: v
            for name, v in self.interface.parameters.items()
            if v.unit == self.headings.units[meaning.kind]
            and "gauge" not in v.description.casefold()
            and self.headings.meaning_of(name.rpartition(".")[2], v.description, v.unit) == meaning
        }

    @cached_property
    def used(self) -> set[str]:
        """The columns that are read, also in a formula."""
        times = [self.evidence.time] if self.evidence.time is not None else []
        return {c.name for c in (*self.choice.fed.values(), *times)} | used_in(self.evidence)


def stated_interface(
    model: str | None, tree: ClassTree, describe: Callable[[str], Interface]
) -> Interface | None:
    """The interface of the model that the user names; None where there is none, or it is put together from parts."""
    if model is None or any(bench.name == model for bench in ports(tree) if bench.parts):
        return None
    return describe(model)


def take_bench(
    place: Path,
    name: str,
    requests: DraftRequests,
    interface: Interface | None,
    evidence: Evidence,
    tree: ClassTree,
    describe: Callable[[str], Interface],
) -> Bench:
    """The bench that the user names, or the one that fits best; its files are written into ``place``.

    Args:
        place: the folder that becomes the data set.
        name: of a class that is put together.
        requests: what the user states.
        interface: of the model that the user names, as ``stated_interface`` has it; a file is copied already.
        evidence: what was recorded.
        tree: the library and the user's files.
        describe: gives the interface of a model.

    Raises:
        InputError: there is no such bench, or none that the recordings feed.
    """
    if interface is not None:
        if requests.muscle is not None:
            message = f"a muscle is named for a bench that is put together, and {requests.model} is there already"
            raise InputError(message)
        fixed = Ports(interface.model, interface.inputs, interface.outputs)
        choice = _choose([fixed], evidence, is_stated=True)
        copied = Path(str(requests.model)).name if is_file(str(requests.model)) else interface.model
        return Bench(choice, copied, interface, evidence)
    muscles = _muscles(tree)
    texts = [] if requests.model else [_label(source) for source in evidence.sources]
    if requests.muscle:
        texts = [requests.muscle]
    named_muscle, length = muscle_in(texts, [part.name for part in muscles])
    muscle = named_muscle or requests.muscle
    needed = muscle or _part_with(evidence.stated, muscles, tree)
    candidates = _candidates(requests.model, needed, evidence, tree)
    choice = _choose(_with_stated_parts(candidates, evidence, tree), evidence)
    why = "" if requests.model else _why(choice)
    if not choice.ports.parts:
        return Bench(choice, choice.ports.name, describe(choice.ports.name), evidence, why)
    feed, hold = choice.ports.parts
    outputs = [n for n in choice.ports.outputs if n not in choice.ports.inputs]
    measure = [n for n in outputs if n in choice.outputs or n in evidence.formulas]
    text = compose_bench(tree, feed, hold, needed, measure, name, evidence.points).text
    (place / f"{name}.mo").write_text(text, encoding="utf-8", newline="\n")
    origin = f"{name}.mo was put together from {choice.ports.name}"
    if named_muscle and not requests.muscle:
        origin = f"{origin}, with the muscle {named_muscle}, which the files or their names state"
    if needed and not muscle:
        origin = f"{origin}, with the muscle {needed}, which has the parameters that are stated"
    why = f"{why}. {origin}" if why else origin
    composed = describe(str(place / f"{name}.mo"))
    return Bench(choice, f"{name}.mo", composed, evidence, why, muscle or "", length, True)


def _muscles(tree: ClassTree) -> list[BenchPart]:
    return [part for part in rig_parts(tree) if part.role == "muscle"]


def _part_with(stated: Iterable[str], muscles: Sequence[BenchPart], tree: ClassTree) -> str | None:
    """The muscle nearest to the usual one that has the stated parameters; None: the usual one, or none, has them."""
    usual = next((part for part in muscles if part.usual), None)
    if usual is None:
        return None
    owned = [name for name in stated if name.startswith(f"{usual.component_name}.")]
    wanted = {name.rpartition(".")[2] for name in owned}
    able = [
        part
        for part in muscles
        if usual.qualified_name in (part.qualified_name, *tree.bases(part.qualified_name))
        and wanted <= _parameters_of(part.qualified_name, tree)
    ]
    nearest = min(able, key=lambda part: len(tree.bases(part.qualified_name)), default=usual)
    return None if nearest.usual else nearest.name


def _parameters_of(name: str, tree: ClassTree) -> set[str]:
    """Parameters of a class and of its records, by their last names."""
    components = [c for c in tree.components(name) if "protected" not in c.prefixes]
    records = [c.type for c in components if c.type in tree.classes]
    within = [c for record in records for c in tree.components(record)]
    return {c.name for c in (*components, *within)}


def _label(source: Source) -> str:
    return " ".join([source.file.stem, *source.labels, *source.remarks])


def class_name(folder: Path) -> str:
    """A name for the class, made from that of the folder: ``my-rig`` is ``MyRig``."""
    words = re.findall(r"[A-Za-z][A-Za-z0-9]*", folder.resolve().name)
    name = "".join(word[0].upper() + word[1:] for word in words)[:40]
    return name if name.endswith(_SUFFIX) else f"{name}{_SUFFIX}"


def _candidates(
    model: str | None, muscle: str | None, evidence: Evidence, tree: ClassTree
) -> list[Ports]:
    """The benches among which the recordings choose; only one that is put together can have another muscle.

    Benches of points at rest have a direction, others have none. Where a pressure falls to that outside, none is
    chosen in which everything is shut.
    """
    points, parts = evidence.points, [bench for bench in ports(tree) if bench.parts]
    if points:
        branch = {BRANCH: Variable(BRANCH, "1", "Direction of the branch")}
        parts = [replace(bench, inputs={**bench.inputs, **branch}) for bench in parts]
    if model is not None:
        return [bench for bench in parts if bench.name == model]
    empties = any(c.of("pressure") and _empties(c) for c in evidence.columns)
    ready = [
        bench
        for bench in ports(tree)
        if not (bench.parts or muscle)
        and (BRANCH in bench.inputs) == points
        and not (empties and _is_shut(bench, tree))
    ]
    # A row has what acts on the muscle: a table contains no mass, spring or lever.
    chosen = [*ready, *parts]
    return [b for b in chosen if not points or _mechanical(b.inputs, evidence.headings)]


def _with_stated_parts(
    candidates: Sequence[Ports], evidence: Evidence, tree: ClassTree
) -> list[Ports]:
    """The benches that lack fewest of the parts of which the user states a parameter, as the spring of ``spring.k``."""
    part_names = {p.qualified_name: p.component_name for p in rig_parts(tree) if p.role != "muscle"}
    owners = {name.partition(".")[0] for name in evidence.stated_names} & {*part_names.values()}

    if not owners:
        return list(candidates)
    lacking = {
        bench.name: len(
            owners.difference(
                [part_names[name] for name in bench.parts]
                or [c.name for c in tree.components(bench.name)]
            )
        )
        for bench in candidates
    }
    least = min(lacking.values(), default=0)
    return [bench for bench in candidates if lacking[bench.name] == least]


def _is_shut(bench: Ports, tree: ClassTree) -> bool:
    """Whether a bench lets no air out."""
    types = {c.type.rpartition(".")[2] for c in tree.components(bench.name)}
    return not bench.inputs and "Atmosphere" not in types


def _empties(column: RecordedColumn) -> bool:
    """Whether a pressure falls in every recording from its largest to next to none."""
    outside = STANDARD_ATMOSPHERE if column.absolute else 0.0
    ends = []
    for values in column.values.values():
        gauge = convert(values[np.isfinite(values)], column.unit, "Pa") - outside
        least = NO_PRESSURE * float(gauge.max())
        ends.append(gauge[0] > gauge[-1] and abs(float(gauge[-1])) <= least)
    return bool(column.unit) and all(ends)


def _why(choice: BenchChoice) -> str:
    fed = listed(f"{name} = {column.name}" for name, column in choice.fed.items())
    why = f"guessed: the bench, because its inputs and outputs were recorded: {fed}"
    if not choice.alternatives:
        return why
    return f"{why}. Other benches fit as well: {listed(choice.alternatives)}"


# ---- which bench the recordings can feed, and by which column each of its inputs and outputs -------------------------


def _choose(
    candidates: Sequence[Ports], evidence: Evidence, is_stated: bool = False
) -> BenchChoice:
    """The bench that uses most of what was recorded and lacks least.

    Raises:
        InputError: no bench has the names that the user states, or none can be fed.
    """
    choices = [_fed(bench, evidence, is_stated) for bench in _having(candidates, evidence)]
    best, *others = sorted(choices, key=lambda c: c.order)
    if not (best.measured if is_stated else best.driven):
        raise InputError(_nothing_fits(best, evidence))
    as_good = [c for c in others if c.order[0] <= best.order[0]]
    moving = {column.name for column in best.moving_lengths.values()}
    freer = [c for c in others if moving and _lets_go(c, best, moving)]
    alternatives = dict.fromkeys(c.ports.name for c in (*freer[:1], *as_good))
    inputs, outputs = (
        {n: _with_rivals(c, evidence, best, n) for n, c in side.items()}
        for side in (best.inputs, best.outputs)
    )
    freest = freer[0].ports.name if freer else ""
    return replace(
        best, inputs=inputs, outputs=outputs, alternatives=tuple(alternatives)[:3], freer=freest
    )


def _lets_go(other: BenchChoice, best: BenchChoice, moving: set[str]) -> bool:
    """Whether a bench reads the lengths that the best one imposes although they move, and is fed as well."""
    is_fed = other.driven and len(other.unfed) <= len(best.unfed)
    read = {column.name for column in other.outputs.values()}
    return is_fed and moving <= read and other.order[0] < best.order[0] + _BODILESS


def _having(candidates: Sequence[Ports], evidence: Evidence) -> list[Ports]:
    """The benches that have every name that the user states.

    Raises:
        InputError: there is none.
    """
    named = [name for name in (*evidence.requested, *evidence.formulas) if name != "time"]
    inputs = [name for name in evidence.stated_names if "." not in name]
    able = [bench for bench in candidates if {*named} <= {*bench.inputs, *bench.outputs}]
    fixed = [bench for bench in able if {*inputs} <= {*bench.inputs}]
    if fixed or (able and len(candidates) == 1):
        return fixed or able  # a model that the user states may have parameters without a dot
    variables = dict.fromkeys(n for bench in candidates for n in (*bench.inputs, *bench.outputs))
    unknown = [name for name in (*named, *inputs) if name not in variables]
    name = [*unknown, *named, *inputs, ""][0]
    beside = "" if unknown or not able else f" together with {listed(named)}"
    hint = did_you_mean(name, variables)
    raise InputError(f"no bench has an input or output {shown(name)}{beside}; {hint}")


def _fed(bench: Ports, evidence: Evidence, is_stated: bool) -> BenchChoice:
    """A bench with the columns that feed it best, and what that costs."""
    headings = evidence.headings
    reserved = used_in(evidence)  # by formulas of the user
    signals = [c for c in evidence.signals if c.name not in reserved]
    runs = len(evidence.sources)
    complete = [c for c in signals if len(c.values) == runs and c.is_complete]
    inputs, far_inputs = _assign(bench.inputs, complete, evidence)
    readable = _readable(bench, headings)
    remaining = [c for c in signals if c not in inputs.values()]
    outputs, far_outputs = _assign(readable, remaining, evidence)
    used = [*outputs.values(), *inputs.values()]
    fed = {*inputs, *evidence.formulas, *evidence.stated_names}
    unfed = tuple(name for name in bench.inputs if name not in fed and name != BRANCH)
    measured = {*outputs, *evidence.formulas} & readable.keys()
    passing = headings.with_trait("unused")
    unused = [c for c in signals if c not in used and c.kind not in passing]
    # What a run is about: all but what a supply happens to hold, and a direction.
    driving = [
        name
        for name, meaning in headings.meanings(bench.inputs).items()
        if "supply" not in meaning.roles and meaning.kind != "direction"
    ]
    # A bench without such inputs runs by itself: where more was recorded than it shows, something drove it.
    driven = not fed.isdisjoint(driving) if driving else not unused
    mechanical = _mechanical({**bench.inputs, **readable}, headings)
    bodiless = bool(mechanical) and not mechanical & {*fed, *measured}
    cost = (
        _UNUSED * sum(c.meaning not in {u.meaning for u in used} for c in unused)
        + _UNFED * len(unfed)
        + _UNDRIVEN * ((not driven) + 2 * (not measured))
        + _BODILESS * bodiless
        + _UNLIKELY * _unlikely(inputs, outputs)
        - _NAMED * sum(name == column.name for name, column in inputs.items())
        + _ISOMETRIC * _must_be_fixed(bench, used, headings)
    )
    return BenchChoice(
        bench,
        inputs,
        outputs,
        unfed,
        order=(cost, bench.rank, far_inputs + far_outputs, len(readable.keys() - measured)),
        measured=bool(measured),
        driven=driven and bool(measured),
    )


def _mechanical(variables: Mapping[str, Variable], headings: Headings) -> set[str]:
    """Those that are of a length or a force."""
    return {n for n, meaning in headings.meanings(variables).items() if meaning.kind in MECHANICAL}


def _readable(bench: Ports, headings: Headings) -> dict[str, Variable]:
    """Outputs that a recording can contain: a composed bench does not measure the quantities that it imposes."""
    imposed = {*headings.meanings(bench.inputs).values()} if bench.parts else ()
    return {n: v for n, v in bench.outputs.items() if headings.variable(v) not in imposed}


def _assign(
    variables: Mapping[str, Variable], columns: Sequence[RecordedColumn], evidence: Evidence
) -> tuple[dict[str, RecordedColumn], float]:
    """The best column for each variable, and how far round about that is; stated ones first."""
    headings, by_name = evidence.headings, {c.name: c for c in evidence.columns}
    requested = {n: by_name[evidence.requested[n]] for n in variables if n in evidence.requested}
    taken = {n: _as_variable(column, variables[n], headings) for n, column in requested.items()}
    remaining = [c for c in columns if c.name not in evidence.requested.values()]
    cost = 0.0
    for name, meaning in headings.meanings(variables).items():
        if name in taken or name in evidence.formulas:
            continue
        free = [c for c in remaining if c not in taken.values()]
        distance, column = _nearest(name, meaning, free)
        if column is not None:
            taken[name], cost = column, cost + distance
    return taken, cost


def _as_variable(column: RecordedColumn, variable: Variable, headings: Headings) -> RecordedColumn:
    """A column that the user assigns to a variable; a unit of another kind is never guessed."""
    if column.written_unit or column.unknown or (column.unit and not column.why):
        return column
    bare, meaning = replace(column, unit="", why=()), headings.variable(variable)
    if variable.unit in ("", "1") or column.words:
        return bare
    if column.unit and alike(column.unit, variable.unit):
        return column
    usual = headings.usual_unit(str(meaning), column.largest) if meaning else None
    if usual and alike(usual, variable.unit):
        return bare.taken_as(usual)
    why = f"{NO_UNIT}; it is taken as the model's, {variable.unit}"
    return bare.because(why, unit=variable.unit)


def _nearest(
    name: str, meaning: Meaning, columns: Sequence[RecordedColumn]
) -> tuple[float, RecordedColumn | None]:
    """The column that fits a variable best, and its distance from that variable's meaning.

    Of columns that are as far, the one of that name; one that moves; the best known; the one that moves most; the
    first.
    """
    distances = [(_distance(column.meaning, meaning), column) for column in columns]
    least = min((distance for distance, _ in distances), default=inf)
    if least == inf:
        return 0.0, None
    rivals = [column for distance, column in distances if distance == least]

    def rank(rival: RecordedColumn) -> tuple[bool, bool, float, float]:
        moved = _span_in(rivals[0].unit, rival)
        return rival.name != name, not rival.moves, -rival.known_share, -moved

    return least, min(rivals, key=rank)


def _span_in(unit: str, column: RecordedColumn) -> float:
    """The span of a column, in a unit if it can be converted: of two, the one that moves more is the muscle's."""
    extent = span(column.samples)
    with suppress(UnitError):
        return float(convert(extent, column.unit, unit, difference=True))
    return extent


def _distance(column: Meaning, variable: Meaning) -> float:
    """The distance of a column's meaning from a variable's; infinite: it cannot be that variable."""
    if not column or column.roles != variable.roles:
        return inf
    if column == variable:
        return 0.0
    contractions = {"length": 1.0, "ratio": 2.0} if variable.kind == "contraction" else {}
    return contractions.get(column.kind, inf)


def _unlikely(inputs: Mapping[str, RecordedColumn], outputs: Mapping[str, RecordedColumn]) -> float:
    """How many columns are imposed that do not look so, or read that do.

    A length that follows the pressure is one that the muscle moved.
    """
    used = [*outputs.values(), *inputs.values()]
    pressure = next((c for c in used if c.meaning in (PRESSURE, SET_PRESSURE)), None)
    read = [c for c in outputs.values() if c.kind in MECHANICAL]
    imposed = [c for c in inputs.values() if c.kind in MECHANICAL]
    held = [c for c in read if _held(c, pressure)]
    moved = [c for c in imposed if not _held(c, pressure)]
    doubt = len(held) + sum(0.5 if c.kind == "force" else 0.4 for c in moved)
    doubt += sum(_follows(c, pressure) for c in moved if c.kind in LENGTHS and not c.points)
    return doubt + (0.5 if len(read) > 1 and not held else 0.0)


def _held(column: RecordedColumn, pressure: RecordedColumn | None) -> bool:
    """Whether a column is held, and not just at rest where the pressure is."""
    return column.held and not _follows(column, pressure)


def _follows(column: RecordedColumn, pressure: RecordedColumn | None) -> bool:
    """Whether a column is correlated with the pressure."""
    if pressure is None:
        return False
    return abs(correlation(pressure.values, column.values)) >= LEAST_CORRELATION


def _must_be_fixed(bench: Ports, used: Sequence[RecordedColumn], headings: Headings) -> bool:
    """Whether a pull changes and no length is recorded: the end of the muscle is fixed then."""
    imposed = headings.meanings(bench.inputs).values()
    kinds = {c.kind for c in used} | {meaning.kind for meaning in imposed}
    return kinds.isdisjoint(LENGTHS) and any(c.of("force") and not c.held for c in used)


def _with_rivals(
    column: RecordedColumn, evidence: Evidence, best: BenchChoice, name: str
) -> RecordedColumn:
    """The column with a remark that other columns may be meant instead."""
    alike_ones = [c.name for c in evidence.columns if c.meaning == column.meaning]
    rivals = [shown(n) for n in alike_ones if n not in {c.name for c in best.fed.values()}]
    if not rivals or name in evidence.requested:
        return column
    return column.because(
        f"its name fits best or it varies most; {listed(rivals)} may be meant instead"
    )


def _nothing_fits(nearest: BenchChoice, evidence: Evidence) -> str:
    columns = [c for c in evidence.columns if not c.of("time")]
    recognised = [c for c in columns if c.meaning]
    example = _example(nearest, [c for c in columns if c.values], evidence)
    hint = f"state what columns are{example}, or the bench, --model NAME ('pam-cosim bench --list')"
    if not recognised:
        why = {"; ".join(c.why) for c in columns if not c.values}
        because = f" ({listed(why)})" if why else ""
        return f"no column is recognised among {listed(c.name for c in columns)}{because}; {hint}"
    lacks = f"the inputs {listed(nearest.unfed)}" if nearest.unfed else "a measured output"
    if nearest.measured and not nearest.unfed:
        fed = {c.name for c in nearest.fed.values()}
        over = [c.name for c in recognised if c.name not in fed]
        ignored = [*over, "none"][0]
        lacks = (
            f"what {listed(over)} may have driven; leave that out, --recording 'ignore={ignored}'"
        )
    message = f"what is recognised, {listed(f'{c.name} ({c.meaning})' for c in recognised)}, feeds no bench"
    return f"{message}; the nearest, {nearest.ports.name}, lacks {lacks}; {hint}"


def _example(nearest: BenchChoice, filled: Sequence[RecordedColumn], evidence: Evidence) -> str:
    """An example of --column, with a column that may be a variable of the nearest bench; else ""."""
    taken = {c.name for c in nearest.fed.values()}
    variables = {**nearest.ports.inputs, **nearest.ports.outputs}
    for name in (n for n in variables if n not in {*nearest.fed, *evidence.requested}):
        meaning = evidence.headings.variable(variables[name])
        for column in (c for c in filled if c.name not in taken):
            fits = not column.unit or alike(column.unit, variables[name].unit)
            if column.meaning == meaning or (not column.meaning and fits):
                return f", as --column {name}={shown(column.name)}"
    return ""
