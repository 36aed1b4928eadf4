"""The runs of a sweep that are done, in a file that grows: what a stop of any kind leaves, the next start finds.

The file is a line of JSON, which says of what sweep it is, and a record of fixed size for each run. A record that was
cut off by the stop is not one.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError

_MARK = "pam-cosim sweep 2"
_LONGEST_REASON = 1000  # bytes of why a run failed, and of its warnings
_LONGEST_HEAD = 10_000_000


@dataclass(frozen=True)
class RunResult:
    """What is kept of one run.

    Attributes:
        run: its number, from 0.
        scalars: (scalars,); NaN where the run failed.
        values: (outputs, times) or None where they are not kept.
        failure: why it failed; empty where it did not.
        warnings: of the model.
    """

    run: int
    scalars: Array
    values: Array | None
    failure: str = ""
    warnings: tuple[str, ...] = ()


class Records:
    """The file of a sweep; a context manager.

    Args:
        path: of the file; one that is there is gone on with.
        identity: what the sweep is, by names a person understands; a file of another sweep is refused.
        runs: how many there are to make.
        scalars: how many numbers of each run.
        outputs: how many variables of each run; 0: none are kept.
        times: how many values of each of them.

    Raises:
        InputError: the file is of another sweep, of none, or in use.
    """

    def __init__(
        self,
        path: Path,
        identity: Mapping[str, Any],
        runs: int,
        scalars: int,
        outputs: int,
        times: int,
    ) -> None:
        self.path, self.runs = path, runs
        self.kind = np.dtype(
            [
                ("run", "<i8"),
                ("failure", f"S{_LONGEST_REASON}"),
                ("warnings", f"S{_LONGEST_REASON}"),
                ("scalars", "<f8", (scalars,)),
                ("values", "<f8", (outputs, times)),
            ]
        )
        head = {"format": _MARK, **identity}
        self._count = 0
        self._file: BinaryIO = _opened(path)
        new = self._size() == 0
        try:
            self._offset = self._begin(head)
        except BaseException as problem:
            self._close(remove=new)
            if isinstance(problem, OSError):
                raise InputError(f"cannot be written: {problem.strerror}", path) from None
            raise
        self._count = (self._size() - self._offset) // self.kind.itemsize
        self._file.truncate(self._offset + self._count * self.kind.itemsize)
        self._file.seek(0, os.SEEK_END)
        self._place = np.full(runs, -1, dtype=np.int64)  # of each run's record
        self._known = 0
        self._look()

    def __enter__(self) -> Records:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Ends the writing; one that holds no run is removed."""
        if not self._file.closed:
            self._close(remove=self._count == 0)

    def _close(self, remove: bool) -> None:
        with suppress(OSError):  # the disk is full, which was said before
            self._file.close()
        if remove:
            self.path.unlink(missing_ok=True)

    def _size(self) -> int:
        return os.fstat(self._file.fileno()).st_size

    def _begin(self, head: Mapping[str, Any]) -> int:
        """Writes the first line, or compares it with what is there; where the records begin."""
        if self._size() == 0:
            line = json.dumps(head, allow_nan=False).encode() + b"\n"
            self._file.write(line)
            self._file.flush()
            return len(line)
        self._file.seek(0)
        line = self._file.readline(_LONGEST_HEAD)
        try:
            kept = json.loads(line)
        except ValueError:
            kept = None
        if not isinstance(kept, dict) or kept.get("format") != _MARK:
            raise InputError(
                "is not what a sweep leaves when it is stopped; remove it or name another result",
                self.path,
            )
        other = [name for name in dict.fromkeys([*head, *kept]) if head.get(name) != kept.get(name)]
        if other:
            raise InputError(
                f"is left of another sweep: {', '.join(other)} differ; remove it or name another result",
                self.path,
            )
        return len(line)

    def add(self, rows: Sequence[RunResult]) -> None:
        """Writes runs that are done; on the disk when this returns.

        Raises:
            InputError: the disk is full, or not there any more; the runs before are kept.
        """
        records = np.zeros(len(rows), self.kind)
        for record, row in zip(records, rows, strict=True):
            record["run"], record["failure"] = row.run, _cut(row.failure)
            record["warnings"] = _cut("\n".join(row.warnings))
            record["scalars"] = row.scalars
            record["values"] = np.nan if row.values is None else row.values
        try:
            self._file.write(records.tobytes())
            self._file.flush()
        except OSError as problem:
            raise InputError(f"cannot be written: {problem.strerror}", self.path) from None
        for i, row in enumerate(rows):
            self._place[row.run] = self._count + i
        self._count += len(rows)

    def _look(self) -> None:
        if self._count:
            places = self._mapped()["run"]
            good = (places >= 0) & (places < self.runs)
            self._place[places[good]] = np.flatnonzero(good)

    def _mapped(self) -> NDArray[Any]:
        return np.memmap(self.path, self.kind, "r", self._offset, (self._count,))

    @property
    def missing(self) -> list[int]:
        """Numbers of the runs that are still to make."""
        return [int(i) for i in np.flatnonzero(self._place < 0)]

    @property
    def done(self) -> int:
        """How many runs are kept."""
        return int(np.count_nonzero(self._place >= 0))

    def table(self) -> SweepRuns:
        """All runs, once none is missing; stays readable when the file is removed."""
        return SweepRuns(self._mapped(), self._place.copy())


@dataclass(frozen=True)
class SweepRuns:
    """The runs in their order; numbers stay on the disk until they are asked for."""

    records: NDArray[Any]
    place: NDArray[np.int64]

    def failure(self, run: int) -> str:
        """Why a run failed; empty where it did not."""
        return bytes(self.records["failure"][self.place[run]]).decode("utf-8", "replace")

    def failures(self) -> list[str]:
        """Of all runs."""
        return self._texts("failure")

    def warnings(self) -> list[list[str]]:
        """Of the model, in each run."""
        return [text.splitlines() for text in self._texts("warnings")]

    def _texts(self, field: str) -> list[str]:
        return [
            text.decode("utf-8", "replace") for text in self.records[field][self.place].tolist()
        ]

    def scalars(self) -> Array:
        """(runs, scalars)."""
        return np.asarray(self.records["scalars"][self.place])

    def values(self, run: int) -> Array:
        """(outputs, times) of one run."""
        return np.array(self.records["values"][self.place[run]])

    def output(self, i: int) -> Array:
        """(runs, times) of one output."""
        return np.asarray(self.records["values"][:, i, :][self.place])


def _cut(text: str) -> bytes:
    return text.encode()[:_LONGEST_REASON].decode("utf-8", "ignore").encode()


def _opened(path: Path) -> BinaryIO:
    """The file for this process alone.

    Raises:
        InputError: it cannot be written, or another process has it.
    """
    try:
        flags = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
        file = os.fdopen(os.open(path, flags, 0o666), "r+b")
    except OSError as problem:
        raise InputError(f"cannot be written: {problem.strerror}", path) from problem
    with suppress(ImportError):  # Windows has another lock
        import fcntl

        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            file.close()
            raise InputError("another sweep is writing this", path) from None
    return file
