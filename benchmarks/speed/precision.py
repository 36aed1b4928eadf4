"""Work and precision: the tolerance asked for, the error achieved, and the time, for every bench.

    python -m benchmarks.speed.precision                 about a minute
    python -m benchmarks.speed.precision --picture       also draws docs/pictures/speed-precision.png

The reference is SciPy's DOP853 at 1e-12 on the same equations. Two errors are judged, each at 1001 points:

    outputs   largest difference in parts of the output's range over the run, of the worst output
    states    largest difference in parts of |x| + nominal, of the worst state: the norm in which the solver
              keeps the error of each step below the tolerance

A tolerance is met where both errors are below it. The solver controls the error of each step; how these add up over a
run is the model's affair, so errors up to ten times the tolerance are told apart from larger ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass

import numpy as np

from benchmarks.speed import cases
from benchmarks.speed.pictures import draw_precision
from benchmarks.speed.reference import Reference, reference
from benchmarks.speed.report import parser, say, show, steps_of, write
from benchmarks.speed.timing import interleaved, scaled_error
from pam_cosim.simulation import Simulator

TOLERANCES = tuple(10.0**-exponent for exponent in range(4, 10))
NEAR = 10.0
_LONGER = {"smooth": "Isotonic, smooth", "sampled": "Isotonic, sampled"}


@dataclass(frozen=True)
class Point:
    """One run: what was asked for, what came out.

    Attributes:
        tolerance: of the solver.
        outputs, states: errors in the two norms.
        seconds: least time of a run [s].
        steps: of the solver.
    """

    tolerance: float
    outputs: float
    states: float
    seconds: float
    steps: int

    @property
    def excess(self) -> float:
        """The larger error in parts of the tolerance."""
        return max(self.outputs, self.states) / self.tolerance


def measure(case: cases.Case, rounds: int) -> list[Point]:
    """Errors and times of a case over the tolerances."""
    exact = reference(case)
    with Simulator(case.fmu) as simulator:

        def run(tolerance: float, names: Sequence[str]) -> np.ndarray:
            trajectory = simulator.run(
                case.times, inputs=case.inputs, outputs=names, tolerance=tolerance
            )
            columns = [trajectory[name] for name in names]
            return np.stack(columns, axis=1) if names else np.empty((case.times.size, 0))

        errors, steps = [], []
        for tolerance in TOLERANCES:
            outputs = scaled_error(run(tolerance, case.outputs), exact.outputs)
            states = _state_error(case, exact, run(tolerance, case.state_names))
            statistics = simulator.statistics
            errors.append((outputs, states))
            steps.append(statistics.steps if statistics is not None else 0)
        runs = [
            lambda tolerance=tolerance: run(tolerance, case.outputs) for tolerance in TOLERANCES
        ]
        times = interleaved(runs, rounds, case.name)
    measured = zip(TOLERANCES, errors, times, steps, strict=True)
    return [
        Point(tolerance, *error, time.least, count) for tolerance, error, time, count in measured
    ]


def _state_error(case: cases.Case, exact: Reference, states: np.ndarray) -> float:
    if not case.state_names:
        return 0.0
    return float((np.abs(states - exact.states) / (np.abs(exact.states) + case.nominals)).max())


def main(arguments: Sequence[str] | None = None) -> None:
    """Measures, prints, draws."""
    options = parser(__doc__)
    options.add_argument("--rounds", type=int, default=9)
    options.add_argument("--picture", action="store_true")
    given = options.parse_args(arguments)
    chosen = [*map(cases.bench, cases.bench_names()), cases.smooth(), cases.sampled()]
    by_case: dict[str, list[Point]] = {}
    for case in steps_of(chosen, "cases"):
        by_case[_LONGER.get(case.name, case.name)] = measure(case, given.rounds)
    _print(by_case)
    if given.picture:
        say(
            f"drawn: {draw_precision({name: [asdict(p) for p in points] for name, points in by_case.items()})}"
        )
    write(
        given.json,
        {
            name: [asdict(p) | {"excess": p.excess} for p in points]
            for name, points in by_case.items()
        },
    )


def _print(by_case: dict[str, list[Point]]) -> None:
    heads = ["bench", *(f"{tolerance:.0e}" for tolerance in TOLERANCES)]
    for kind in ("outputs", "states"):
        rows = [
            [name, *(f"{getattr(p, kind) / p.tolerance:.2g}" for p in points)]
            for name, points in by_case.items()
        ]
        show(f"error of the {kind} / tolerance", heads, rows)
    rows = [
        [name, *(f"{p.seconds * 1e3:.3g} ({p.steps})" for p in points)]
        for name, points in by_case.items()
    ]
    show("least ms a run (steps)", heads, rows)
    every = [(name, p) for name, points in by_case.items() for p in points]
    met, near = (
        sum(p.excess <= 1.0 for _, p in every),
        sum(1.0 < p.excess <= NEAR for _, p in every),
    )
    far = len(every) - met - near
    say(
        f"{len(every)} runs: {met} meet the tolerance, {near} are within {NEAR:g} times, {far} beyond"
    )
    for name, p in every:
        if p.excess > NEAR:
            say(f"beyond: {name} at {p.tolerance:.0e}: error {p.excess:.3g} times the tolerance")


if __name__ == "__main__":
    main()
