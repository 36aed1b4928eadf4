"""Libraries that are loaded after the first of their kind have the functions and types that FMPy gives them."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import closing
from pathlib import Path
from typing import Any

import fmpy
import pytest
from fmpy.fmi2 import FMU2Model, FMU2Slave

from pam_cosim.fmu.read import read_description
from pam_cosim.simulation import Simulator, instance
from tests.fmu import models


def _types(made: Any) -> Mapping[str, tuple[Any, ...]]:
    return {name: (f.argnames, tuple(f.argtypes), f.restype) for name, f in made._functions.items()}


def _loaded(path: Path, folder: Path, exchange: bool) -> Any:
    made = instance.load_instance(path, read_description(path), str(folder), exchange=exchange)
    return made if exchange else made.with_steps()


@pytest.mark.parametrize("exchange", [False, True])
def test_types_of_a_second_library_are_those_of_fmpy(tmp_path: Path, exchange: bool) -> None:
    first, path = models.fmu(models.lag), models.fmu(models.oscillator)
    _loaded(first, tmp_path / "a", exchange)
    description = read_description(path)
    second = _loaded(path, tmp_path / "b", exchange)
    fmpy.extract(str(path), unzipdir=str(tmp_path / "c"))
    theirs = (FMU2Model if exchange else FMU2Slave)(
        guid=description.guid,
        unzipDirectory=str(tmp_path / "c"),
        modelIdentifier=description.coSimulation.modelIdentifier,
    )
    assert _types(second) == _types(theirs)
    assert all(getattr(second.dll, name) is f for name, f in second._functions.items())


@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
def test_library_is_unloaded_with_the_instance_that_made_steps(fmi: str) -> None:
    path = models.fmu(models.breaks_down, fmi)
    with Simulator(path) as simulator:
        with closing(simulator.stepper()) as stepper:
            stepper.begin({})
        folder = simulator._directory
        assert folder and folder in _maps()
    assert folder not in _maps()


def _maps() -> str:
    file = Path("/proc/self/maps")
    if not file.exists():
        pytest.skip("the system does not list loaded libraries")
    return file.read_text()
