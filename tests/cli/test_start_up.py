"""What a command loads before it works: by the number of modules, which is the same on every machine."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from typer import BadParameter, Context
from typer.main import get_command

from pam_cosim import study
from pam_cosim.cli.app import COMMANDS, app
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


@pytest.mark.full
@pytest.mark.parametrize("module", ["server", "worker"])
def test_the_workbench_loads_no_pictures(module: str) -> None:
    """Neither its server nor the process in which it fits; a report loads them when it is asked for."""
    script = (
        f"import json, sys, pam_cosim.workbench.{module}; print(json.dumps(sorted(sys.modules)))"
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    told = subprocess.run(
        [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True
    )
    assert not {"matplotlib", "jinja2"} & set(json.loads(told.stdout))


@pytest.mark.parametrize(
    ("words", "without", "most"),
    [
        (["--version"], NUMBERS | WORDS, 300),  # 211 when this was written
        (["describe", "TankFilling"], MEASUREMENTS, 700),  # 551
        (["simulate", "VesselOrifice"], PICTURES, 1500),  # 1389
        (["simulate", FMU], COMPILERS | WORDS | {"importlib.metadata"}, 420),  # 372
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


@pytest.mark.parametrize("readable", [True, False])
def test_values_are_those_that_typer_makes(
    readable: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of each parameter of each command, which go the short way where they are texts or paths."""
    coercions = pytest.importorskip("typer._coercion")  # of typer 0.29
    file = tmp_path / "3"
    file.write_text("")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(os, "access", lambda *_: readable)
    group: Any = get_command(app)
    kinds = set()
    for name in COMMANDS:
        command = group.commands[name]
        context = Context(command)
        for parameter in command.get_params(context):
            many = parameter.multiple or parameter.nargs == -1
            for value in (None, "3", "4"):
                given = value and ((value, value) if many or parameter.nargs == 2 else value)
                made = [
                    _made(partial(coercion.coerce, given, parameter, context))
                    for coercion in (
                        parameter.get_runtime_param(),
                        coercions.build_runtime_param(parameter.type_descriptor),
                    )
                ]
                assert made[0] == made[1] and type(made[0]) is type(made[1])
                kinds.add(type(made[0]))
    assert {str, type(file), list, float} <= kinds


def _made(make: Callable[[], object]) -> object:
    try:
        return make()
    except BadParameter as refusal:
        return refusal.message
