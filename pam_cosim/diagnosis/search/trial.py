"""One hypothesis in one process: compose, build, fit."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.catalogue import Composition, EffectClass
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Attempt, Candidate, FailedTrial
from pam_cosim.diagnosis.search.probing import (
    EffectProbe,
    Look,
    StatedEffect,
    Strengths,
    probe_effect,
)
from pam_cosim.diagnosis.search.pruning import pruned
from pam_cosim.errors import InputError, ModelChange, SimulationFailure
from pam_cosim.fitting import (
    Fit,
    FitOptions,
    Free,
    Linear,
    base_parameters,
    fit,
    model_parameter,
)
from pam_cosim.fitting.objective import Objective
from pam_cosim.fmu import build_source
from pam_cosim.measurement import DataSet
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import parameter_of
from pam_cosim.simulation import Simulator
from pam_cosim.simulation.models import MOST_ROWS_UNCOMPILED

Result = TypeVar("Result")


@dataclass(frozen=True)
class Trial:
    """What a worker needs to try one effect.

    Attributes:
        effect: the effect to try.
        effects: names of all effects in the model, ``effect`` last.
        composition: the model with these effects.
        data: the measurement, with noise levels.
        start: values to start from, by name [SI]; start values of runs are where a probe has them.
        files: further Modelica files.
        options: how it is fitted.
        further_start: values to start from besides, such as those where a briefer trial ended.
        brief: a few steps only.
        prune: whether what a general member does not need is held at zero.
        library: ``compiler.library_hash()``.
        reference: the fitted base model, for a probe: no parameters are moved then but those of the effect to try.
        general_before: an effect before the one to try is a general member.
    """

    effect: EffectClass
    effects: tuple[str, ...]
    composition: Composition
    data: DataSet
    start: Mapping[str, float] = field(default_factory=dict)
    files: tuple[Path, ...] = ()
    options: FitOptions = FitOptions()
    further_start: Mapping[str, float] = field(default_factory=dict)
    brief: bool = False
    prune: bool = False
    library: str = ""
    reference: Linear | None = None
    general_before: bool = False

    def screening(self) -> Trial:
        """A few steps of the same from one start: enough to tell a promising effect from a hopeless one."""
        numbers = CRITERIA.search
        return replace(
            self.fitted_with(
                evaluations=numbers.screening_evaluations,
                screened_starts=0,
                tolerance=numbers.screening_tolerance,
                precision=numbers.precision,
                second_look=False,
                rules=False,
            ),
            brief=True,
        )

    def fitted_with(self, **changes: Any) -> Trial:
        """The same trial with other ``options``."""
        return replace(self, options=replace(self.options, **changes))

    def without(self, idle: Collection[str]) -> Trial:
        """The same trial with these parameters of its effects at their stated values: no sample depends on them."""
        kept = {
            e: tuple(n for n in names if n not in idle)
            for e, names in self.composition.parameters.items()
        }
        return replace(self, composition=replace(self.composition, parameters=kept))

    def failed(self, reason: str) -> FailedTrial:
        """The result of this trial where there is no fit."""
        return FailedTrial(
            self.effect.name, self.effect.family, self.effect.balance, self.effects, reason
        )

    def candidate(self, fit: Fit) -> Candidate:
        """The result of this trial."""
        parameters = self.composition.parameters
        return Candidate(
            effect=self.effect.name,
            family=self.effect.family,
            balance=self.effect.balance,
            effects=self.effects,
            own_parameters=tuple(parameters[self.effect.name]),
            parameters_before=tuple(n for e in self.effects[:-1] for n in parameters[e]),
            equations=self.composition.text,
            brief=self.brief,
            general=self.effect.general,
            general_before=self.general_before,
            fit=fit,
        )


def crashed(trial: Trial) -> FailedTrial:
    """The result of a trial, or of a probe, whose process died."""
    return trial.failed("the simulation crashed its process")


def run_trial(trial: Trial) -> Attempt:
    """Builds the model and fits the free base parameters together with those of the effects."""
    return attempted(trial, _fitted, brief=trial.brief)


def run_trial_without_samples(trial: Trial) -> Attempt:
    """As ``run_trial``, in another process: the samples stay where they are (``Comparison.without_data``)."""
    attempt = run_trial(trial)
    if isinstance(attempt, FailedTrial):
        return attempt
    return replace(
        attempt, fit=replace(attempt.fit, comparison=attempt.fit.comparison.without_data())
    )


def run_probe(trial: Trial) -> EffectProbe | FailedTrial:
    """Builds the model and linearises it about the values that it starts from, for what its effect can add."""
    return attempted(trial, _probe, brief=True)


def run_stated(trial: Trial) -> StatedEffect | FailedTrial:
    """Builds the model and linearises it about the values that it starts from, its effect as strong as it is stated."""
    return attempted(trial, _stated_effect, brief=True)


def attempted(
    trial: Trial, work: Callable[[Trial, Simulator], Result], brief: bool
) -> Result | FailedTrial:
    """What comes of some work on the model of a trial, which takes few runs or many; a failure is a result too."""
    parameters = trial.composition.parameters
    if trial.reference is None:
        moved = [*trial.data.differentiated, *(n for names in parameters.values() for n in names)]
    else:  # slopes by others are known
        moved = [*parameters[trial.effect.name]]
    free = tuple(dict.fromkeys(map(parameter_of, moved)))
    source, name = trial.composition.text, trial.composition.name
    brief = brief and sum(len(run.time) for run in trial.data.fit_runs) <= MOST_ROWS_UNCOMPILED
    try:
        fmu = build_source(
            name,
            source,
            trial.files,
            sensitivities=free,
            library=trial.library,
            lean=True,
            brief=brief,
        )
        with Simulator(fmu) as simulator:
            simulator.most_steps = CRITERIA.search.longest_run
            return work(trial, simulator)
    except ModelChange:
        raise
    except (SimulationFailure, InputError) as problem:
        return trial.failed(str(problem))
    except (
        Exception
    ) as defect:  # whatever one effect runs into must not end the study of the others
        return trial.failed(f"{type(defect).__name__}: {defect}")


def _fitted(trial: Trial, simulator: Simulator) -> Candidate:
    moved, starts = free_parameters(trial, simulator.interface)
    begins = begin_of(trial, simulator.interface)
    best = fit(simulator, trial.data, moved, fixed=begins, starts=starts, options=trial.options)
    if trial.effect.general and trial.prune:
        names = trial.composition.parameters[trial.effect.name]
        best = pruned(simulator, trial.data, moved, names, best, trial.options.precision)
    return trial.candidate(best)


def begin_of(trial: Trial, interface: Interface) -> dict[str, float]:
    """Where the runs of the model that a trial starts from begin, as far as it has the same states, by "state@run"."""
    return {n: v for n, v in trial.start.items() if n.rpartition("@")[0] in interface.states}


def _look(trial: Trial, simulator: Simulator) -> Look:
    """At the effect to try, beside the model that a trial refers to."""
    assert trial.reference is not None
    free, _ = free_parameters(trial, simulator.interface)
    own = trial.composition.parameters[trial.effect.name]
    moved = tuple(f for f in free if f.name in own)
    objective = Objective(
        simulator,
        trial.data,
        trial.data.fit_runs,
        moved,
        {f.name: f.start for f in free} | begin_of(trial, simulator.interface),
        trial.options.tolerance,
        starts_are_known=True,
    )
    strengths = Strengths(moved, values_where_absent(own, trial.effect.absent))
    return Look(objective, trial.reference, strengths, trial.options.rows)


def _probe(trial: Trial, simulator: Simulator) -> EffectProbe:
    return probe_effect(trial.effect.name, trial.effect.family, _look(trial, simulator))


def values_where_absent(names: Sequence[str], absent: Mapping[str, float]) -> dict[str, float]:
    """By full name, values with which an effect does nothing, where it states them.

    An effect states them by the name within its class; what concerns a parameter of the model, by that one's full name.
    """
    keys = {name: name if name in absent else name.rpartition(".")[2] for name in names}
    return {name: absent[key] for name, key in keys.items() if key in absent}


def values_of_absence(
    members: Sequence[EffectClass], parameters: Mapping[str, Sequence[str]]
) -> dict[str, float]:
    """The same of several effects; ``parameters``: full names of those of each."""
    return {
        name: value
        for e in members
        for name, value in values_where_absent(parameters[e.name], e.absent).items()
    }


def _stated_effect(trial: Trial, simulator: Simulator) -> StatedEffect:
    look = _look(trial, simulator)
    linear = look.linear(look.strengths.place(1.0))
    if linear is None:
        raise SimulationFailure(look.objective.first_failure)
    strength, weaker = 1.0, [linear.residual]
    while len(weaker) < CRITERIA.search.looks and _is_detectable(look.base.residual - weaker[-1]):
        strength *= CRITERIA.search.weaker
        residual = look.residual(strength)
        if residual is None:
            break
        weaker.append(residual)
    return StatedEffect(
        trial.effect.name, trial.effect.family, look.strengths, linear, tuple(weaker[1:])
    )


def _is_detectable(move: Array) -> bool:
    return float(move @ move) > CRITERIA.evidence.very_strong


def free_parameters(
    trial: Trial, interface: Interface
) -> tuple[tuple[Free, ...], list[dict[str, float]]]:
    """Base parameters and those of the effects, and further points to start from.

    The strength of an unknown effect is uncertain by orders of magnitude: each parameter of the tried effect is
    started at its stated value, and at ten times more and less; in all combinations where they are few.
    """
    free = every_parameter(trial.data, trial.composition, interface)
    tried = set(trial.composition.parameters[trial.effect.name]) - trial.data.fit.keys()
    spread = [[(f.name, s) for s in _start_magnitudes(f)] for f in free if f.name in tried]
    moved = tuple(f.starting_at(trial.start.get(f.name, f.start)) for f in free)
    return moved, [dict(trial.further_start)] * bool(trial.further_start) + _start_points(spread)


def every_parameter(data: DataSet, composition: Composition, interface: Interface) -> list[Free]:
    """The free parameters of the data set, and those of the effects of a model with what is typical of them.

    What a data set says of a parameter counts, and not what is typical.
    """
    free = list(base_parameters(data, interface))
    declared = {f.name for f in free}
    added = [
        name for names in composition.parameters.values() for name in names if name not in declared
    ]
    parameters = [model_parameter(name, interface) for name in added]
    typical, limits = composition.typical, composition.limits
    parameters = [
        _outside_readings(f, *limits[f.name], data) if f.name in limits else f for f in parameters
    ]
    return [
        *free,
        *(f.with_typical_range(*typical[f.name]) if f.name in typical else f for f in parameters),
    ]


def _outside_readings(free: Free, side: str, signal: str, data: DataSet) -> Free:
    """The limit of a reading, bounded by what was read: a reading is never beyond its limit by more than its noise."""
    readings = [run.measurements[signal] for run in data.runs if run.sample_count(signal)]
    if not readings:
        return free
    values = np.concatenate(readings)
    noise = CRITERIA.noise.outlier_far * data.signals[signal].sigma
    low, high = free.low, free.high
    if side == "above":
        low = min(max(low, float(np.nanmax(values)) - noise), high)
    else:
        high = max(min(high, float(np.nanmin(values)) + noise), low)
    return replace(free, low=low, high=high).starting_at(free.start)


def _start_points(spread: Sequence[Sequence[tuple[str, float]]]) -> list[dict[str, float]]:
    """All combinations of a few parameters' values, or one at a time of many."""
    if len(spread) <= CRITERIA.search.combined_parameters:
        return [dict(point) for point in itertools.product(*spread)] if spread else []
    return [{name: value} for values in spread for name, value in values]


def _start_magnitudes(free: Free) -> Sequence[float]:
    values = [free.start * 10.0**k for n in range(CRITERIA.search.decades + 1) for k in (-n, n)]
    return list(dict.fromkeys(min(max(v, free.low), free.high) for v in values))
