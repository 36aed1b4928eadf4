"""Libraries that are loaded after the first of their kind have the functions and types that FMPy gives them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import fmpy
import pytest
from fmpy.fmi2 import FMU2Model, FMU2Slave

from pam_cosim.fmu.read import read_description
from pam_cosim.simulation import instance
from tests.fmu import models


def _types(made: Any) -> Mapping[str, tuple[Any, ...]]:
    return {name: (f.argnames, tuple(f.argtypes), f.restype) for name, f in made._functions.items()}


@pytest.mark.parametrize("exchange", [False, True])
def test_types_of_a_second_library_are_those_of_fmpy(tmp_path: Path, exchange: bool) -> None:
    first, path = models.fmu(models.lag), models.fmu(models.oscillator)
    instance.load_instance(first, read_description(first), str(tmp_path / "a"), exchange=exchange)
    description = read_description(path)
    second = instance.load_instance(path, description, str(tmp_path / "b"), exchange=exchange)
    fmpy.extract(str(path), unzipdir=str(tmp_path / "c"))
    theirs = (FMU2Model if exchange else FMU2Slave)(
        guid=description.guid,
        unzipDirectory=str(tmp_path / "c"),
        modelIdentifier=description.coSimulation.modelIdentifier,
    )
    assert _types(second) == _types(theirs)
    assert all(getattr(second.dll, name) is f for name, f in second._functions.items())
