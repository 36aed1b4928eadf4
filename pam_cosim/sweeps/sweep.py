"""Makes the runs of a sweep, and continues one that was stopped."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import Inputs
from pam_cosim.sweeps.design import Design
from pam_cosim.sweeps.executors import run_all
from pam_cosim.sweeps.names import FAILURE, RUN, TIME
from pam_cosim.sweeps.records import Records, RunResult
from pam_cosim.sweeps.result import Sweep
from pam_cosim.sweeps.scalars import Scalar
from pam_cosim.sweeps.task import SweepJob

PARTIAL = ".partial"  # ends the name of the file that a sweep leaves when it is stopped


@dataclass(frozen=True)
class SweepPlan:
    """What a sweep is to make.

    Attributes:
        fmu: the model.
        interface: of the model.
        design: which runs.
        fixed: further values of all runs [SI].
        inputs: of all runs, over time.
        times: (n,) [s] of the values of each run.
        outputs: variables that are kept over time.
        scalars: numbers to make of each run.
        keep: whether values over time are kept.
        foreign: whether another tool made the FMU.
        timeout: of such an FMU [s].
    """

    fmu: Path
    interface: Interface
    design: Design
    fixed: dict[str, float]
    inputs: Inputs | None
    times: Array
    outputs: tuple[str, ...]
    scalars: tuple[Scalar, ...]
    keep: bool
    foreign: bool
    timeout: float | None

    def __post_init__(self) -> None:
        for name in self.design.names:
            if name in self.fixed:
                raise InputError(f"'{name}' is both set and varied; keep one of them")
            if self.inputs is not None and name in self.inputs.values:
                raise InputError(
                    f"the input '{name}' is given over time and varied; keep one of them"
                )
        self._check_patterns()
        self._check_scalars()
        if not self.keep and not self.scalars:
            raise InputError(
                "a sweep that keeps no trajectories needs a scalar of each run, such as max(T)"
            )

    def _check_patterns(self) -> None:
        if self.design.patterns and self.inputs is not None:
            raise InputError("inputs over time are both given and varied; keep one of them")
        held = [*self.fixed, *self.design.names]
        for pattern in self.design.patterns:
            twice = next((name for name in pattern.inputs.values if name in held), None)
            if twice is not None:
                raise InputError(
                    f"the input '{twice}' is in '{pattern.name}' and given otherwise; keep one of them"
                )

    def _check_scalars(self) -> None:
        """Each has a name of its own in the result."""
        taken = {name: "what is varied" for name in self.design.names}
        taken |= {name: "a variable that is kept over time" for name in self.outputs if self.keep}
        taken |= {name: "a column of every sweep" for name in (FAILURE, RUN, TIME)}
        for scalar in self.scalars:
            if scalar.name in taken:
                raise InputError(
                    f"a scalar has the name of {taken[scalar.name]}, '{scalar.name}'; give it another"
                )

    def identity(self) -> dict[str, Any]:
        """What distinguishes this sweep from others; numbers by their bytes."""
        patterns = [[p.name, _digest(_bytes_of(p.inputs))] for p in self.design.patterns]
        return {
            "model": {"name": self.interface.model, "file": _digest(self.fmu.read_bytes())},
            "varied": {
                "design": self.design.kind,
                **self.design.units,
                "values": _digest(self.design.points.tobytes()),
            },
            "settings": dict(sorted(self.fixed.items())),
            "inputs": None if self.inputs is None else _digest(_bytes_of(self.inputs)),
            **({"patterns": patterns} if patterns else {}),
            "times": _digest(self.times.tobytes()),
            "outputs": list(self.outputs) if self.keep else None,
            "scalars": [[s.name, s.function, s.variable, s.argument] for s in self.scalars],
        }

    def job(self) -> SweepJob:
        """The same for a process that makes runs."""
        return SweepJob(
            self.fmu,
            None,
            self.foreign,
            self.timeout,
            self.times,
            self.design.names,
            self.fixed,
            self.inputs,
            self.outputs,
            self.scalars,
            self.keep,
            tuple(p.inputs for p in self.design.patterns),
        )


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:32]


def _bytes_of(inputs: Inputs) -> bytes:
    parts = [inputs.interpolation.encode(), inputs.time.tobytes()]
    for name in sorted(inputs.values):
        parts += [name.encode(), inputs.values[name].tobytes()]
    return b"\0".join(parts)


def partial_of(result: Path) -> Path:
    """The file next to a result that keeps the runs of an unfinished sweep."""
    return result.with_name(result.name + PARTIAL)


def make_sweep(
    plan: SweepPlan,
    result: Path | None = None,
    *,
    executor: Any = None,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Sweep:
    """Makes the runs that are not there yet.

    Args:
        plan: the sweep.
        result: the file of the result; a file next to it keeps the runs until ``Sweep.save`` has written the result.
            None: they are kept until the sweep is forgotten.
        executor: where runs are made, as ``executors.run_all``.
        workers: how many, as ``executors.run_all``.
        progress: called with the number of runs that are kept, and of all.

    Raises:
        InputError: runs of another sweep are kept there; no such executor.
        SimulationFailure: a process that makes runs ended; what was made is kept.
    """
    count, outputs = len(plan.design), len(plan.outputs) if plan.keep else 0
    path = None if result is None else partial_of(result)
    times = plan.times.size if plan.keep else 0
    with Records(path, plan.identity(), count, len(plan.scalars), outputs, times) as records:

        def say(rows: Sequence[RunResult]) -> None:
            records.add(rows)
            if progress is not None:
                progress(records.done, count)

        if progress is not None:
            progress(records.done, count)
        if missing := records.missing:
            run_all(plan.job(), missing, plan.design.points, executor, workers, say)
    sweep = Sweep(
        plan.interface,
        plan.design,
        plan.fixed,
        plan.times,
        plan.outputs if plan.keep else (),
        plan.scalars,
        records,
    )
    sweep.partial = path
    return sweep


def same(first: Sweep, second: Sweep) -> bool:
    """Whether two sweeps hold the same numbers, to the last bit; NaN is equal to NaN."""
    equal = np.array_equal(first.table.scalars(), second.table.scalars(), equal_nan=True)
    equal = equal and first.table.failures() == second.table.failures()
    return equal and all(
        np.array_equal(first.table.output(i), second.table.output(i), equal_nan=True)
        for i in range(len(first.outputs))
    )
