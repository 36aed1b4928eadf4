"""The process behind ``IsolatedSimulator``: pickled requests in, pickled answers out."""

from __future__ import annotations

import os
import pickle
import sys
from pathlib import Path
from typing import Any, BinaryIO

from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.simulation.simulator import Simulator


def _private_output() -> BinaryIO:
    """Standard output for the answers alone; what the FMU prints goes to standard error."""
    channel = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    return channel


def _answer(simulators: list[Simulator], path: Path, request: dict[str, Any]) -> tuple[str, Any]:
    try:
        if not simulators:
            simulators.append(Simulator(path))
        return "trajectory", simulators[0].run(**request)
    except (InputError, SimulationFailure) as error:
        return "error", error


def main(path: Path) -> None:
    """Answers requests until the input ends."""
    channel = _private_output()
    simulators: list[Simulator] = []
    while True:
        try:
            request = pickle.load(sys.stdin.buffer)
        except EOFError:
            break
        pickle.dump(_answer(simulators, path, request), channel)
        channel.flush()
    for simulator in simulators:
        simulator.close()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
