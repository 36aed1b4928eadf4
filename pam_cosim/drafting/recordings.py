"""The files of a lab as tables: numbers, words for directions, remarks, and one table for each experiment."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from pydantic import ValidationError

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.headings import Headings
from pam_cosim.errors import InputError
from pam_cosim.measurement.cell_kinds import are_switch_words, says_time_of_day
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.measurement.formats import is_text, read_table
from pam_cosim.measurement.matlab_table import scalars_of
from pam_cosim.measurement.pieces import going_on, usual_step
from pam_cosim.measurement.run_names import matches
from pam_cosim.measurement.table import Layout, Table, split_heading
from pam_cosim.measurement.text_file import read_any_text
from pam_cosim.measurement.text_table import text_columns
from pam_cosim.measurement.wrapped_clocks import with_clocks_going_on
from pam_cosim.units import convert
from pam_cosim.wording import did_you_mean, shown

MISSING = ("nan", "na", "n/a", "#n/a", "null", "none", "missing", "-", "--", "---")
"""Words that stand where a sample is missing, in small letters."""
_STATED = re.compile(r'\b(?!names)(\w+) = (?:\[?"([^"]+)"|(\d+))')
_MOST_WORDS = 3  # up, down, and neither
_MOST_REMARKS = 40  # lines above the rows that are looked at


@dataclass(frozen=True)
class Part:
    """One of several experiments in a file: its number, from one on, and the times [s] between which it lies."""

    number: int
    begin: float | None
    end: float | None


@dataclass(frozen=True)
class Source:
    """One recording.

    Attributes:
        texts: headings of columns of text, which are left out.
        labels: the cells of those that hold the same in every row.
        part: which one of its file, where that holds several experiments.
        clocks: headings of columns of text whose cells hold times of day in a way that is not read.
        words: of the columns whose cells are words for directions: the words by heading. Their numbers in the table are
            places in that list.
        remarks: lines above the rows, and numbers of a file that are no columns, as texts.
        loggers: files of other loggers, whose columns it has too.
        is_merged: its rows are not those of the file, which has several clocks: it is written again.
    """

    file: Path
    table: Table
    texts: tuple[str, ...] = ()
    words: dict[str, tuple[str, ...]] = field(default_factory=dict)
    labels: tuple[str, ...] = ()
    clocks: tuple[str, ...] = ()
    part: Part | None = None
    remarks: tuple[str, ...] = ()
    loggers: tuple[Path, ...] = ()
    is_merged: bool = False

    @property
    def name(self) -> str:
        """Name of the run, unless files are renamed."""
        return self.file.stem if self.part is None else f"{self.file.stem} part {self.part.number}"

    @property
    def count(self) -> int:
        """How many rows it has."""
        return len(next(iter(self.table.columns.values())).values)


def places_of(name: str, sources: Sequence[Source], option: str = "") -> list[int]:
    """The places of the recordings of a name, that of one or of a file of which they are parts.

    Raises:
        InputError: there is none; it begins with the ``option``.
    """
    called = [
        i
        for i, source in enumerate(sources)
        if any(matches(label, name) for label in (source.name, source.file.stem, source.file.name))
    ]
    if not called:
        hint = did_you_mean(name, [source.name for source in sources])
        raise InputError(f"{option}there is no recording {shown(name)}; {hint}")
    return called


def recording_table(settings: Mapping[str, object]) -> RecordingTable:
    """The table ``[recording]`` as the user states it.

    Raises:
        InputError: there is no such key, or its value cannot be used.
    """
    keys = [name for name in RecordingTable.model_fields if name != "resample"]
    for name in (name for name in settings if name not in keys):
        hint = did_you_mean(name, keys)
        raise InputError(f"there is no key {shown(name)} of [recording]; {hint}")
    try:
        return RecordingTable.model_validate({n: _setting(n, v) for n, v in settings.items()})
    except ValidationError as error:
        problem = error.errors(include_url=False)[0]
        raise InputError(
            f"[recording] {problem['loc'][0]}: {shown(problem['input'])} cannot be used: {problem['msg']}"
        ) from None


def _setting(name: str, value: object) -> object:
    """A number of a line; a list as it is written with commas, or as ``experiment.toml`` has it."""
    if name.endswith("_line") and str(value).isdecimal():
        return int(str(value))
    if name not in ("names", "ignore", "missing") or not isinstance(value, str):
        return value
    if value.strip().startswith("["):
        with suppress(tomllib.TOMLDecodeError):
            return tomllib.loads(f"list = {value}")["list"]
    return [part.strip() for part in value.split(",")]


def read_sources(files: Sequence[Path], stated: RecordingTable, headings: Headings) -> list[Source]:
    """Reads every file; columns of text are left out, but for those of a direction or a switch.

    Raises:
        InputError: as the readers, with file, line and column.
    """
    layout = stated.layout()
    layout = replace(layout, missing=layout.missing.union(MISSING))
    with _options_in_messages():
        texts = [text_columns(file, layout) if is_text(file) else {} for file in files]
        words = _directions(texts, headings)
        pairs = zip(files, texts, strict=True)
        return with_loggers([_source(f, layout, t, words, headings) for f, t in pairs], headings)


def with_loggers(sources: list[Source], headings: Headings) -> list[Source]:
    """The recordings, of which files of several loggers are one for each run.

    Their names have the same numbers, and but for the time they have no column of each other: ``daq-01`` and
    ``camera-01``.
    """
    loggers: dict[str, dict[str, Source]] = {}
    for source in sources:
        runs = loggers.setdefault(re.sub(r"\d+", "#", source.file.stem), {})
        runs["-".join(re.findall(r"\d+", source.file.stem))] = source
    first, *others = loggers.values()
    heads = [
        {
            n
            for s in runs.values()
            for n, c in s.table.columns.items()
            if not headings.says_time(n, c.unit)
        }
        for runs in loggers.values()
    ]
    apart = sum(map(len, heads)) == len(set().union(*heads))
    if (
        not others
        or "" in first
        or not apart
        or any(runs.keys() != first.keys() for runs in others)
    ):
        return sources
    return [_beside(source, [runs[run] for runs in others]) for run, source in first.items()]


def _beside(first: Source, others: Sequence[Source]) -> Source:
    """A recording with the columns of other loggers, each behind its clock."""
    sources = (first, *others)
    columns, rows = dict(first.table.columns), max(source.count for source in sources)
    for source in others:
        logger = " ".join(re.findall(r"[^\W\d_]+", source.file.stem))
        for name, column in source.table.columns.items():
            called = f"{logger} {name}" if name in columns else name
            columns[called] = replace(column, name=called, heading=called, place=len(columns))
    for name, column in columns.items():
        values = np.append(column.values, np.full(rows - len(column.values), np.nan))
        columns[name] = replace(column, values=values)
    return replace(
        first,
        table=replace(first.table, columns=columns, lines=None),
        texts=tuple(text for source in sources for text in source.texts),
        words={name: words for source in sources for name, words in source.words.items()},
        labels=tuple(label for source in sources for label in source.labels),
        remarks=tuple(remark for source in sources for remark in source.remarks),
        loggers=tuple(source.file for source in others),
        is_merged=True,
    )


def _directions(
    texts: Sequence[dict[str, tuple[str, ...]]], headings: Headings
) -> dict[str, tuple[str, ...]]:
    """The different words of each column of directions, in all files together."""
    words: dict[str, tuple[str, ...]] = {}
    for heading in dict.fromkeys(heading for t in texts for heading in t):
        cells = tuple(dict.fromkeys(c.casefold() for t in texts for c in t.get(heading, ())))
        named = headings.read(heading, "").meaning.kind == "direction"
        if len(cells) <= _MOST_WORDS and (named or all(map(headings.direction_word, cells))):
            words[heading] = cells
    return words


def _source(
    file: Path,
    layout: Layout,
    texts: dict[str, tuple[str, ...]],
    words: dict[str, tuple[str, ...]],
    headings: Headings,
) -> Source:
    left_out = [h for h, cells in texts.items() if h not in words and not are_switch_words(cells)]
    file_words = {heading: cells for heading, cells in words.items() if heading in texts}
    codes = {h: {cell: float(i) for i, cell in enumerate(cells)} for h, cells in file_words.items()}
    table = read_table(file, replace(layout, ignore=(*layout.ignore, *left_out), words=codes))
    clocks = [
        h
        for h in left_out
        if layout.keeps(h, h)
        and (
            all(map(says_time_of_day, texts[h])) or headings.says_time(*(split_heading(h) or (h,)))
        )
    ]
    return Source(
        file,
        with_clocks_going_on(table),
        texts=tuple(left_out),
        words=file_words,
        labels=tuple(texts[h][0] for h in left_out if len(texts[h]) == 1),
        clocks=tuple(clocks),
        remarks=_remarks(file, layout, table),
    )


def _remarks(file: Path, layout: Layout, table: Table) -> tuple[str, ...]:
    """The lines above the header of a text, and the single numbers of another file, as "name: value"."""
    if file.suffix.casefold() == ".mat":
        return tuple(
            f"{name.replace('_', ' ')}: {value:g}" for name, value in scalars_of(file).items()
        )
    if not is_text(file):
        return ()
    text, _ = read_any_text(file, layout.encoding, layout.table)
    lines = text.splitlines()[:_MOST_REMARKS]
    marked = [line for line in lines if line.lstrip()[:1] in ("#", "%")]
    above = lines[: table.header_line - 1] if table.header_line else []
    return tuple(line.strip(" #%\t") for line in dict.fromkeys([*marked, *above]))


@contextmanager
def _options_in_messages() -> Iterator[None]:
    """Adds to an error the option of this command for a key of ``[recording]``."""
    try:
        yield
    except InputError as error:
        here = ""
        if "header is missing" in error.message:
            here = " (here: --recording 'names=time [s],p [kPa]', a name for each column)"
        elif "[recording]" in error.message:
            key = _STATED.search(error.message)
            setting = shown(f"{key[1]}={key[2] or key[3]}") if key else "KEY=VALUE"
            here = f" (here: --recording {setting})"
        message = f"{error.message}{here}"
        raise InputError(message, error.file, error.line, error.column) from None


# ---- files in which the time restarts: several experiments that a logger wrote into one file -------------------------


def in_parts(sources: Sequence[Source], name: str, unit: str) -> list[Source]:
    """The recordings, of which those that hold several experiments are one for each.

    Args:
        sources: recordings.
        name: of the column of time.
        unit: of its numbers.
    """
    return [part for source in sources for part in _parts_of(source, name, unit)]


def _parts_of(source: Source, name: str, unit: str) -> list[Source]:
    column = source.table.columns.get(name)
    first = _first_rows(column.values) if column else [0]
    if column is None or len(first) < 2:
        return [source]
    time = going_on(column.values, "split")
    middle = [float(convert(time[k - 1 : k + 1].mean(), unit, "s")) for k in first[1:]]
    columns = {**source.table.columns, name: replace(column, values=time)}
    table = replace(source.table, columns=columns)
    rows, borders = pairwise([*first, len(time)]), pairwise([None, *middle, None])
    return [
        replace(source, table=table.rows(slice(*ends)), part=Part(number, *between))
        for number, (ends, between) in enumerate(zip(rows, borders, strict=True), 1)
    ]


def _first_rows(time: Array) -> list[int]:
    """Where each experiment begins: the time goes back to its beginning, and on; elsewhere a cell is wrong."""
    steps = np.diff(time)
    first = [0, *(np.flatnonzero(steps < 0.0) + 1).tolist()]
    lengths = np.diff([*first, len(time)])
    begins = time[first] <= time[0] + usual_step(steps)
    enough = lengths >= CRITERIA.noise.fewest_samples
    return first if bool(np.all(begins) and np.all(enough)) else [0]
