"""Ten thousand runs of the isotonic bench, 10 s each, as a sweep, against a loop over FMPy.

    python -m benchmarks.speed.sweep                     about two minutes
    python -m benchmarks.speed.sweep --runs 900

Current by supply, three numbers of each run. The same sweep is made in this process alone, in two processes and on a
Dask cluster of two processes of this machine; its numbers must be equal to the last bit, or the status is 1.
Times are of the clock, processes started within them; a loop over ``fmpy.simulate_fmu`` with a prepared instance is
measured on fifty of the runs and its time is scaled up. Memory is the largest of the process that asks.
"""

from __future__ import annotations

import math
import resource
import shutil
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any

import fmpy
import numpy as np
from fmpy.simulation import instantiate_fmu, simulate_fmu

import pam_cosim as pam
from benchmarks.speed.report import parser, say, show, write
from pam_cosim.sweeps import same

MODEL, DURATION = "Isotonic", 10.0
SCALARS = {
    "filling time": "time_to(p, 90 %)",
    "steady contraction": "steady(x)",
    "peak temperature": "max(T)",
}
_SAMPLE = 50  # runs of the loop over FMPy


def grid(runs: int) -> dict[str, np.ndarray]:
    """As many currents as supplies, about ``runs`` together."""
    side = math.isqrt(runs)
    return {"u_in": np.linspace(0.25, 0.45, side), "p_supply": np.linspace(150e3, 300e3, side)}


def timed(make: Callable[[], pam.Sweep]) -> tuple[float, pam.Sweep]:
    """Seconds of the clock, and the sweep."""
    begin = time.perf_counter()
    made = make()
    return time.perf_counter() - begin, made


def peak() -> float:
    """Largest memory of this process so far [MB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3


def fmpy_loop(runs: Sequence[dict[str, float]]) -> float:
    """Seconds of the clock of one run, on average."""
    folder = fmpy.extract(str(pam.build(MODEL)))
    description = fmpy.read_model_description(folder)
    instance = instantiate_fmu(folder, description, "CoSimulation")
    try:
        begin = time.perf_counter()
        for settings in runs:
            instance.reset()
            simulate_fmu(
                folder, validate=False, stop_time=DURATION, fmi_type="CoSimulation", start_values=settings,
                output_interval=0.01, output=["p", "x", "T"], model_description=description, fmu_instance=instance,
            )  # fmt: skip
        return (time.perf_counter() - begin) / len(runs)
    finally:
        instance.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)


def main(arguments: Sequence[str] | None = None) -> int:
    """Makes the sweep each way and compares."""
    options = parser(__doc__)
    options.add_argument("--runs", type=int, default=10_000)
    chosen = options.parse_args(arguments)
    vary = grid(chosen.runs)

    def sweep(**more: Any) -> pam.Sweep:
        return pam.sweep(MODEL, vary, scalars=SCALARS, stop_time=DURATION, **more)

    pam.build(MODEL)
    times: dict[str, float] = {}
    times["one process"], one = timed(lambda: sweep(workers=1))
    memory = peak()
    times["two processes"], two = timed(lambda: sweep(workers=2))
    from distributed import Client, LocalCluster

    with (
        LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
        ) as cluster,  # type: ignore[no-untyped-call]
        Client(cluster) as client,  # type: ignore[no-untyped-call]
    ):
        times["Dask, two processes"], dask = timed(lambda: sweep(executor=client))
    equal = same(one, two) and same(one, dask)
    settings = [
        one.design.settings(i) for i in np.linspace(0, len(one) - 1, _SAMPLE).round().astype(int)
    ]
    times["loop over FMPy, one process (scaled up)"] = fmpy_loop(settings) * len(one)
    best = times["one process"]
    rows = [
        [name, f"{seconds:.1f}", f"{seconds / len(one) * 1e3:.2f}", f"{seconds / best:.2f}"]
        for name, seconds in times.items()
    ]
    show(f"{len(one)} runs of 10 s", ["way", "all [s]", "a run [ms]", "times one process"], rows)
    say(
        f"memory of the asking process {memory:.0f} MB; numbers {'equal' if equal else 'DIFFERENT'}"
    )
    write(chosen.json, {"runs": len(one), "seconds": times, "memory_MB": memory, "equal": equal})
    return 0 if equal else 1


if __name__ == "__main__":
    sys.exit(main())
