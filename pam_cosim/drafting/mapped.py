"""Recordings under the names of the bench, and the entries of ``[columns]`` that make them so."""

from __future__ import annotations

from dataclasses import dataclass, field

from pam_cosim.arrays import Array
from pam_cosim.drafting.rest import Rest


@dataclass(frozen=True)
class ColumnEntry:
    """One key of ``[columns]``: ``column``, ``unit``, ``formula``, ``gain``, ``offset`` as stated; ``zero`` in seconds.

    Attributes:
        zero: by recording.
        words: of a direction, up, down or none by the words of the column.
        held: one value for each recording [SI], of which the name of its file tells: no column has it.
        why: what was guessed, in sentences.
    """

    name: str
    column: str | None = None
    unit: str | None = None
    formula: str | None = None
    gain: str | None = None
    offset: str | None = None
    zero: dict[int, tuple[float, float]] = field(default_factory=dict)
    why: tuple[str, ...] = ()
    words: dict[str, str] = field(default_factory=dict)
    held: dict[int, float] = field(default_factory=dict)


@dataclass(frozen=True)
class MappedRecording:
    """One recording under the bench's names.

    Attributes:
        time: (n,) [s].
        inputs, outputs: (n,) each, in the bench's units.
        rest: where nothing moves, first to last.
    """

    time: Array
    inputs: dict[str, Array]
    outputs: dict[str, Array]
    rest: tuple[Rest, ...]

    @property
    def every(self) -> dict[str, Array]:
        """All of them."""
        return {**self.inputs, **self.outputs}

    @property
    def first_rest(self) -> Rest | None:
        """The rest that it begins with, where it does."""
        return self.rest[0] if self.rest and self.rest[0].start == 0 else None


@dataclass(frozen=True)
class Mapped:
    """Entries by the bench's names, and the recordings under them."""

    entries: dict[str, ColumnEntry]
    courses: tuple[MappedRecording, ...]
