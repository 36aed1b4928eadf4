"""What a command loads before it works: by the number of modules, which is the same on every machine."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest

from pam_cosim import study
from tests.cli.conftest import ROOT

SCRIPT = """
import json, sys
from pam_cosim.cli.process import run
try:
    run()
finally:
    print(json.dumps(sorted(sys.modules)), file=sys.stderr)
"""
PICTURES = {"matplotlib"}
VESSEL = str(ROOT / "examples" / "tank-discharge")
STATISTICS = {"scipy.stats"}  # half a second to load
MEASUREMENTS = {"scipy", "pint", "pandas", "h5py", "xarray", "pam_cosim.measurement", *PICTURES}
COMPILERS = {"pam_cosim.compiler", "pam_cosim.sweeps", "casadi", *MEASUREMENTS}
FMU = "an .fmu that was built here"
WORDS = {"rich", "pydantic"}
# a run of an FMU of our own takes no more processor time than one by FMPy: docs/results.md
READERS = {"fmpy", "lxml", "attr", "csv", "html", "xml.etree", "importlib.metadata"}
NUMBERS = {"numpy", "casadi", "fmpy", *MEASUREMENTS}


def loaded(*words: str) -> set[str]:
    """Names of the modules that a command has loaded at its end."""
    command = [sys.executable, "-c", SCRIPT, *words]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    completed = subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=120
    )
    assert completed.returncode == 0, completed.stderr
    return set(json.loads(completed.stderr.splitlines()[-1]))


@pytest.mark.parametrize(
    ("words", "without", "most"),
    [
        (["--version"], NUMBERS | WORDS, 300),  # 211 when this was written
        (["describe", "TankFilling"], MEASUREMENTS, 700),  # 551
        (["simulate", "VesselOrifice"], PICTURES, 1500),  # 1389
        (["simulate", FMU], COMPILERS | WORDS | READERS, 360),  # 329
        *(
            pytest.param([word, VESSEL], {*PICTURES, *STATISTICS}, 1600, marks=pytest.mark.full)
            for word in ("compare", "fit", "predict")  # 1551 at most
        ),
    ],
    ids=lambda value: value[0] if isinstance(value, list) else None,
)
def test_a_command_loads_only_what_it_needs(words: list[str], without: set[str], most: int) -> None:
    for model in words[1:]:
        known = "VesselOrifice" if model in (VESSEL, FMU) else model
        built = study.build(known)
        study.describe(known)  # both are in the cache after that
    modules = loaded(*(str(built) if word == FMU else word for word in words))
    assert not without & modules
    assert len(modules) < most
