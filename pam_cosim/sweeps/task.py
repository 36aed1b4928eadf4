"""A few runs of a sweep, in whatever process they are made."""

from __future__ import annotations

import hashlib
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import SimulationFailure
from pam_cosim.simulation import AnySimulator, Inputs, IsolatedSimulator, Simulator
from pam_cosim.simulation.models import limited
from pam_cosim.sweeps.patterns import INPUTS
from pam_cosim.sweeps.records import RunResult
from pam_cosim.sweeps.scalars import Scalar


@dataclass(frozen=True)
class SweepJob:
    """What all runs of a sweep have in common; can be sent to another process, or to another machine.

    Attributes:
        fmu: the file.
        content: of the file, for a machine that may not have it; None: it is there.
        foreign: whether it is an FMU of another tool, which runs in a process of its own.
        timeout: of such an FMU, or of a run [s].
        times: (n,) [s].
        names: what is varied.
        fixed: further values [SI].
        inputs: over time.
        outputs: variables that are kept, with ``keep``.
        scalars: numbers to make of each run.
        keep: whether the values over time are kept.
        patterns: inputs over time that are varied, instead of ``inputs``.
    """

    fmu: Path
    content: bytes | None
    foreign: bool
    timeout: float | None
    times: Array
    names: tuple[str, ...]
    fixed: dict[str, float]
    inputs: Inputs | None
    outputs: tuple[str, ...]
    scalars: tuple[Scalar, ...]
    keep: bool
    patterns: tuple[Inputs, ...] = ()

    @property
    def read(self) -> list[str]:
        """All variables that are read of a run."""
        kept = self.outputs if self.keep else ()
        return list(dict.fromkeys([*kept, *(scalar.variable for scalar in self.scalars)]))


@dataclass(frozen=True)
class Batch:
    """Runs that were made together.

    Attributes:
        rows: their results.
        opening: time to open the model [s].
        running: time for the runs [s].
    """

    rows: list[RunResult]
    opening: float
    running: float


def make_runs(
    job: SweepJob, runs: Sequence[int], points: Array, seconds: float | None = None
) -> Batch:
    """Makes runs one after another; a run that fails is a row with its reason.

    Args:
        job: the sweep.
        runs: their numbers.
        points: (runs, names) what is varied [SI].
        seconds: after which no further run is begun.
    """
    begin = time.perf_counter()
    with _opened(job) as simulator:
        opened = time.perf_counter()
        rows: list[RunResult] = []
        for run, point in zip(runs, points, strict=True):
            rows.append(
                _row(job, simulator, run, dict(zip(job.names, point.tolist(), strict=True)))
            )
            if seconds is not None and time.perf_counter() - opened > seconds:
                break
        return Batch(rows, opened - begin, time.perf_counter() - opened)


def _row(job: SweepJob, simulator: AnySimulator, run: int, varied: dict[str, float]) -> RunResult:
    inputs = job.patterns[int(varied[INPUTS])] if job.patterns else job.inputs
    parameters = {
        name: value for name, value in varied.items() if not (job.patterns and name == INPUTS)
    }
    try:
        trajectory = simulator.run(
            job.times, parameters=job.fixed | parameters, inputs=inputs, outputs=job.read
        )
    except SimulationFailure as failure:
        return RunResult(
            run, np.full(len(job.scalars), np.nan), None, str(failure) or "the run failed"
        )
    values = np.stack([trajectory[name] for name in job.outputs]) if job.keep else None
    numbers = np.array([scalar.of(trajectory) for scalar in job.scalars])
    return RunResult(run, numbers, values, warnings=trajectory.warnings)


# The FMU of another tool that this process has in use: one that hangs while it is loaded is not loaded again.
_foreign: dict[tuple[Path, float | None], IsolatedSimulator] = {}


def forget_foreign() -> None:
    """Ends the processes of other people's FMUs that this process has in use."""
    while _foreign:
        _foreign.popitem()[1].close()


@contextmanager
def _opened(job: SweepJob) -> Iterator[AnySimulator]:
    if job.content is not None:
        with tempfile.TemporaryDirectory(prefix="pam-cosim-sweep-") as folder:
            fmu = Path(folder) / f"{hashlib.sha256(job.content).hexdigest()[:16]}.fmu"
            fmu.write_bytes(job.content)
            with _simulator(job, fmu) as simulator:
                yield simulator
    elif job.foreign:
        key = job.fmu, job.timeout
        if key not in _foreign:
            forget_foreign()
            _foreign[key] = IsolatedSimulator(job.fmu, job.timeout)
        yield _foreign[key]
    else:
        with _simulator(job, job.fmu) as simulator:
            yield simulator


def _simulator(job: SweepJob, fmu: Path) -> AnySimulator:
    return (
        IsolatedSimulator(fmu, job.timeout) if job.foreign else limited(Simulator(fmu), job.timeout)
    )
