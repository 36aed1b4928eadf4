"""One 10 s run of the isotonic bench with 1000 output points, against other ways to solve the same equations.

    python -m benchmarks.speed.run                       three kinds of input, about two minutes
    python -m benchmarks.speed.run --cases steps --rounds 5

Every solver runs over a range of tolerances; its error is measured against a reference by another solver (SciPy's
DOP853, 1e-12), and its time is read off at equal error. What is done once and not for every run is not in the times:
compiling, building and unpacking the FMU, instantiation, making CasADi's integrators. The runs of all solvers and
tolerances take turns, so that whatever else the machine does falls on all alike. Times are processor time; the table
has the least, the JSON the medians too.

    pam-cosim        the FMU with its own solver, through pam_cosim.simulation.Simulator
    FMPy ME, CVode   fmpy.simulate_fmu on the same FMU as model exchange, inputs as FMPy applies them
    FMPy CS          fmpy.simulate_fmu on the same FMU as co-simulation
    CasADi CVODES    CasADi's integrator on the same equations, compiled to C, exact Jacobian; inputs as controls
    CasADi, restarts the same, started anew wherever an input changes its course
    CasADi, table    the same without controls: the inputs are looked up in a table of the samples

The error is the largest difference at any output point in parts of the output's range, of the worst output.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, ExitStack
from typing import Any

from benchmarks.speed import cases
from benchmarks.speed.contenders import Run, casadi_cvodes, fmpy_run, pam_cosim
from benchmarks.speed.pictures import draw_run
from benchmarks.speed.reference import reference
from benchmarks.speed.report import machine, milliseconds, parser, say, show, write
from benchmarks.speed.timing import interleaved, scaled_error, time_at_error

CASES = {"steps": cases.steps, "smooth": cases.smooth, "sampled": cases.sampled}
TARGETS = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7)
_OURS = "pam-cosim"
_EXPONENTS = (2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5, 7, 7.5, 8, 9, 10)

Contender = Callable[[float], Run]


def contenders(case: cases.Case) -> dict[str, AbstractContextManager[Contender, bool | None]]:
    """Those that make sense for the inputs of the case, by name."""
    by_name: dict[str, AbstractContextManager[Contender, bool | None]] = {
        _OURS: pam_cosim(case),
        "FMPy ME, CVode": fmpy_run(case, "ModelExchange"),
        "FMPy CS": fmpy_run(case, "CoSimulation"),
        "CasADi CVODES": casadi_cvodes(case),
    }
    if case.inputs is not None:
        by_name["CasADi, restarts"] = casadi_cvodes(case, "restarts")
    if case.name == "sampled":
        by_name["CasADi, table"] = casadi_cvodes(case, "table")
    return by_name


def measure(case: cases.Case, rounds: int) -> dict[str, list[dict[str, float]]]:
    """For each contender and tolerance: tolerance, error, median and least time [s]."""
    exact = reference(case).outputs
    tolerances = [10.0**-exponent for exponent in _EXPONENTS]
    with ExitStack() as stack:
        prepared = {
            name: stack.enter_context(context) for name, context in contenders(case).items()
        }
        runs: dict[tuple[str, float], Run] = {}
        errors: dict[tuple[str, float], float] = {}
        for name, prepare in prepared.items():
            for tolerance in tolerances:
                run = prepare(tolerance)
                with contextlib.suppress(RuntimeError):  # a solver that gives up at this tolerance
                    errors[name, tolerance] = scaled_error(run(), exact)
                    runs[name, tolerance] = run
        times = interleaved(
            list(runs.values()), rounds, f"{case.name}: {len(runs)} settings, {rounds} rounds"
        )
    measured: dict[str, list[dict[str, float]]] = {name: [] for name in prepared}
    for (name, tolerance), time in zip(runs, times, strict=True):
        measured[name].append(
            {
                "tolerance": tolerance,
                "error": errors[name, tolerance],
                "median": time.median,
                "least": time.least,
            }
        )
    return measured


def at_equal_error(
    points: list[dict[str, float]], target: float, kind: str = "least"
) -> float | None:
    """Time [s] of a contender at an error."""
    return time_at_error([p["error"] for p in points], [p[kind] for p in points], target)


def main(arguments: Sequence[str] | None = None) -> None:
    """Measures and prints."""
    options = parser(__doc__)
    options.add_argument("--cases", default=",".join(CASES))
    options.add_argument("--rounds", type=int, default=15)
    options.add_argument(
        "--points", action="store_true", help="also print every tolerance's error and time"
    )
    options.add_argument("--picture", action="store_true", help="draw docs/pictures/speed-run.png")
    given = options.parse_args(arguments)
    figures: dict[str, Any] = {}
    say(f"{machine()['processor']}, {machine()['cores']} cores")
    for name in given.cases.split(","):
        if name not in CASES:
            raise SystemExit(f"there is no case '{name}'; choose from {', '.join(CASES)}")
        measured = measure(CASES[name](), given.rounds)
        figures[name] = {"points": measured, "equal error": _table(name, measured)}
        if given.points:
            _points(name, measured)
    if given.picture:
        say(f"drawn: {draw_run({name: figure['points'] for name, figure in figures.items()})}")
    write(given.json, figures)


def _table(name: str, measured: dict[str, list[dict[str, float]]]) -> dict[str, dict[str, Any]]:
    rows, figures = [], {}
    ours = {target: at_equal_error(measured[_OURS], target) for target in TARGETS}
    for contender, points in measured.items():
        times = {target: at_equal_error(points, target) for target in TARGETS}
        ratios = {
            t: time / mine if time and (mine := ours[t]) else None for t, time in times.items()
        }
        best = min(p["error"] for p in points)
        figures[contender] = {
            "least seconds": {f"{t:g}": v for t, v in times.items()},
            "median seconds": {f"{t:g}": at_equal_error(points, t, "median") for t in TARGETS},
            "ratio": {f"{t:g}": v for t, v in ratios.items()},
            "smallest error": best,
        }
        cells = [f"{milliseconds(times[t])}{_ratio(ratios[t])}" for t in TARGETS]
        rows.append([contender, *cells, f"{best:.1e}"])
    heads = ["solver", *(f"at error {t:.0e}" for t in TARGETS), "least error"]
    show(f"{name}: ms a run (times that of {_OURS}) at equal error; -: not reached", heads, rows)
    return figures


def _ratio(ratio: float | None) -> str:
    return "" if ratio is None else f" ({ratio:.3g}x)"


def _points(name: str, measured: dict[str, list[dict[str, float]]]) -> None:
    rows = [
        [
            contender,
            f"{p['tolerance']:.0e}",
            f"{p['error']:.1e}",
            milliseconds(p["median"]),
            milliseconds(p["least"]),
        ]
        for contender, points in measured.items()
        for p in points
    ]
    show(f"{name}: every setting", ["solver", "tolerance", "error", "median ms", "least ms"], rows)


if __name__ == "__main__":
    main()
