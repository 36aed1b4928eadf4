"""The runs of a study, simulated side by side: one instance of the model for each thread."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass, field

from pam_cosim.comparison import RunComparison
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Estimate, simulated
from pam_cosim.measurement import DataSet, Run
from pam_cosim.processes.workers import processors
from pam_cosim.simulation import AnySimulator, Simulator

MOST = 4  # instances, each of which takes time to load and memory

RunResult = tuple[tuple[RunComparison, ...], dict[str, Estimate]] | SimulationFailure


@dataclass
class Simulated:
    """The runs of a study as a model simulates them.

    Attributes:
        runs: that reached their end, in the order of the data set.
        starts: estimated start values, by "state@run".
        failures: of the other runs, by name.
    """

    runs: tuple[RunComparison, ...] = ()
    starts: dict[str, Estimate] = field(default_factory=dict)
    failures: dict[str, SimulationFailure] = field(default_factory=dict)


class Simulators:
    """Instances of one model. The solver lets other threads go on while it works, so that as many runs advance at once.

    An FMU of another tool has one instance, in a process of its own.

    Args:
        first: an instance.
        another: makes one more.
    """

    def __init__(self, first: AnySimulator, another: Callable[[], AnySimulator]) -> None:
        self.first, self._another = first, another
        self._instances = [first]
        self._most = min(MOST, processors()) if isinstance(first, Simulator) else 1
        self._threads = ThreadPoolExecutor(MOST, thread_name_prefix="run")

    def run(self, data: DataSet, values: Mapping[str, float]) -> Simulated:
        """Simulates every run and compares it with its samples; see ``fitting.simulated``."""
        count = min(self._most, len(data.runs))
        while len(self._instances) < count:
            self._instances.append(self._another())

        def simulated_part(i: int) -> list[RunResult]:
            return [
                _simulated(self._instances[i], data, values, run) for run in data.runs[i::count]
            ]

        further_parts = [self._threads.submit(simulated_part, i) for i in range(1, count)]
        try:
            parts = [simulated_part(0)]
        finally:
            wait(further_parts)  # an instance does one thing at a time
        parts += [part.result() for part in further_parts]
        result = Simulated()
        for i, run in enumerate(data.runs):
            simulated_run = parts[i % count][i // count]
            if isinstance(simulated_run, SimulationFailure):
                result.failures[run.name] = simulated_run
            else:
                result.runs += simulated_run[0]
                result.starts.update(simulated_run[1])
        return result

    def close(self) -> None:
        """Frees the instances."""
        self._threads.shutdown(wait=True)
        for instance in self._instances:
            instance.close()


def _simulated(
    instance: AnySimulator, data: DataSet, values: Mapping[str, float], run: Run
) -> RunResult:
    try:
        return simulated(instance, data, values, [run])
    except SimulationFailure as failure:
        return failure
