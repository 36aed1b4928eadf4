"""What a fitted model predicts of runs that were not recorded, with bands."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import AbstractContextManager

import numpy as np

from pam_cosim.counts import checked_samples, checked_seed
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.fitting import (
    Fit,
    Free,
    PredictiveBands,
    base_parameters,
    discrepancies,
    model_parameter,
)
from pam_cosim.fitting import parameter_posterior as _posterior
from pam_cosim.fitting import predictive_bands as _bands
from pam_cosim.fmu import build_source
from pam_cosim.measurement import DataSet, Run, further_run, rows_of
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import parameter_of, sources_of
from pam_cosim.model.settings import Setting, resolve
from pam_cosim.problems import Problem
from pam_cosim.simulation import AnySimulator, Simulator
from pam_cosim.simulation.models import Paths, as_paths, opened
from pam_cosim.study.fits import fit
from pam_cosim.study.input_sources import Source
from pam_cosim.study.problems import check_kind
from pam_cosim.study.runs import _input_series
from pam_cosim.wording import did_you_mean, listed

# of the parameters: the ends of a 95 % band are known to a seventh of a standard deviation
_SAMPLES = 200


def predict(
    product: Fit | Diagnosis | Problem,
    inputs: Source | None = None,
    parameters: Mapping[str, Setting] | None = None,
    *,
    run: str | None = None,
    stop_time: Setting | None = None,
    interval: Setting | None = None,
    samples: int = _SAMPLES,
    seed: int = 0,
    discrepancy: bool = True,
    files: Paths = (),
) -> PredictiveBands:
    """What a fitted model predicts of a run, with 95 % bands of the uncertainty of its parameters.

    The parameters are drawn from Laplace's approximation of their posterior between their bounds
    (``fitting.parameter_posterior``), and the run is simulated with each of them. Readings are off by more: by noise,
    and by what the model is off in other runs (``fitting.discrepancy``).

    Args:
        product: what was fitted; of a diagnosis, the model with all effects that were added. A problem is fitted first.
        inputs: over time, as for ``simulate``.
        parameters: what is set in the run, by name; what differs between the recorded runs has to be stated.
        run: the name of a recorded run, instead of ``inputs``: its readings are shown with the bands, at its own times.
        stop_time: as for ``simulate``.
        interval: likewise.
        samples: of the parameters.
        seed: of the random numbers.
        discrepancy: whether the bands of readings hold what the model is off by, as held-out runs show it, else fitted
            ones.
        files: further Modelica files, as for the fit.

    Raises:
        InputError: an unknown run, input or parameter; something that has to be stated; nothing was fitted.
        SimulationFailure: the model breaks down at the optimum or with most of the samples.
    """
    if isinstance(product, Problem):
        files = (*as_paths(files), *product.files)
        product = fit(product)
    requirement = "a fit, a problem or a diagnosis is needed"
    check_kind(product, (Fit, Diagnosis), requirement, "make one, or load it by pam.load(FILE.npz)")
    samples, seed = checked_samples(samples), checked_seed(seed)
    fitted, data = (
        (product.final, product.data)
        if isinstance(product, Diagnosis)
        else (product, product.comparison.data)
    )
    if not fitted.parameters:
        raise InputError("no parameter was fitted, so there are no bands")
    with _simulator(product, data, files) as simulator:
        free = _free(fitted, data, simulator.interface)
        posterior = _posterior(simulator, data, fitted, free, samples, seed)
        if run is not None:
            stated = (inputs, parameters or None, stop_time, interval)
            if any(option is not None for option in stated):
                raise InputError(
                    f"the run {run} has inputs and parameters of its own, and times; leave those out, or the run"
                )
            chosen = _recorded(data, run)
        else:
            chosen = _run(data, simulator.interface, inputs, parameters or {}, stop_time, interval)
        off = (
            discrepancies(fitted.comparison.runs, data.signals, fitted.freedom, run or "")
            if discrepancy
            else {}
        )
        values = fitted.comparison.parameters | fitted.values_and_starts
        return _bands(simulator, data, chosen, posterior, values, off=off)


def _simulator(
    product: Fit | Diagnosis, data: DataSet, files: Paths
) -> AbstractContextManager[AnySimulator]:
    if isinstance(product, Diagnosis) and product.path:
        text = product.path[-1].equations
        names = [parameter_of(name) for name in product.final.parameters]
        sources = sources_of(as_paths(files), product.model)
        return Simulator(
            build_source(text.split()[1], text, sources, sensitivities=names, lean=True)
        )
    model = product.model if isinstance(product, Diagnosis) else data.model
    return opened(model, files, data.differentiated)


def _free(fit: Fit, data: DataSet, interface: Interface) -> list[Free]:
    """The parameters of a fit that it moved, with their bounds."""
    base = {f.name: f for f in base_parameters(data, interface)}
    fitted_names = [name for name, estimate in fit.parameters.items() if not estimate.held]
    return [
        base[name] if name in base else model_parameter(name, interface) for name in fitted_names
    ]


def _recorded(data: DataSet, name: str) -> Run:
    runs_by_name = {run.name: run for run in data.runs if not run.is_static}
    if name not in runs_by_name:
        raise InputError(f"there is no run '{name}' over time; {did_you_mean(name, runs_by_name)}")
    return runs_by_name[name]


def _run(
    data: DataSet,
    interface: Interface,
    inputs: Source | None,
    parameters: Mapping[str, Setting],
    stop_time: Setting | None,
    interval: Setting | None,
) -> Run:
    """A run that was not recorded."""
    if data.is_static:
        raise InputError("points at rest have no run over time")
    input_series, times = _input_series(interface, inputs, stop_time, interval)
    values = resolve(parameters, interface)
    constants = data.runs[0].parameters
    recorded = {name: {run.parameters.get(name) for run in data.runs} for name in constants}
    open_ones = [
        name for name, distinct in recorded.items() if len(distinct) > 1 and name not in values
    ]
    if open_ones:
        raise InputError(
            f"state {listed(open_ones)} of the run: the recorded runs have different values"
        )
    if input_series is None:
        return further_run(data, times, {}, values, "a further run")
    time, columns = rows_of(input_series, np.asarray(times))
    return further_run(data, time, columns, values, "a further run")
