"""What of an effect the recordings cannot show: parameters that move nothing, readings that nobody took."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import simulate_run
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Free, residual_rows
from pam_cosim.fitting.objective import Objective

_SHARES = (0.3, 0.6)  # of the ways between bounds: anywhere but at an end will do


def idle_parameters(probe: EffectProbe, objective: Objective) -> tuple[str, ...]:
    """An effect's own parameters that change no sample between their bounds, wherever its other parameters are.

    A parameter may do nothing where another is zero, as the reach of a force that has no size. So the others are put
    at several places between their bounds too.
    """
    if probe.silent:
        return ()
    slopes = dict(
        zip(probe.linear.names, probe.linear.slopes.T * _ranges(probe)[:, None], strict=True)
    )
    little = CRITERIA.search.idle * float(probe.linear.residual @ probe.linear.residual)
    still = [
        f
        for f in _own_parameters(probe, objective)
        if float(slopes[f.name] @ slopes[f.name]) < little
    ]
    places = _test_points(probe, objective) if still else []
    return tuple(
        f.name for f in still if all(_is_inactive(objective, z, f, little) for z in places)
    )


def _own_parameters(probe: EffectProbe, objective: Objective) -> list[Free]:
    return [free for free in objective.free if free.name in probe.own_parameters]


def _ranges(probe: EffectProbe) -> Array:
    return np.asarray(probe.linear.high - probe.linear.low)


def _test_points(probe: EffectProbe, objective: Objective) -> list[Array]:
    """Search coordinates: where the probe is linear, and with all of the effect's own parameters on their ways."""
    z = _probe_point(probe, objective)
    low, high = objective.bounds
    is_own = np.array([free.name in probe.own_parameters for free in objective.free])
    return [z, *(np.where(is_own, low + share * (high - low), z) for share in _SHARES)]


def _probe_point(probe: EffectProbe, objective: Objective) -> Array:
    """The search coordinates about which the probe is linear."""
    values = dict(zip(probe.linear.names, probe.linear.values.tolist(), strict=True))
    return np.array([free.to_z(values[free.name]) for free in objective.free])


def _is_inactive(objective: Objective, z: Array, free: Free, little: float) -> bool:
    """Whether the samples are the same at both bounds of a parameter; where a model breaks down nothing is seen."""
    ends = [_with_values(objective, z, {free.name: value}) for value in (free.low, free.high)]
    lower, upper = (residual_rows(objective, end, CRITERIA.search.rows) for end in ends)
    return lower is None or upper is None or float(np.sum((lower - upper) ** 2)) < little


def _with_values(objective: Objective, z: Array, values: dict[str, float]) -> Array:
    moved = z.copy()
    for i, free in enumerate(objective.free):
        if free.name in values:
            moved[i] = free.to_z(values[free.name])
    return moved


def moves_only_unmeasured(probe: EffectProbe, objective: Objective) -> bool:
    """Whether an effect that no sample shows moves an output of the bench that nobody read, as a thermometer's does.

    Then more of it, or another model beside it, shows no more. What moves nothing at all may wait for another effect.
    """
    unread = _unmeasured_outputs(objective)
    if not probe.silent or not unread:
        return False
    z = _probe_point(probe, objective)
    parameters = _own_parameters(probe, objective)
    try:
        here = _readings(objective, z, unread)
        return any(
            bool(
                np.any(
                    np.abs(_readings(objective, _with_values(objective, z, ends), unread) - here)
                    > _visible_change(here)
                )
            )
            for ends in ({f.name: f.low for f in parameters}, {f.name: f.high for f in parameters})
        )
    except SimulationFailure:
        return False


def _unmeasured_outputs(objective: Objective) -> list[str]:
    read = {
        name for run in objective.data.runs for name in run.measurements if run.sample_count(name)
    }
    return [name for name in objective.simulator.interface.outputs if name not in read]


def _readings(objective: Objective, z: Array, outputs: Sequence[str]) -> Array:
    values, run = objective.values(z), objective.runs[0]
    compared = simulate_run(
        objective.simulator, objective.data, run, values, objective.tolerance, outputs
    )
    return np.array([compared.model[name] for name in outputs])


def _visible_change(readings: Array) -> Array:
    """(k, n) changes that are more than the tolerance of a solver, by the size of each reading."""
    return np.asarray(
        CRITERIA.noise.assumed_share * np.ptp(readings, axis=1, keepdims=True)
        + 1e-9 * np.abs(readings)
    )
