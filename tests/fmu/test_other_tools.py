"""FMUs and systems in the tools of others; one that is not here is skipped, and ``scripts/other_tools`` brings it.

Tools need versions of packages that exclude one another, so that ``PAM_COSIM_TOOLS`` names the interpreters that have
them, and each runs as a process. ``PAM_COSIM_OMC`` names the OpenModelica compiler, where it is not found as ``omc``.
"""

from __future__ import annotations

import csv
import json
import os
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from tests.cosimulation.systems import halves

pytestmark = pytest.mark.full
VERSIONS = ["2.0", "3.0"]
_LONGEST = 300.0  # [s] of a tool


@cache
def _interpreter(module: str) -> str | None:
    named = [p for p in os.environ.get("PAM_COSIM_TOOLS", "").split(os.pathsep) if p]
    for python in (sys.executable, *named):
        if not subprocess.run([python, "-c", f"import {module}"], capture_output=True).returncode:
            return python
    return None


def _told(module: str, script: str, *words: object) -> Any:
    """What a script for a tool prints as JSON after the word TOLD."""
    python = _interpreter(module)
    if python is None:
        pytest.skip(f"there is no {module}; scripts/other_tools installs it")
    command = [python, "-c", script, *map(str, words)]
    run = subprocess.run(command, capture_output=True, text=True, timeout=_LONGEST, check=False)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    told = [line for line in run.stdout.splitlines() if line.startswith("TOLD ")]
    return json.loads(told[-1].removeprefix("TOLD "))


_GEMSEO = """
import json, sys
from gemseo_fmu.disciplines.fmu_discipline import FMUDiscipline
names = ["load.m", "u_in", "u_out", "p_supply"]
discipline = FMUDiscipline(sys.argv[1], input_names=names, output_names=["p", "x"], initial_time=0.0, final_time=2.0,
                           time_step=0.01, use_co_simulation=True)
data = discipline.execute({})
print("TOLD", json.dumps({name: float(data[name][-1]) for name in ("p", "x")}))
"""


@pytest.mark.parametrize("fmi", VERSIONS)
def test_gemseo_takes_a_parameter_as_a_design_variable(fmi: str) -> None:
    told = _told("gemseo_fmu", _GEMSEO, pam.build("Isotonic", fmi=fmi))
    own = pam.simulate("Isotonic", stop_time=2.0, interval=0.01)
    for name, value in told.items():
        assert value == pytest.approx(own[name][-1], rel=1e-9)


_STATIC = """
import json, sys
from gemseo_fmu.disciplines.static_fmu_discipline import StaticFMUDiscipline
print("TOLD", json.dumps(float(StaticFMUDiscipline(sys.argv[1]).execute()["F"][-1])))
"""


def test_gemseo_runs_a_static_model() -> None:
    force = _told("gemseo_fmu", _STATIC, pam.build("StaticForce"))
    assert force == pytest.approx(pam.simulate("StaticForce", stop_time=1.0)["F"][-1], rel=1e-12)


_PATHSIM = """
import json, sys
from pathsim import Connection, Simulation
from pathsim.blocks import Constant, Scope
from pathsim_fmi import CoSimulationFMU
fmu, scope = CoSimulationFMU(sys.argv[1], start_values={"load.m": 5.0}, dt=0.01), Scope()
drives = [Constant(0.35), Constant(0.0), Constant(207e3)]
wires = [Connection(drive, fmu[i]) for i, drive in enumerate(drives)]
Simulation([fmu, scope, *drives], [*wires, Connection(fmu[1], scope[0])], dt=0.01, log=False).run(2.0)
print("TOLD", json.dumps(float(scope.read()[1][0][-1])))
"""


@pytest.mark.parametrize("fmi", VERSIONS)
def test_pathsim_runs_it_as_a_block(fmi: str) -> None:
    told = _told("pathsim_fmi", _PATHSIM, pam.build("Isotonic", fmi=fmi))
    own = pam.simulate("Isotonic", {"load.m": 5.0}, stop_time=2.01, interval=0.01)
    assert told == pytest.approx(own["x"][-1], rel=1e-5)  # its scope shows the end of the step


@pytest.mark.parametrize("fmi", VERSIONS)
def test_the_manipulation_toolbox_finds_no_fault(fmi: str) -> None:
    python = _interpreter("fmu_manipulation_toolbox")
    if python is None:
        pytest.skip("there is no fmu_manipulation_toolbox; scripts/other_tools installs it")
    command = [
        python,
        "-m",
        "fmu_manipulation_toolbox",
        "-input",
        str(pam.build("Isotonic", fmi=fmi)),
        "-check",
    ]
    run = subprocess.run(command, capture_output=True, text=True, timeout=_LONGEST, check=False)
    told = run.stdout + run.stderr
    assert f"compliant with FMI-{fmi}" in told and "No semantic error" in told


_LIBCOSIM = """
import json, sys
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimObserver import CosimObserver
run = CosimExecution.from_ssp_file(sys.argv[1], step_size=1_000_000)
seen = CosimObserver.create_last_value()
run.add_observer(seen)
run.simulate_until(target_time=500_000_000)
slave = run.slave_index_from_instance_name("muscle")
print("TOLD", json.dumps(list(seen.last_real_values(slave, [int(sys.argv[2])]))))
"""


def _written(folder: Path, **options: Any) -> Path:
    system = halves(muscle__load__m="5 kg", gas__u_in=0.3)
    return pam.write_system(system, folder / "halves.ssp", **options)


def test_libcosim_couples_a_written_system(tmp_path: Path) -> None:
    import fmpy

    muscle = fmpy.read_model_description(str(pam.build("CoSimulation.MuscleAndLoad")))
    x = next(v.valueReference for v in muscle.modelVariables if v.name == "x")
    told = _told("libcosimpy", _LIBCOSIM, _written(tmp_path, connectors=False), x)
    system = halves(muscle__load__m="5 kg", gas__u_in=0.3)
    own = system.simulate(0.5, step="1 ms", method="jacobi", extrapolation="constant")
    assert told[0] == pytest.approx(own.trajectory["muscle.x"][-1], rel=1e-9)


_ECOS = """
import json, sys
from ecospy import EcosSimulation
with EcosSimulation(step_size=1e-3, ssp_path=sys.argv[1]) as run:
    run.init(parameter_set="initialValues")
    run.step(500)
    print("TOLD", json.dumps([run.get_real(name) for name in ("muscle::load.m", "gas::u_in", "muscle::x")]))
"""


def test_ecos_couples_a_written_system(tmp_path: Path) -> None:
    mass, current, x = _told("ecospy", _ECOS, _written(tmp_path, connectors=False))
    system = halves(muscle__load__m="5 kg", gas__u_in=0.3)
    own = system.simulate(0.5, step="1 ms", method="jacobi", extrapolation="constant")
    assert (mass, current) == (5.0, 0.3)
    assert x == pytest.approx(own.trajectory["muscle.x"][-1], rel=0.01)  # it exchanges a step later


_SOFIRPY = """
import json, sys
from pathlib import Path
from sofirpy import simulate
wires = {"muscle": [("p", "gas", "p")], "gas": [(name, "muscle", name) for name in ("V", "V_flow", "A")]}
keys = ("parameter_name", "connect_to_system", "connect_to_external_parameter")
table = simulate(stop_time=0.5, step_size=1e-3, fmu_paths={"gas": Path(sys.argv[1]), "muscle": Path(sys.argv[2])},
    connections_config={to: [dict(zip(keys, wire)) for wire in found] for to, found in wires.items()},
    start_values={"muscle": {"load.m": 5.0}, "gas": {"u_in": 0.3}}, parameters_to_log={"muscle": ["x"]})
print("TOLD", json.dumps(float(table["muscle.x"].iloc[-1])))
"""


def test_sofirpy_couples_two() -> None:
    x = _told("sofirpy", _SOFIRPY, *_halves("2.0"))
    own = _coupled("jacobi")
    assert x == pytest.approx(
        own["muscle.x"][-1], rel=1e-5
    )  # it takes the first step with start values


_COFMUPY = """
import json, sys
from cofmupy import Coordinator
folder, starts = sys.argv[3], json.loads(sys.argv[4])
paths = {"gas": sys.argv[1], "muscle": sys.argv[2]}
fmus = [{"id": name, "path": path, "initialization": starts[name]} for name, path in paths.items()]
ends = [("gas", "muscle", "p"), *(("muscle", "gas", name) for name in ("V", "V_flow", "A"))]
wires = [{"source": {"id": a, "variable": name}, "target": {"id": b, "variable": name}} for a, b, name in ends]
file = f"{folder}/system.json"
with open(file, "w") as text:
    json.dump({"fmus": fmus, "connections": wires, "cosim_method": "jacobi", "iterative": False, "root": ""}, text)
run = Coordinator()
run.start(file)
for _ in range(500):
    run.do_step(1e-3)
print("TOLD", json.dumps(float(run.get_results()["muscle", "x"][-1])))
"""


@pytest.mark.parametrize("fmi", VERSIONS)
def test_cofmupy_couples_two(fmi: str, tmp_path: Path) -> None:
    own = _coupled("jacobi")
    gas = {name: own[f"muscle.{name}"][0] for name in ("V", "V_flow", "A")}
    gas |= {"u_in": 0.3, "u_out": 0.0, "p_supply": 207e3}  # an input without a value begins at zero
    starts = {"gas": gas, "muscle": {"p": own["gas.p"][0], "load.m": 5.0}}
    x = _told("cofmupy", _COFMUPY, *_halves(fmi), tmp_path, json.dumps(starts))
    assert x == pytest.approx(own["muscle.x"][-1], rel=1e-12)


def _halves(fmi: str) -> list[Path]:
    return [pam.build(f"CoSimulation.{name}", fmi=fmi) for name in ("ValveAndGas", "MuscleAndLoad")]


def _coupled(method: str) -> pam.Trajectory:
    system = halves(muscle__load__m="5 kg", gas__u_in=0.3)
    return system.simulate(0.5, step="1 ms", method=method, extrapolation="constant").trajectory


_PYSSP = """
import json, sys
from pyssp_standard.ssp import SSP
with SSP(sys.argv[1]) as archive:
    with archive.system_structure as read:
        print("TOLD", json.dumps([read.name, sorted(one.name for one in read.system.connectors)]))
"""


@pytest.mark.parametrize("version", ["1.0", "2.0"])
def test_pyssp_reads_a_written_system(version: str, tmp_path: Path) -> None:
    name, connectors = _told("pyssp_standard", _PYSSP, _written(tmp_path, ssp=version))
    assert name == "system" and {"u_in", "p_supply", "x", "p"} <= set(connectors)


_STANDARD = """
package Modelica
  package Blocks
    package Interfaces
      connector RealInput = input Real;
      connector RealOutput = output Real;
    end Interfaces;
  end Blocks;
end Modelica;
"""
_IMPORT = """
loadFile("Modelica.mo"); getErrorString();
importFMU("Isotonic.fmu"); getErrorString();
loadFile("PneumaticMuscle_Benches_Isotonic_me_FMU.mo"); getErrorString();
loadString("model Drive PneumaticMuscle_Benches_Isotonic_me_FMU fmu; equation fmu.u_in=0.35; fmu.u_out=0;
 fmu.p_supply=207000; end Drive;"); getErrorString();
simulate(Drive, stopTime=10, numberOfIntervals=1000, tolerance=1e-8, outputFormat="csv"); getErrorString();
"""
_LINKED = {"lapack": ("lapack", "z", "expat"), "blas": ("blas",)}


def _linkable(folder: Path) -> None:
    """Names that the linker finds for libraries of which the machine has no files for developers."""
    known = subprocess.run(["ldconfig", "-p"], capture_output=True, text=True, check=True).stdout
    found = {line.split()[0]: line.split()[-1] for line in known.splitlines() if "=>" in line}
    for name, needed in _LINKED.items():
        files = [
            f for n in needed for f in (v for k, v in found.items() if k.startswith(f"lib{n}.so."))
        ]
        if files:
            (folder / f"lib{name}.so").write_text(f"INPUT({' '.join(files)})\n")


def test_openmodelica_imports_and_simulates_it(tmp_path: Path) -> None:
    omc = os.environ.get("PAM_COSIM_OMC") or shutil.which("omc")
    if not omc or not shutil.which("cc") or not shutil.which("ldconfig"):
        pytest.skip("there is no OpenModelica compiler")
    shutil.copy(pam.build("Isotonic"), tmp_path / "Isotonic.fmu")
    (tmp_path / "Modelica.mo").write_text(_STANDARD)
    (tmp_path / "import.mos").write_text(_IMPORT)
    (tmp_path / "Resources" / "Library").mkdir(parents=True)
    _linkable(tmp_path / "Resources" / "Library")
    command = [omc, "--allowNonStandardModelica=reinitInAlgorithms", "import.mos"]
    run = subprocess.run(
        command, cwd=tmp_path, capture_output=True, text=True, timeout=_LONGEST, check=False
    )
    assert (tmp_path / "Drive_res.csv").exists(), (run.stdout + run.stderr)[-3000:]
    with (tmp_path / "Drive_res.csv").open() as file:
        heads, *rows = csv.reader(file)
    table = np.array(rows, dtype=float)
    own = pam.simulate("Isotonic", {"u_in": 0.35, "u_out": 0, "p_supply": 207e3}, stop_time=10)
    for name in ("p", "x", "T"):
        theirs = np.interp(own.time, table[:, 0], table[:, heads.index(f"fmu.{name}")])
        assert np.max(np.abs(theirs - own[name])) < 5e-7 * np.ptp(own[name]), name
