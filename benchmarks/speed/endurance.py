"""Whether memory stays flat: many runs of one instance, many instances, many loads of the library.

    python -m benchmarks.speed.endurance                 100 000 runs, 5 000 instances, 1 000 loads: some two minutes

A run is 0.2 s of the isotonic bench with 20 output points and a step of the currents. Resident memory is read after a
warm-up of a tenth of the runs, and then a hundred times; the slope is that of the straight line through these.
"""

from __future__ import annotations

import gc
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.speed import cases
from benchmarks.speed.report import parser, show, steps_of, write
from pam_cosim.simulation import Simulator, Trajectory

_READINGS = 100


def short() -> cases.Case:
    """0.2 s of filling and venting."""
    inputs = cases.courses(0.2, u_in=((0.0, 0.35), (0.1, 0.0)), u_out=((0.0, 0.0), (0.1, 0.35)))
    return cases.Case("short", "PneumaticMuscle.Benches.Isotonic", inputs, 0.2, 20)


def resident() -> float:
    """Resident memory of this process [MB].

    Raises:
        SystemExit: the system does not tell.
    """
    try:
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    except OSError:
        raise SystemExit("resident memory is read from /proc: this benchmark needs Linux") from None
    return pages * 4096 / 1e6


def repeat(do: Callable[[], None], count: int, what: str) -> dict[str, float]:
    """Does it ``count`` times after the warm-up: seconds for each, memory before and after [MB], slope [bytes each]."""
    for _ in range(max(count // 10, 1)):
        do()
    gc.collect()
    every = max(count // _READINGS, 1)
    done, memory = [0], [resident()]
    begin = time.perf_counter()
    for _ in steps_of(range(count // every), what):
        for _ in range(every):
            do()
        done.append(done[-1] + every)
        memory.append(resident())
    seconds = time.perf_counter() - begin
    slope = float(np.polyfit(done, memory, 1)[0]) * 1e6
    return {
        "count": done[-1],
        "seconds each": seconds / done[-1],
        "megabytes before": memory[0],
        "megabytes after": memory[-1],
        "bytes each": slope,
    }


def main(arguments: Sequence[str] | None = None) -> None:
    """Measures and prints; ends with an error where a run fails or differs from the first."""
    options = parser(__doc__)
    options.add_argument("--runs", type=int, default=100_000)
    options.add_argument("--instances", type=int, default=5_000)
    options.add_argument("--loads", type=int, default=1_000)
    given = options.parse_args(arguments)
    case = short()

    def run(simulator: Simulator) -> Trajectory:
        return simulator.run(case.times, inputs=case.inputs, outputs=case.outputs)

    with Simulator(case.fmu) as simulator:
        first = run(simulator)["x"]

        def again() -> None:
            _same(run(simulator)["x"], first)

        def anew() -> None:
            simulator._renew()  # the only way to a fresh instance of a loaded library
            simulator._used = False
            _same(run(simulator)["x"], first)

        figures = {
            "runs of one instance": repeat(again, given.runs, "runs"),
            "instances": repeat(anew, given.instances, "instances"),
        }

    def load() -> None:
        with Simulator(case.fmu) as fresh:
            _same(run(fresh)["x"], first)

    figures["unpacked, loaded, unloaded"] = repeat(load, given.loads, "loads")
    _print(figures)
    write(given.json, figures)


def _same(values: np.ndarray, first: np.ndarray) -> None:
    if not np.array_equal(values, first):
        raise SystemExit("a repeated run differs from the first")


def _print(figures: dict[str, dict[str, Any]]) -> None:
    heads = ["what", "count", "ms each", "MB before", "MB after", "bytes each"]
    rows = [
        [
            name, f"{f['count']:.0f}", f"{f['seconds each'] * 1e3:.3g}", f"{f['megabytes before']:.2f}",
            f"{f['megabytes after']:.2f}", f"{f['bytes each']:.2f}",
        ]
        for name, f in figures.items()
    ]  # fmt: skip
    show("resident memory over many runs; every run equal to the first, bit for bit", heads, rows)


if __name__ == "__main__":
    main()
