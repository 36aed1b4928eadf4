"""The finished runs of a sweep, in a store: the next start finds what a stop of any kind leaves."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.store import Store


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
    """The runs of a sweep in a store; a context manager that keeps the store open unless an error ends it.

    Args:
        path: of the file, which is continued where it is there; None: the runs are kept for this process alone.
        identity: what the sweep is, by names a person understands; a file of another sweep is refused.
        runs: how many there are to make.
        scalars: how many numbers of each run.
        outputs: how many variables of each run; 0: none are kept.
        times: how many values of each of them.

    Raises:
        InputError: as ``Store``.
    """

    def __init__(
        self,
        path: Path | None,
        identity: Mapping[str, Any],
        runs: int,
        scalars: int,
        outputs: int,
        times: int,
    ) -> None:
        self._store = Store(path, "sweep", identity)
        self._scalars = np.full((runs, scalars), np.nan)
        self._shape = outputs, times
        self._texts: dict[int, list[str]] = {}  # of each run: the failure and the warnings
        for key, content in self._store.items():
            self._note(int.from_bytes(key, "big"), content)

    def __enter__(self) -> Records:
        return self

    def __exit__(self, problem: object, *_: object) -> None:
        if problem is None:
            self._store.release()
        else:
            self._store.close()

    def _note(self, run: int, content: bytes) -> None:
        """Reads what stays in memory: everything but the values over time."""
        texts, scalars, values = _parts(content, self._scalars.shape[1])
        failed = bool(texts[0])
        if run < len(self._scalars) and values.size == (
            0 if failed else self._shape[0] * self._shape[1]
        ):
            self._texts[run], self._scalars[run] = texts, scalars

    def add(self, rows: Sequence[RunResult]) -> None:
        """Keeps finished runs.

        Raises:
            InputError: the disk is full, or not there any more; the runs before are kept.
        """
        contents = {row.run: _content(row) for row in rows}
        self._store.add((_key(run), content) for run, content in contents.items())
        for run, content in contents.items():
            self._note(run, content)

    def __len__(self) -> int:
        return len(self._scalars)

    @property
    def missing(self) -> list[int]:
        """Numbers of the runs that are still to make."""
        return [run for run in range(len(self)) if run not in self._texts]

    @property
    def done(self) -> int:
        """How many runs are kept."""
        return len(self._texts)

    def failure(self, run: int) -> str:
        """Why a run failed; empty where it did not."""
        return self._texts[run][0]

    def failures(self) -> list[str]:
        """Of all runs."""
        return [self.failure(run) for run in range(len(self))]

    def warnings(self) -> list[list[str]]:
        """Of the model, in each run."""
        return [self._texts[run][1:] for run in range(len(self))]

    def scalars(self) -> Array:
        """(runs, scalars)."""
        return self._scalars

    def values(self, run: int) -> Array:
        """(outputs, times) of one run, from the disk; NaN where it failed.

        Raises:
            InputError: they were damaged since they were written.
        """
        content = self._store.get(_key(run))
        if content is None:
            raise InputError("was damaged; make the sweep again", self._store.path)
        values = _parts(content, self._scalars.shape[1])[2]
        return values.reshape(self._shape) if values.size else np.full(self._shape, np.nan)

    def output(self, i: int) -> Array:
        """(runs, times) of one output."""
        values = np.empty((len(self), self._shape[1]))
        for run in range(len(self)):
            values[run] = self.values(run)[i]
        return values


def _key(run: int) -> bytes:
    return run.to_bytes(8, "big")


def _content(row: RunResult) -> bytes:
    values = b"" if row.values is None else row.values.astype("<f8").tobytes()
    texts = json.dumps([row.failure, *row.warnings]).encode()
    return texts + b"\n" + row.scalars.astype("<f8").tobytes() + values


def _parts(content: bytes, scalars: int) -> tuple[list[str], Array, Array]:
    """The failure and the warnings, the scalars, and the values over time in one row."""
    texts, _, numbers = content.partition(b"\n")
    values = np.frombuffer(numbers, "<f8")
    return json.loads(texts), values[:scalars], values[scalars:]
