"""Which bench the recordings can feed, and by which column each of its inputs and outputs."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from pam_cosim.catalogue.ports import Ports
from pam_cosim.drafting.feeding import NEAR, BenchChoice, Feed, fed_bench, meaning_of
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.errors import InputError
from pam_cosim.wording import did_you_mean, listed, shown


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
    given = Feed(columns, asked, formulas, runs, stated)
    choices = [fed_bench(one, given) for one in _having(candidates, given)]
    order = sorted(choices, key=lambda c: (c.cost, c.ports.rank, c.roundabout, c.unread))
    best = order[0]
    if not best.driven:
        raise InputError(_nothing_fits(best, columns))
    others = tuple(c.ports.name for c in order[1:] if c.cost <= best.cost or _lets_go(best, c))
    inputs, outputs = (
        {n: _among(c, columns, best, n in asked) for n, c in side.items()}
        for side in (best.inputs, best.outputs)
    )
    return replace(best, inputs=inputs, outputs=outputs, others=others[:3])


def _lets_go(best: BenchChoice, other: BenchChoice) -> bool:
    """Whether a bench reads the lengths that the best one imposes although they move, and is fed as well."""
    moving = [column.name for column in best.moving_lengths.values()]
    read = {column.name for column in other.outputs.values()}
    is_fed = other.driven and len(other.unfed) <= len(best.unfed)
    return bool(moving) and is_fed and {*moving} <= read and other.cost < best.cost + NEAR


def _having(candidates: Sequence[Ports], given: Feed) -> list[Ports]:
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


def _nothing_fits(nearest: BenchChoice, columns: Sequence[RecordedColumn]) -> str:
    known = [
        f"{c.name} ({c.meaning})" for c in columns if c.meaning is not None and not c.of("time")
    ]
    left = [c for c in columns if not c.of("time")]
    filled = [c for c in left if c.values]
    as_one = f", as --column {_example(nearest, filled)}" if filled else ""
    hint = f"say what columns are{as_one}, or the bench, --model NAME ('pam-cosim bench --list')"
    if not known:
        why = {"; ".join(c.why) for c in left if not c.values}
        because = f" ({listed(why)})" if why else ""
        return f"no column is recognised among {listed(c.name for c in left)}{because}; {hint}"
    lacks = f"the inputs {listed(nearest.unfed)}" if nearest.unfed else "a measured output"
    said = f"what is recognised, {listed(known)}, feeds no bench; the nearest, {nearest.ports.name}, lacks {lacks}"
    return f"{said}; {hint}"


def _example(nearest: BenchChoice, columns: Sequence[RecordedColumn]) -> str:
    """How to say what a column is: one that there is, for a variable of the nearest bench that it may be."""
    taken = {one.name for one in nearest.fed.values()}
    unused = [c for c in columns if c.name not in taken]
    variables = {**nearest.ports.inputs, **nearest.ports.outputs}
    alike = [
        (name, c)
        for name, variable in variables.items()
        for c in unused
        if c.meaning is not None and c.meaning == meaning_of(variable)
    ]
    lacking = [*nearest.unfed, *(name for name in variables if name not in nearest.fed)]
    unknown = [(name, c) for name in lacking for c in unused if c.meaning is None]
    name, column = next(iter([*alike, *unknown]), ("NAME", columns[0]))
    return f"{name}={shown(column.name)}"
