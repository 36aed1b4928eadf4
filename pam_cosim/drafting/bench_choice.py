"""Which bench the recordings can feed, and by which column each of its inputs and outputs."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from pam_cosim.catalogue.ports import Ports
from pam_cosim.drafting.feeding import BenchChoice, Feed, fed_bench
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
    hint = "say what columns are, as --column p='Druck 1', or the bench, --model NAME ('pam-cosim bench --list')"
    if not known:
        return f"no column is recognised among {listed(c.name for c in columns if not c.of('time'))}; {hint}"
    lacks = f"the inputs {listed(nearest.unfed)}" if nearest.unfed else "a measured output"
    said = f"what is recognised, {listed(known)}, feeds no bench; the nearest, {nearest.ports.name}, lacks {lacks}"
    return f"{said}; {hint}"
