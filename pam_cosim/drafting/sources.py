"""The files of a lab as tables: numbers, words for directions, and the texts that are left out."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from pam_cosim.drafting.vocabulary import direction_word, read_heading, says_time
from pam_cosim.errors import InputError
from pam_cosim.measurement.cell_kinds import are_switch_words, says_time_of_day
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.measurement.formats import is_text, read_table
from pam_cosim.measurement.run_names import matches
from pam_cosim.measurement.table import Layout, Table, split_heading
from pam_cosim.measurement.text_table import text_columns
from pam_cosim.measurement.wrapped_clocks import with_clocks_going_on
from pam_cosim.wording import did_you_mean, shown

MISSING = ("nan", "na", "n/a", "#n/a", "null", "none", "missing", "-", "--", "---")
"""Words that stand where a sample is missing, in small letters."""
_STATED = re.compile(r'\b(?!names)(\w+) = (?:\[?"([^"]+)"|(\d+))')
_MOST_WORDS = 3  # up, down, and neither


@dataclass(frozen=True)
class Part:
    """One of several experiments in a file.

    Attributes:
        number: from one on.
        begin, end: between which times it lies [s], of a time that goes on from each to the next; None: the file's own.
    """

    number: int
    begin: float | None
    end: float | None


@dataclass(frozen=True)
class RecordingSource:
    """One recording.

    Attributes:
        texts: headings of columns of text, which are left out.
        labels: the cells of those that hold the same in every row.
        part: which one of its file, where that holds several experiments.
        clocks: headings of those whose cells hold times of day in a way that is not read.
        words: of the columns whose cells are words for directions: the words by heading. Their numbers in the table are
            places in that list.
    """

    file: Path
    table: Table
    texts: tuple[str, ...] = ()
    words: dict[str, tuple[str, ...]] = field(default_factory=dict)
    labels: tuple[str, ...] = ()
    clocks: tuple[str, ...] = ()
    part: Part | None = None

    @property
    def name(self) -> str:
        """Of the run that it becomes, as far as files are not renamed."""
        return self.file.stem if self.part is None else f"{self.file.stem} part {self.part.number}"


def places_of(name: str, sources: Sequence[RecordingSource], option: str = "") -> list[int]:
    """The places of the recordings of a name, that of one or of a file of which they are parts.

    Raises:
        InputError: there is none; it begins with the ``option``.
    """
    called = [
        i
        for i, one in enumerate(sources)
        if matches(one.name, name) or matches(one.file.stem, name)
    ]
    if not called:
        known = [one.name for one in sources]
        raise InputError(
            f"{option}there is no recording {shown(name)}; {did_you_mean(name, known)}"
        )
    return called


def read_sources(files: Sequence[Path], stated: RecordingTable) -> list[RecordingSource]:
    """Reads every file; columns of text are left out, but for those of a direction or a switch.

    Raises:
        InputError: as the readers, with file, line and column.
    """
    layout = stated.layout()
    layout = replace(layout, missing=layout.missing.union(MISSING))
    texts = [_texts(file, layout) for file in files]
    words = _directions(texts)
    return [_source(file, layout, own, words) for file, own in zip(files, texts, strict=True)]


def _texts(file: Path, layout: Layout) -> dict[str, tuple[str, ...]]:
    try:
        return text_columns(file, layout) if is_text(file) else {}
    except InputError as error:
        raise _with_hint(error) from None


def _directions(texts: Sequence[dict[str, tuple[str, ...]]]) -> dict[str, tuple[str, ...]]:
    """The different words of each column that tells a direction, in all files together."""
    words: dict[str, tuple[str, ...]] = {}
    for heading in dict.fromkeys(heading for own in texts for heading in own):
        cells = tuple(
            dict.fromkeys(cell.casefold() for own in texts for cell in own.get(heading, ()))
        )
        meaning = read_heading(heading, "").meaning
        named = meaning is not None and meaning.kind == "direction"
        if len(cells) <= _MOST_WORDS and (named or all(map(direction_word, cells))):
            words[heading] = cells
    return words


def _source(
    file: Path, layout: Layout, texts: dict[str, tuple[str, ...]], words: dict[str, tuple[str, ...]]
) -> RecordingSource:
    left_out = tuple(
        heading
        for heading, cells in texts.items()
        if heading not in words and not are_switch_words(cells)
    )
    own = {heading: cells for heading, cells in words.items() if heading in texts}
    codes = {
        heading: {cell: float(i) for i, cell in enumerate(cells)} for heading, cells in own.items()
    }
    try:
        table = read_table(file, replace(layout, ignore=(*layout.ignore, *left_out), words=codes))
    except InputError as error:
        raise _with_hint(error) from None
    labels = tuple(texts[heading][0] for heading in left_out if len(texts[heading]) == 1)
    kept = [heading for heading in left_out if layout.keeps(heading, heading)]
    clocks = tuple(
        heading
        for heading in kept
        if all(map(says_time_of_day, texts[heading]))
        or says_time(*(split_heading(heading) or (heading, "")))
    )
    table = with_clocks_going_on(table)
    return RecordingSource(file, table, left_out, own, labels, clocks)


def _with_hint(error: InputError) -> InputError:
    """The error, saying what to type here: what stands under ``[recording]`` is said beforehand."""
    here = ""
    if "header is missing" in error.message:
        here = " (here: --recording 'names=time [s],p [kPa]', a name for each column)"
    elif "[recording]" in error.message:
        key = _STATED.search(error.message)
        said = shown(f"{key[1]}={key[2] or key[3]}") if key else "KEY=VALUE"
        here = f" (here: --recording {said})"
    return InputError(f"{error.message}{here}", error.file, error.line, error.column)
