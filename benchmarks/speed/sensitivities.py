"""What the derivatives of all outputs with respect to ten parameters cost, and how good they are.

    python -m benchmarks.speed.sensitivities             half a minute

A 10 s run of the isotonic bench with 1000 output points and steps of the currents; three outputs, so thirty
derivatives. Compared are the FMU that integrates them with the states, and finite differences of runs without: forward
(eleven runs) and central (twenty). Finite differences get, for each tolerance, the relative step that serves them best,
found by trying powers of ten; the search is not in their time. The reference is SciPy's DOP853 at 1e-12 on the
equations with their derivatives. The error is the largest difference at any output point in parts of the derivative's
range, of the worst derivative; the usual error is that of half the points. Times are processor time, least of all
rounds.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from benchmarks.speed import cases
from benchmarks.speed.reference import reference
from benchmarks.speed.report import milliseconds, parser, show, write
from benchmarks.speed.timing import interleaved, scaled_error
from pam_cosim.simulation import Simulator

Array = NDArray[np.float64]

PARAMETERS = (
    "valve.C_A", "muscle.L0", "muscle.D0", "muscle.turns", "muscle.n_g", "muscle.mu_fb", "muscle.mu_d", "muscle.w",
    "load.m", "ambient.p",
)  # fmt: skip
TOLERANCES = (1e-4, 1e-6, 1e-8)
_STEPS = tuple(10.0**-exponent for exponent in range(1, 7))


def values(
    simulator: Simulator, case: cases.Case, tolerance: float, changed: dict[str, float]
) -> Array:
    """(n, outputs) of a run with some parameters changed."""
    trajectory = simulator.run(
        case.times,
        parameters=changed,
        inputs=case.inputs,
        outputs=case.outputs,
        tolerance=tolerance,
    )
    return np.stack([trajectory[name] for name in case.outputs], axis=1)


def derivatives(simulator: Simulator, case: cases.Case, tolerance: float) -> Array:
    """(n, outputs x parameters) of the FMU that integrates them."""
    return values(simulator, case, tolerance, {})[:, len(case.outputs) // (1 + len(PARAMETERS)) :]


def differences(
    simulator: Simulator, case: cases.Case, tolerance: float, step: float, central: bool
) -> Array:
    """The same from runs of the plain FMU with each parameter changed by a part ``step`` of its value."""
    run = partial(values, simulator, case, tolerance)
    here = None if central else run({})
    columns = []
    for name in PARAMETERS:
        value = simulator.interface.parameters[name].start
        assert value
        up = run({name: value * (1 + step)})
        below, width = (run({name: value * (1 - step)}), 2) if here is None else (here, 1)
        columns.append((up - below) / (width * step * value))
    return np.stack(columns, axis=2).reshape(case.times.size, -1)


def main(arguments: Sequence[str] | None = None) -> None:
    """Measures and prints."""
    options = parser(__doc__)
    options.add_argument("--rounds", type=int, default=9)
    given = options.parse_args(arguments)
    plain = cases.steps()
    both = replace(plain, sensitivities=PARAMETERS)
    exact = reference(both).outputs[:, len(plain.outputs) :]
    rows, figures = [], []
    with ExitStack() as stack:
        one = stack.enter_context(Simulator(plain.fmu))
        two = stack.enter_context(Simulator(both.fmu))
        for tolerance in TOLERANCES:
            runs: dict[str, Callable[[], Array]] = {
                "run without": partial(values, one, plain, tolerance, {}),
                "run with derivatives": partial(derivatives, two, both, tolerance),
            }
            for name, central in (("forward differences", False), ("central differences", True)):
                step = _best_step(one, plain, exact, tolerance, central)
                runs[f"{name}, step {step:.0e}"] = partial(
                    differences, one, plain, tolerance, step, central
                )
            times = interleaved(list(runs.values()), given.rounds, f"tolerance {tolerance:g}")
            for (name, run), time in zip(runs.items(), times, strict=True):
                plain_run = name == "run without"
                error = None if plain_run else scaled_error(run(), exact)
                usual = None if plain_run else _usual_error(run(), exact)
                ratio = time.least / times[0].least
                rows.append(
                    [
                        name, f"{tolerance:.0e}", milliseconds(time.least), f"{ratio:.2f}x",
                        "" if error is None else f"{error:.1e}",
                        "" if usual is None else f"{usual:.1e}",
                    ]
                )  # fmt: skip
                figures.append(
                    {
                        "what": name,
                        "tolerance": tolerance,
                        "seconds": time.least,
                        "ratio": ratio,
                        "error": error,
                        "usual error": usual,
                    }
                )
    show(
        f"{exact.shape[1]} derivatives: {len(plain.outputs)} outputs by {len(PARAMETERS)} parameters",
        ["what", "tolerance", "ms", "times a run", "error", "usual error"],
        rows,
    )
    write(given.json, {"parameters": PARAMETERS, "figures": figures})


def _usual_error(values_of_run: Array, exact: Array) -> float:
    return float((np.median(np.abs(values_of_run - exact), axis=0) / np.ptp(exact, axis=0)).max())


def _best_step(
    simulator: Simulator, case: cases.Case, exact: Array, tolerance: float, central: bool
) -> float:
    errors = [
        scaled_error(differences(simulator, case, tolerance, step, central), exact)
        for step in _STEPS
    ]
    return _STEPS[int(np.argmin(errors))]


if __name__ == "__main__":
    main()
