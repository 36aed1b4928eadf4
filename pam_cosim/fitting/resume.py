"""The simulations of a fit in a store, so that the fit can be interrupted and continued.

Every method does the same thing every time. A fit that is continued begins again and its simulations are read from the
file until one comes that was not made; it ends where it would have without the interruption, to the last bit.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np

from pam_cosim.errors import SimulationFailure
from pam_cosim.simulation import AnySimulator, Trajectory
from pam_cosim.store import Store


class LoggedSimulator:
    """A simulator that reads runs from a file where they are there, and keeps the others in it.

    Args:
        simulator: the model.
        path: of the file; continued where it is there.

    Raises:
        InputError: as ``Store``; the file keeps simulations of another model.
    """

    def __init__(self, simulator: AnySimulator, path: Path) -> None:
        with ZipFile(simulator.path) as archive:
            equations = hashlib.sha256(archive.read("modelDescription.xml")).hexdigest()
        self._simulator = simulator
        self._store = Store(
            path, "fit", {"model": simulator.interface.model, "its equations": equations}
        )
        self.close = self._store.close

    def __getattr__(self, name: str) -> Any:
        return getattr(self._simulator, name)

    def run(self, *arguments: Any, **options: Any) -> Trajectory:
        """As ``Simulator.run``."""
        return self._logged(self._simulator.run, arguments, options)

    def equilibria(self, *arguments: Any, **options: Any) -> Trajectory:
        """As ``Simulator.equilibria``."""
        return self._logged(self._simulator.equilibria, arguments, options)

    def _logged(
        self, simulate: Callable[..., Trajectory], arguments: Any, options: Any
    ) -> Trajectory:
        request = [simulate.__name__, arguments, options]
        key = hashlib.sha256(
            json.dumps(request, sort_keys=True, default=_by_content).encode()
        ).digest()
        content = self._store.get(key)
        if content is None:
            try:
                content = _content(simulate(*arguments, **options))
            except SimulationFailure as failure:
                content = json.dumps({"failure": str(failure)}).encode()
            self._store.add([(key, content)])
        return _trajectory(content)


def _by_content(value: Any) -> Any:
    """What JSON does not know: arrays, and records that hold them."""
    if isinstance(value, np.ndarray):
        return hashlib.sha256(value.astype(float).tobytes()).hexdigest()
    return value.item() if isinstance(value, np.generic) else vars(value)


def _content(trajectory: Trajectory) -> bytes:
    words = {
        "units": trajectory.units,
        "warnings": trajectory.warnings,
        "solver": trajectory.solver,
    }
    head = {"names": list(trajectory.values), **words}
    return (
        json.dumps(head).encode()
        + b"\n"
        + np.stack([trajectory.time, *trajectory.values.values()]).tobytes()
    )


def _trajectory(content: bytes) -> Trajectory:
    line, _, numbers = content.partition(b"\n")
    head = json.loads(line)
    if "failure" in head:
        raise SimulationFailure(head["failure"])
    names = head["names"]
    time, *values = np.frombuffer(numbers).reshape(1 + len(names), -1)
    return Trajectory(
        time,
        dict(zip(names, values, strict=True)),
        head["units"],
        tuple(head["warnings"]),
        head["solver"],
    )
