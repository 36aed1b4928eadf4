"""Runs of a model over ranges of what can be set."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from pam_cosim.counts import checked_seed, checked_workers
from pam_cosim.errors import InputError
from pam_cosim.exports import check_table_ending
from pam_cosim.files import check_writable
from pam_cosim.fmu import read_interface
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_fmu, model_name
from pam_cosim.model.settings import Setting, resolve
from pam_cosim.simulation.models import Paths, build
from pam_cosim.study.input_sources import Source
from pam_cosim.study.runs import _input_series, kept_variables
from pam_cosim.sweeps import Sweep, SweepPlan, design_of, make_sweep, read_scalars
from pam_cosim.sweeps.patterns import INPUTS, Pattern, read_patterns, varies_inputs


def sweep(
    model: str,
    vary: Mapping[str, Iterable[Setting]] | Sequence[Mapping[str, Setting]] | Any,
    *,
    parameters: Mapping[str, Setting] | None = None,
    inputs: Source | None = None,
    outputs: Sequence[str] = (),
    scalars: Mapping[str, str] | Sequence[str] = (),
    trajectories: bool | None = None,
    design: str = "grid",
    runs: int | None = None,
    seed: int = 0,
    stop_time: Setting | None = None,
    interval: Setting | None = None,
    output: Path | str | None = None,
    executor: Any = None,
    workers: int | None = None,
    files: Paths = (),
    progress: Callable[[int, int], None] | None = None,
    timeout: float | None = None,
) -> Sweep:
    """Many runs of a model; one that fails is reported and the others go on.

    ```python
    swept = pam.sweep(
        "TankFilling",
        {"u_in": np.linspace(0.2, 0.35, 16), "p_supply": ["138 kPa", "207 kPa"]},
        scalars={"filling time": "time_to(p, 90 %)", "peak temperature": "max(T)"},
        output="filling.nc",
    )
    swept.to_xarray()["filling time"].sel(p_supply=138e3)
    ```

    Args:
        model: as in ``simulate``.
        vary: by name of a parameter, an input that is held constant or a start value: its values for a "grid", where
            every combination is a run, and for a "list", run by run (or a mapping for each run, or a pandas frame);
            its lowest and highest value for "random" and "latin-hypercube". A span may be a text, "0.2:0.35:16" or
            "0.2:0.35". By the name "inputs": inputs over time, a list of whatever ``inputs`` takes (files, mappings of
            arrays or functions, frames), or by their names; all begin at one time, and last values stay.
        parameters: of every run, as in ``simulate``.
        inputs: of every run, as in ``simulate``.
        stop_time: of every run, as in ``simulate``.
        interval: of every run, as in ``simulate``.
        outputs: further variables to record over time.
        scalars: numbers of each run by name, or a list: "max(T)", "time_to(p, 90 %)", "steady(x)",
            "mean(valve.inlet.m_flow)"; ``sweeps.FUNCTIONS`` lists them.
        trajectories: whether values over time are kept; default: where there are no scalars.
        design: "grid", "list", "random" or "latin-hypercube".
        runs: how many, of "random" and "latin-hypercube".
        seed: of these.
        output: a file for the result, NetCDF (.nc), Parquet (.parquet) or CSV. Finished runs are kept next to it: a
            sweep that was stopped continues with the same call.
        executor: where runs are made: any executor of ``concurrent.futures``, a Dask client or the address of a Dask
            scheduler; default: processes of this machine, as soon as the work is worth them.
        workers: how many of these; 1: this process alone.
        files: further Modelica files.
        timeout: of every run, as in ``simulate``.
        progress: called with the number of runs done and of all runs.

    Raises:
        InputError: as ``simulate``; a name that is both varied and set; ``output`` belongs to another sweep.
        SimulationFailure: a process that makes runs ended.
    """
    if output is not None:
        check_table_ending(Path(output))
        check_writable(Path(output))
    model = model_name(model)
    foreign, fmu = is_fmu(model), build(model, files=files)
    interface = read_interface(fmu)
    patterns = _patterns(interface, vary, stop_time, interval)
    longest = max((p.inputs for p in patterns), key=lambda i: float(i.time[-1]), default=None)
    input_series, times = _input_series(
        interface, longest if patterns and inputs is None else inputs, stop_time, interval
    )
    input_series = None if patterns and inputs is None else input_series
    requested = read_scalars(scalars, interface)
    plan = SweepPlan(
        fmu=fmu,
        interface=interface,
        design=design_of(vary, interface, design, runs, checked_seed(seed), patterns),
        fixed=resolve(parameters or {}, interface),
        inputs=input_series,
        times=times,
        outputs=tuple(kept_variables(interface, outputs)),
        scalars=requested,
        keep=not requested if trajectories is None else trajectories,
        foreign=foreign,
        timeout=timeout,
    )
    result = None if output is None else Path(output)
    completed_sweep = make_sweep(
        plan, result, executor=executor, workers=checked_workers(workers, 1), progress=progress
    )
    if result is not None:
        completed_sweep.save(result)
    return completed_sweep


def _patterns(
    interface: Interface, vary: Any, stop_time: Setting | None, interval: Setting | None
) -> tuple[Pattern, ...]:
    """The inputs over time that a sweep varies; none where it does not."""
    if not varies_inputs(vary, interface):
        return ()
    patterns = read_patterns(
        vary[INPUTS], lambda source: _input_series(interface, source, stop_time, interval)[0]
    )
    _check_beginnings(patterns)
    return patterns


def _check_beginnings(patterns: Sequence[Pattern]) -> None:
    """Raises ``InputError`` where they do not all begin at one time: all runs have the times of one."""
    pattern = patterns[0]
    for other in patterns[1:]:
        begin, differs = float(pattern.inputs.time[0]), float(other.inputs.time[0])
        if differs != begin:
            raise InputError(
                f"'{INPUTS}' is varied, and '{pattern.name}' begins at {begin:g} s, '{other.name}' at {differs:g} s: "
                "all runs of a sweep begin at one time"
            )
