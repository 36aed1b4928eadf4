"""The runs of a study, simulated side by side: one instance of the model for each thread."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor, wait

from pam_cosim.comparison import RunComparison
from pam_cosim.fitting import Estimate, simulated
from pam_cosim.measurement import DataSet
from pam_cosim.processes.workers import processors
from pam_cosim.simulation import AnySimulator, Simulator

MOST = 4  # instances, each of which takes time to load and memory

Simulated = tuple[tuple[RunComparison, ...], dict[str, Estimate]]


class Simulators:
    """Instances of one model. The solver lets other threads go on while it works, so that as many runs advance at once.

    An FMU of somebody else's has one instance, in a process of its own.

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
        """Every run beside its samples, and the starts that were estimated; see ``fitting.simulated``.

        Raises:
            SimulationFailure: a run did not reach its end.
        """
        count = min(self._most, len(data.runs))
        while len(self._instances) < count:
            self._instances.append(self._another())
        parts = [data.runs[i::count] for i in range(count)]
        others = [
            self._threads.submit(simulated, instance, data, values, part)
            for instance, part in zip(self._instances[1:count], parts[1:], strict=True)
        ]
        try:
            made = [simulated(self.first, data, values, parts[0])]
        finally:
            wait(others)  # an instance does one thing at a time
        made += [one.result() for one in others]
        runs = tuple(made[i % count][0][i // count] for i in range(len(data.runs)))
        return runs, {name: estimate for _, starts in made for name, estimate in starts.items()}

    def close(self) -> None:
        """Frees the instances."""
        self._threads.shutdown(wait=True)
        for instance in self._instances:
            instance.close()
