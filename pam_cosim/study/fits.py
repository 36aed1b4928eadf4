"""Free parameters fitted to measurements, and how well these determine them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from pam_cosim.counts import checked_starts
from pam_cosim.errors import InputError
from pam_cosim.fitting import (
    Fit,
    FitOptions,
    Profiles,
    Progress,
    base_parameters,
    with_free,
)
from pam_cosim.fitting import fit as _fit
from pam_cosim.fitting import profile as _profile
from pam_cosim.measurement import DataSet
from pam_cosim.model.settings import Setting, resolve
from pam_cosim.simulation.models import Paths, describe, opened
from pam_cosim.study.data_sets import check_is_read, data_with_starts, for_model, values_of_runs


def fit(
    data: DataSet,
    model: str | None = None,
    *,
    method: str = "least-squares",
    starts: int = 0,
    free: Sequence[str] | None = None,
    start: Mapping[str, Setting] | None = None,
    parameters: Mapping[str, Setting] | None = None,
    files: Paths = (),
    progress: Progress | None = None,
    timeout: float | None = None,
    resume: Path | str | None = None,
) -> Fit:
    """Fits what the data set leaves free.

    Args:
        data: the measurement.
        model: default: the bench of the data set.
        method: "least-squares" from the start values; "multi-start": also from points spread over the bounds;
            "differential-evolution": from the best point of that search; "particle-swarm": from the best particle of a
            swarm over the bounds (Dzahir and Yamamoto 2019). ``Fit.search`` keeps what such a search found by itself.
        starts: points spread over the bounds that "multi-start" follows, each to its end; default: a few of 16.
        free: names of what is fitted, instead of all that the data set leaves free: some of these, or parameters for
            which the model itself states bounds, such as those of an effect. The others are held where they start.
        start: where parameters start, or are held, by name; a number [SI] or a text with a unit.
        parameters: further values to use, as in ``simulate``.
        files: further Modelica files.
        progress: called after each simulation with the ``FitProgress``, which prints itself: ``print`` will do.
        timeout: as in ``simulate``.
        resume: a file that keeps every simulation's outcome. The same call goes on where the last one was interrupted
            and ends as it would have; the file is made where it is not there.

    Raises:
        InputError: unknown model, parameter or method; nothing to fit; ``resume`` keeps another fit.
        SimulationFailure: no start value can be simulated.
    """
    if starts and method != "multi-start":
        raise InputError(f"starts are for the method multi-start, not for {method}")
    checked_starts(starts)
    data = _freed(data, model, free, start, files)
    fixed = resolve(parameters or {}, describe(data.model_for(model), files))
    data = data_with_starts(data, data.model_for(model), fixed, files, timeout)
    with opened(data.model_for(model), files, data.differentiated, timeout) as simulator:
        chosen = base_parameters(data, simulator.interface)
        if not chosen:
            raise InputError(
                "nothing to fit: name the free parameters under [fit]",
                data.folder / "experiment.toml",
            )
        options, kept = (
            FitOptions(method, starts=starts),
            Path(resume) if resume is not None else None,
        )
        return _fit(
            simulator, data, chosen, fixed=fixed, options=options, progress=progress, resume=kept
        )


def _freed(
    data: DataSet,
    model: str | None,
    free: Sequence[str] | None,
    start: Mapping[str, Setting] | None,
    files: Paths,
) -> DataSet:
    """The data set with other free parameters, or starts, where they are asked for."""
    data = for_model(data, model, files)
    if free is None and not start:
        return data
    interface = describe(data.model_for(model), files)
    return with_free(data, interface, free, values_of_runs(start or {}, data, interface))


def profile(
    data: DataSet,
    fit: Fit,
    model: str | None = None,
    *,
    parameters: Mapping[str, Setting] | None = None,
    files: Paths = (),
    progress: Progress | None = None,
    timeout: float | None = None,
) -> Profiles:
    """How well the data determine each parameter of a fit: its profile likelihood, with a sentence for each.

    Args:
        data: what was fitted to.
        fit: what ``fit`` returned; what it freed, set and began with counts.
        model: as for ``fit``.
        parameters: as for ``fit``.
        files: as for ``fit``.
        progress: as for ``fit``.
        timeout: as for ``fit``.

    Raises:
        InputError: as ``fit``.
    """
    check_is_read(data)
    stated = resolve(parameters or {}, describe(data.model_for(model), files))
    fitted, fixed = fit.comparison.data, {**fit.comparison.parameters, **stated}
    with opened(data.model_for(model), files, fitted.differentiated, timeout) as simulator:
        return _profile(simulator, fitted, fit, fixed=fixed, progress=progress)
