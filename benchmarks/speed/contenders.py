"""The solvers that are compared. Each prepares itself once; a call is one run that returns the outputs."""

from __future__ import annotations

import contextlib
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import casadi as ca
import fmpy
import numpy as np
from fmpy.simulation import instantiate_fmu, simulate_fmu
from numpy.typing import NDArray

from benchmarks.speed.cases import Case
from pam_cosim.simulation import Simulator

Array = NDArray[np.float64]
Run = Callable[[], Array]

# A million steps between two output points is as good as no limit.
_MANY_STEPS = 1_000_000


@contextlib.contextmanager
def pam_cosim(case: Case) -> Iterator[Callable[[float], Run]]:
    """This project: its FMU with its solver, in its compiled loop."""
    with Simulator(case.fmu) as simulator:

        def prepare(tolerance: float) -> Run:
            def run() -> Array:
                trajectory = simulator.run(
                    case.times, inputs=case.inputs, outputs=case.outputs, tolerance=tolerance
                )
                return np.stack([trajectory[name] for name in case.outputs], axis=1)

            return run

        yield prepare


@contextlib.contextmanager
def fmpy_run(case: Case, kind: str) -> Iterator[Callable[[float], Run]]:
    """FMPy's ``simulate_fmu`` on the same FMU, unpacked and instantiated beforehand, reset before each run.

    Args:
        case: what to simulate.
        kind: "ModelExchange" (CVode) or "CoSimulation" (the FMU's own solver).
    """
    folder = fmpy.extract(str(case.fmu))
    description = fmpy.read_model_description(folder)
    instance = instantiate_fmu(folder, description, kind)
    signals = _signals(case)

    def prepare(tolerance: float) -> Run:
        def run() -> Array:
            instance.reset()
            result = simulate_fmu(
                folder, validate=False, stop_time=case.end, relative_tolerance=tolerance, fmi_type=kind,
                output_interval=case.end / case.count, record_events=False, input=signals, output=case.outputs,
                model_description=description, fmu_instance=instance,
            )  # fmt: skip
            return np.stack([result[name] for name in case.outputs], axis=1)

        return run

    try:
        yield prepare
    finally:
        instance.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)


def _signals(case: Case) -> NDArray[Any] | None:
    if case.inputs is None:
        return None
    names = list(case.inputs.values)
    signals = np.empty(
        case.inputs.time.size, dtype=[("time", float), *((name, float) for name in names)]
    )
    signals["time"] = case.inputs.time
    for name in names:
        signals[name] = case.inputs.values[name]
    return signals


@contextlib.contextmanager
def casadi_cvodes(case: Case, inputs: str = "controls") -> Iterator[Callable[[float], Run]]:
    """CasADi's CVODES with the exact Jacobian, on the same equations compiled to C.

    The states are divided by their nominal values, because CasADi takes one absolute tolerance for all.

    Args:
        case: what to simulate.
        inputs: "controls": the lines as controls of one integrator, held from output point to output point;
            "restarts": a fresh start of CVODES where a line ends; "table": samples looked up at any time.
    """
    with tempfile.TemporaryDirectory(prefix="pam-cosim-speed-") as folder:
        right, measured = _compiled(case, Path(folder))
        begins, values, slopes = case.lines()
        at = _piece(begins, case.times)
        u_outputs = (values[at] + slopes[at] * (case.times - begins[at])[:, None]).T
        outputs = measured.map(case.times.size)
        make = {"controls": _with_controls, "restarts": _with_restarts, "table": _with_table}[
            inputs
        ]

        def prepare(tolerance: float) -> Run:
            options = {"reltol": tolerance, "abstol": tolerance, "max_num_steps": _MANY_STEPS}
            states = make(case, right, options)

            def run() -> Array:
                return np.asarray(
                    outputs(case.times[None, :], states(), u_outputs, case.parameters)
                ).T

            return run

        yield prepare


def _piece(begins: Array, times: Array) -> NDArray[np.intp]:
    """Which line holds from each time on."""
    return np.clip(np.searchsorted(begins, times + 1e-9, side="right") - 1, 0, None)


def _line(case: Case, t: ca.MX) -> tuple[ca.MX, ca.MX]:
    """A symbol for begin, value and slope of a line, and the inputs at time t on it."""
    m = case.ode.u.numel()
    control = ca.MX.sym("line", 2 * m + 1)
    return control, control[:m] + control[m : 2 * m] * (t - control[2 * m])


def _with_controls(case: Case, right: ca.Function, options: dict[str, Any]) -> Callable[[], ca.DM]:
    begins, values, slopes = case.lines()
    piece = _piece(begins, case.times[:-1])
    t, z, p = (
        ca.MX.sym("t"),
        ca.MX.sym("z", case.nominals.size),
        ca.MX.sym("p", case.parameters.size),
    )
    control, u = _line(case, t)
    controls = np.vstack((values[piece].T, slopes[piece].T, begins[piece]))
    dae = {"t": t, "x": z, "u": control, "p": p, "ode": right(t, z, u, p)}
    return _one_integrator(case, dae, {"u": controls}, options)


def _with_table(case: Case, right: ca.Function, options: dict[str, Any]) -> Callable[[], ca.DM]:
    t, z, p = (
        ca.MX.sym("t"),
        ca.MX.sym("z", case.nominals.size),
        ca.MX.sym("p", case.parameters.size),
    )
    dae = {"t": t, "x": z, "p": p, "ode": right(t, z, _table(case)(t), p)}
    return _one_integrator(case, dae, {}, options)


def _one_integrator(
    case: Case, dae: dict[str, ca.MX], given: dict[str, Array], options: dict[str, Any]
) -> Callable[[], ca.DM]:
    solver = ca.integrator("solver", "cvodes", dae, 0.0, list(case.times[1:]), options)
    start = case.start / case.nominals
    return lambda: ca.horzcat(start, solver(x0=start, p=case.parameters, **given)["xf"])


def _with_restarts(case: Case, right: ca.Function, options: dict[str, Any]) -> Callable[[], ca.DM]:
    """One integrator for each length of line, in time since its begin; all lines alike go in one call.

    Only for cases whose lines begin at output points.
    """
    begins, values, slopes = case.lines()
    t, z, p = (
        ca.MX.sym("t"),
        ca.MX.sym("z", case.nominals.size),
        ca.MX.sym("p", case.parameters.size),
    )
    control, u = _line(case, t)
    ends = np.append(begins[1:], case.end)
    # t counts from the begin of the line.
    here = ca.substitute(u, t, t + control[-1])
    dae = {"t": t, "x": z, "p": ca.vertcat(control, p), "ode": right(t + control[-1], z, here, p)}
    counts = np.rint((ends - begins) / (case.end / case.count)).astype(int)
    given = np.vstack((values.T, slopes.T, begins, np.tile(case.parameters[:, None], begins.size)))
    solvers = {
        n: ca.integrator(f"solver{n}", "cvodes", dae, 0.0, list(case.times[1 : n + 1]), options)
        for n in sorted(set(counts.tolist()))
    }
    start = case.start / case.nominals
    if len(solvers) == 1 and counts[0] == 1:
        z0, q = ca.MX.sym("z0", start.size), ca.MX.sym("q", given.shape[0])
        step = ca.Function("step", [z0, q], [solvers[1](x0=z0, p=q)["xf"]])
        every = step.mapaccum(begins.size)
        return lambda: ca.horzcat(start, every(start, given))

    def run() -> ca.DM:
        pieces = [ca.DM(start)]
        for n, q in zip(counts, given.T, strict=True):
            pieces.append(solvers[n](x0=pieces[-1][:, -1], p=q)["xf"])
        return ca.horzcat(*pieces)

    return run


def _table(case: Case) -> ca.Function:
    """The samples as a function of time [s]; only for inputs without steps."""
    begins, values, slopes = case.lines()
    last = values[-1] + slopes[-1] * (case.end - begins[-1])
    looked_up = ca.interpolant(
        "table", "linear", [np.append(begins, case.end)], np.vstack((values, last)).ravel()
    )
    t = ca.MX.sym("t")
    return ca.Function("u", [t], [looked_up(t)])


def _compiled(case: Case, folder: Path) -> tuple[ca.Function, ca.Function]:
    """dz/dt and the outputs with their first derivatives as machine code, by the compiler that builds the FMUs."""
    ode = case.ode
    z = ca.SX.sym("z", case.nominals.size)
    known = [ode.t, z, ode.u, ode.p]
    right, measured = (
        ca.Function(name, known, ca.cse([ca.substitute(value, ode.x, z * case.nominals)]))
        for name, value in (("right", ode.derivatives / case.nominals), ("measured", ode.outputs))
    )
    generator = ca.CodeGenerator("equations", {"with_header": False})
    for function in (right, right.jacobian(), right.forward(1), measured):
        generator.add(function)
    generator.generate(f"{folder}/")
    library = folder / ("equations.dll" if sys.platform == "win32" else "equations.so")
    command = [sys.executable, "-m", "ziglang", "cc", "-std=c99", "-O2", "-shared", "-fPIC", "-w", "-fno-math-errno",
               "-fno-sanitize=undefined", "-o", str(library), str(folder / "equations.c"), "-lm"]  # fmt: skip
    subprocess.run(command, check=True, capture_output=True)
    return ca.external("right", str(library)), ca.external("measured", str(library))
