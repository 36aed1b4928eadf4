"""The plainest member of every family at once: where several things are missing, they help only together.

A search that adds one effect after another cannot cross masking: the energy balance of the gas alone may make the
pressure worse while a leak is missing too. So a model with a member of every family is fitted, each effect held near
its absence by a prior, and then the effects are left out that the data do not need. The nearer the model comes, the
less the priors weigh against the data: a continuation (Allgower and Georg 2003, Introduction to Numerical Continuation
Methods, section 1), and a regularisation as long as most effects are wrong.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import log, sqrt

import numpy as np

from pam_cosim.catalogue import EffectClass
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import FailedTrial
from pam_cosim.diagnosis.search.elimination import left_out, needed_effects
from pam_cosim.diagnosis.search.trial import (
    Trial,
    attempted,
    begin_of,
    every_parameter,
    values_of_absence,
)
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Free, Linear, linearised
from pam_cosim.fitting.levenberg_marquardt import levenberg_marquardt
from pam_cosim.fitting.objective import Objective
from pam_cosim.measurement import Prior
from pam_cosim.simulation import Simulator

_TURNS = 4  # of the continuation: the misfit settles in two or three
_SETTLED = 0.8  # ratio of a misfit to the one before, from which on another turn changes little
_EVALUATIONS = 12  # of each turn
_PRECISION = 1e-3  # of the cost, at which a turn ends
_TOLERANCE = 1e-5  # relative, of the solver
_BEGIN = 0.1  # of its typical strength: at absence itself some laws have no slope
_WIDE = 4  # standard deviations of the prior of a shape within its bounds


@dataclass(frozen=True)
class FullModel:
    """The effects of a full model that the data need.

    Attributes:
        effects: names, in the order of the model.
        values: of all parameters, and where runs begin [SI].
        misfit: mean square of what it leaves, at least one [noise variances].
    """

    effects: tuple[str, ...]
    values: Mapping[str, float]
    misfit: float = 1.0


@dataclass(frozen=True)
class FullTrial:
    """What a worker needs to fit a full model.

    Attributes:
        trial: the model with all effects.
        members: the effects.
        misfit: mean square of what the base model leaves [noise variances].
        price: of one more effect in the criterion, without its parameters.
    """

    trial: Trial
    members: tuple[EffectClass, ...]
    misfit: float
    price: float


def run_full(full: FullTrial) -> FullModel | FailedTrial:
    """Builds a full model, fits it, and leaves out what the data do not need."""
    return attempted(full.trial, partial(_reduced, full), brief=False)


def _reduced(full: FullTrial, trial: Trial, simulator: Simulator) -> FullModel:
    absent = values_of_absence(full.members, trial.composition.parameters)
    owned = {n for names in trial.composition.parameters.values() for n in names}
    free = [
        near_absence(f, absent.get(f.name))
        if f.name in owned
        else f.starting_at(trial.start.get(f.name, f.start))
        for f in every_parameter(trial.data, trial.composition, simulator.interface)
    ]
    names_of, effects = trial.composition.parameters, tuple(e.name for e in full.members)
    misfit, held = full.misfit, dict[str, float]()
    begins: Mapping[str, float] = begin_of(trial, simulator.interface)
    while True:
        linear, misfit, begins = _fitted(simulator, trial, free, {**begins, **held}, misfit)
        values = dict(zip(linear.names, linear.values.tolist(), strict=True))
        parameters = {e: names_of[e] for e in effects}
        needed = needed_effects(linear, parameters, absent, misfit, full.price)
        if needed == effects:
            return FullModel(effects, {**values, **begins}, misfit)
        held |= left_out(needed, parameters, values, absent)
        free = [f.starting_at(values[f.name]) for f in free if f.name not in held]
        effects = needed


def near_absence(free: Free, absent: float | None) -> Free:
    """A parameter of an effect with a prior about the value at which the effect vanishes; a shape has a wide one.

    A strength that is larger where the effect is away, as a conductance in series, is searched by its logarithm.
    """
    if absent is None or absent == free.start:
        if free.prior is not None:
            return free
        if free.low > 0:
            width = log(free.high / free.low) / _WIDE
            return replace(
                free, transform="log", prior=Prior(sqrt(free.low * free.high), width, True)
            )
        return replace(
            free, prior=Prior((free.low + free.high) / 2, (free.high - free.low) / _WIDE)
        )
    if 0 < free.start < absent:
        start = free.start * (absent / free.start) ** (1 - _BEGIN)
        prior = Prior(absent, log(absent / free.start), logarithmic=True)
        low = free.low if free.low > 0 else free.start / CRITERIA.fit.log_ratio
        high = max(free.high, absent)
        return replace(free, transform="log", low=low, high=high, start=start, prior=prior)
    typical = abs(free.start - absent) if free.prior is None else free.prior.sd
    return replace(
        free,
        transform="linear",
        nominal=typical,
        low=min(free.low, absent),
        high=max(free.high, absent),
        start=absent + _BEGIN * (free.start - absent),
        prior=Prior(absent, typical),
    )


def _fitted(
    simulator: Simulator,
    trial: Trial,
    free: Sequence[Free],
    held: Mapping[str, float],
    misfit: float,
) -> tuple[Linear, float, Mapping[str, float]]:
    """The model, fitted and linearised there; its misfit: the mean square of what it leaves, at least one; its starts.

    Args:
        held: values of effects that are left out, and where runs begin, by name [SI].

    Raises:
        SimulationFailure: it cannot be simulated.
    """
    z = np.array([f.to_z(f.start) for f in free])
    for _ in range(_TURNS):
        # weighing the data by the misfit is the same as making the priors as much tighter
        weighed = [
            f if f.prior is None else replace(f, prior=_tighter(f.prior, misfit)) for f in free
        ]
        objective = Objective(simulator, trial.data, trial.data.fit_runs, weighed, held, _TOLERANCE)
        if not np.isfinite(objective.squares(z)):
            raise SimulationFailure(objective.first_failure)
        z = levenberg_marquardt(
            objective.squares, objective.triangle, z, objective.bounds, _PRECISION, _EVALUATIONS
        ).z
        before, residual = misfit, objective.residuals(z)[: objective.size]
        held = {**held, **objective.starts.settings}
        misfit = max(float(residual @ residual) / max(objective.samples, 1.0), 1.0)
        if misfit > _SETTLED * before:
            break
    linear = linearised(objective, z, CRITERIA.search.rows)
    if linear is None:
        raise SimulationFailure(objective.first_failure)
    return (
        replace(linear, priors={f.name: f.prior for f in free if f.prior is not None}),
        misfit,
        objective.starts.settings,
    )


def _tighter(prior: Prior, misfit: float) -> Prior:
    return replace(prior, sd=prior.sd / sqrt(misfit))
