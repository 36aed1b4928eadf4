"""Files as laboratories have them: columns, units, separators, clocks, with noise and rounding."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from strangers.physics import Array, Solved, Truth, solve
from strangers.rigs import Rig, RunPlan

FURTHER_RATES = {"camera": 30.0, "loadcell": 80.0, "thermometer": 10.0}
_PAUSE = 30.0  # between the runs of one file [s]
_MARGIN = 0.1  # before and after a recording, for clocks that differ [s]
_PSI, _INCH, _POUND = 6894.757293168, 0.0254, 4.4482216152605


@dataclass(frozen=True)
class Column:
    """How a file writes a quantity: its heading, and the number of an SI value by gain and offset."""

    quantity: str
    name: str
    unit: str
    gain: float = 1.0
    offset: float = 0.0
    digits: int = 3

    @property
    def heading(self) -> str:
        """Name and unit."""
        return f"{self.name} [{self.unit}]"

    def written(self, values: Array) -> list[str]:
        """The cells of a column."""
        return [f"{v:.{self.digits}f}" for v in (values * self.gain + self.offset).tolist()]


@dataclass(frozen=True)
class Layout:
    """A way to write files."""

    columns: dict[str, Column]
    separator: str = ","
    decimal: str = "."
    ending: str = "csv"
    encoding: str = "utf-8"
    above: tuple[str, ...] = ()
    units_row: bool = False


def layout(rig: Rig) -> Layout:
    """That of a rig."""
    return {
        "plain": _plain,
        "german": _german,
        "tabs": _tabs,
        "two": _two,
        "one file": _plain,
    }[rig.layout](rig)


def _columns(*columns: Column) -> dict[str, Column]:
    return {c.quantity: c for c in columns}


def _valves(rig: Rig, names: dict[str, tuple[str, str]]) -> tuple[Column, Column]:
    """Columns of the commands by the unit of their sheet; `names` by that unit, else by ''."""
    sheet = rig.valves
    inlet, outlet = names.get(sheet.unit, names[""])
    digits = {"A": 4, "mA": 0, "V": 2, "%": 2, "-": 0}[sheet.unit]
    one = Column("u_in", inlet, sheet.unit, sheet.full - sheet.shut, sheet.shut, digits)
    return one, replace(one, quantity="u_out", name=outlet)


def _plain(rig: Rig) -> Layout:
    return Layout(
        _columns(
            Column("time", "time", "s"),
            *_valves(rig, {"": ("u_in", "u_out"), "-": ("open_in", "open_out")}),
            Column("p", "p", "kPa", 1e-3, 0.0, 1),
            Column("x", "x", "mm", 1e3, 0.0, 2),
            Column("F", "F", "N", 1.0, 0.0, 1),
            Column("T", "T", "degC", 1.0, -273.15, 1),
            Column("s", "s", "mm", 1e3, 0.0, 3),
        )
    )


def _german(rig: Rig) -> Layout:
    names = {"": ("I_ein", "I_aus"), "V": ("U_ein", "U_aus"), "-": ("Ventil_ein", "Ventil_aus")}
    names |= {"%": ("Öffnung_ein", "Öffnung_aus")}
    return Layout(
        _columns(
            Column("time", "Zeit", "s"),
            *_valves(rig, names),
            Column("p", "p_abs", "bar", 1e-5, 1e-5 * rig.truth.p_amb, 4),
            Column("x", "Länge", "mm", -1e3, 1e3 * rig.truth.L0, 2),
            Column("F", "Kraft", "N", 1.0, 0.0, 1),
            Column("T", "T_Gas", "degC", 1.0, -273.15, 1),
            Column("s", "Schlitten", "mm", 1e3, 0.0, 3),
        ),
        separator=";",
        decimal=",",
        ending="txt",
        encoding="latin-1",
    )


def _tabs(rig: Rig) -> Layout:
    return Layout(
        _columns(
            Column("time", "Time", "ms", 1e3, 0.0, 0),
            *_valves(rig, {"": ("Cmd1", "Cmd2")}),
            Column("p", "Press", "psi", 1 / _PSI, 0.0, 3),
            Column("x", "Stroke", "in", 1 / _INCH, 0.0, 4),
            Column("F", "LoadCell", "lbf", 1 / _POUND, 0.0, 2),
            Column("T", "TC1", "degF", 1.8, -459.67, 1),
            Column("s", "Slide", "in", 1 / _INCH, 0.0, 5),
        ),
        separator="\t",
        ending="dat",
        above=("Test stand PM-2", "Filter: none", ""),
        units_row=True,
    )


def _two(rig: Rig) -> Layout:
    return Layout(
        _columns(
            Column("time", "t", "s", digits=4),
            *_valves(rig, {"": ("valve_in", "valve_out")}),
            Column("p", "pressure", "kPa", 1e-3, 0.0, 1),
            Column("x", "marker", "mm", 1e3, 0.0, 2),
            Column("F", "pull", "N", 1.0, 0.0, 1),
            Column("T", "temperature", "degC", 1.0, -273.15, 1),
            Column("s", "slide", "mm", 1e3, 0.0, 3),
        )
    )


@dataclass(frozen=True)
class Recorded:
    """A run: what each logger has, without noise and with it, and the pieces that drove it."""

    plan: RunPlan
    times: dict[str, Array]  # by logger, "" the first one; true times since the recording began
    true: dict[str, Array]  # by signal, at its logger's times
    read: dict[str, Array]  # by signal
    commands: tuple[Array, Array]
    solved: Solved


def logger_of(rig: Rig) -> Callable[[str], str]:
    """The logger that has a signal."""
    place = {signal: name for name, signals in rig.loggers.items() for signal in signals}
    return lambda signal: place.get(signal, "")


def record(
    rig: Rig, index: int, truth: Truth | None = None, like: Recorded | None = None
) -> Recorded:
    """A run of a rig; of another `truth` under the commands of a run that was recorded before.

    Raises:
        RuntimeError: the solver does not reach the end.
    """
    plan = rig.runs[index]
    first = np.arange(round((plan.end - plan.begin) * rig.rate) + 1) / rig.rate
    times = {"": first}
    for name in rig.loggers:
        rate = FURTHER_RATES[name]
        times[name] = np.arange(0.4 / rate, first[-1], 1 / rate).round(6)
    before = _MARGIN if plan.begin else 0.0
    dense = np.unique(np.concatenate([[-before], *times.values(), [first[-1] + _MARGIN]]))
    held = plan.imposed
    solved = solve(
        replace(truth or rig.truth, M=plan.M),
        plan.start,
        dense + plan.begin,
        plan.drive if like is None else like.solved.pieces,
        plan.seed,
        held if callable(held) else lambda t: held,
    )
    logger, clock = logger_of(rig), (truth or rig.truth).clock
    draw = np.random.default_rng([71, rig.number, index])
    true, read = {}, {}
    for signal, sigma in rig.sigma.items():
        at, values = times[logger(signal)], solved.readings[signal]
        # What a clock that runs ahead stamps with a time happened before it.
        late = clock if signal in ("x", "F") and logger(signal) else 0.0
        true[signal] = np.interp(at - late, dense, values) if late else _at(at, dense, values)
        noisy = true[signal] + sigma * draw.standard_normal(len(at))
        read[signal] = np.round(noisy / rig.steps[signal]) * rig.steps[signal]
    commands = (_at(first, dense, solved.u_in), _at(first, dense, solved.u_out))
    return Recorded(plan, times, true, read, commands, solved)


def _at(times: Array, dense: Array, values: Array) -> Array:
    return values[np.searchsorted(dense, times - 1e-9)]


def write(rig: Rig, runs: list[Recorded], folder: Path) -> list[list[str]]:
    """The files of all runs; for each run their names, the first logger's first."""
    form = layout(rig)
    if rig.layout == "one file":
        rows, begin = [], 0.0
        for number, run in enumerate(runs, 1):
            table = _table(rig, run, "", form, begin)
            head = ["run", *table[0]]
            rows += [[str(number), *row] for row in table[1:]]
            begin += run.plan.end - run.plan.begin + _PAUSE
        _write(folder / "all-runs.csv", [head, *rows], form)
        return [["all-runs.csv"] for _ in runs]
    names = []
    for number, run in enumerate(runs, 1):
        files = []
        for logger in run.times:
            name = f"{logger or _STEMS[rig.layout]}-{number:02d}.{form.ending}"
            _write(folder / name, _table(rig, run, logger, form, 0.0), form)
            files.append(name)
        names.append(files)
    return names


_STEMS = {"plain": "run", "german": "messung", "tabs": "test", "two": "daq"}


def parts(rig: Rig) -> Iterator[tuple[float, float]]:
    """The first and last time [s] of each run in one file of all."""
    begin = 0.0
    for plan in rig.runs:
        yield begin, begin + plan.end - plan.begin
        begin += plan.end - plan.begin + _PAUSE


def _table(rig: Rig, run: Recorded, logger: str, form: Layout, begin: float) -> list[list[str]]:
    place = logger_of(rig)
    values = {"time": run.times[logger] + begin}
    if not logger:
        values |= {"u_in": run.commands[0], "u_out": run.commands[1]}
        if callable(run.plan.imposed):
            at = (run.times[""] + run.plan.begin).tolist()
            values["s"] = np.array([run.plan.imposed(t) for t in at])
    values |= {s: v for s, v in run.read.items() if place(s) == logger}
    columns = [form.columns[q] for q in values]
    cells = [c.written(v) for c, v in zip(columns, values.values(), strict=True)]
    head = [[c.heading for c in columns]]
    if form.units_row:
        head = [[c.name for c in columns], [c.unit for c in columns]]
    return [*head, *(list(row) for row in zip(*cells, strict=True))]


def _write(file: Path, rows: list[list[str]], form: Layout) -> None:
    lines = [*form.above, *(form.separator.join(row) for row in rows)]
    text = "\n".join(lines) + "\n"
    if form.decimal == ",":
        head, _, body = text.partition("\n")
        text = head + "\n" + body.replace(".", ",")
    file.write_text(text, encoding=form.encoding, newline="\n")
