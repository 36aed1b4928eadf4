"""One hypothesis in one process: compose, build, fit."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from pam_cosim.catalogue import Composition, EffectClass
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.candidate import Attempt, Candidate, FailedTrial
from pam_cosim.diagnosis.pruning import pruned
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fitting import Fit, FitOptions, Free, base_parameters, fit
from pam_cosim.fmu import build_source
from pam_cosim.interface import Interface
from pam_cosim.measurement import DataSet
from pam_cosim.simulation import Simulator


@dataclass(frozen=True)
class Trial:
    """What a worker needs to try one effect.

    Attributes:
        effect: the effect to try.
        effects: names of all effects in the model, ``effect`` last.
        composition: the model with these effects.
        data: the measurement, with noise levels.
        start: values to start from, by name [SI].
        files: further Modelica files.
        options: how it is fitted.
        further_start: values to start from besides, such as those where screening ended.
    """

    effect: EffectClass
    effects: tuple[str, ...]
    composition: Composition
    data: DataSet
    start: Mapping[str, float] = field(default_factory=dict)
    files: tuple[Path, ...] = ()
    options: FitOptions = FitOptions()
    further_start: Mapping[str, float] = field(default_factory=dict)

    def screening(self) -> Trial:
        """A few steps of the same from one start: enough to tell a promising effect from a hopeless one."""
        numbers = CRITERIA.search
        return self.fitted_with(
            evaluations=numbers.screening_evaluations,
            descents=1,
            screened_starts=0,
            tolerance=numbers.screening_tolerance,
            precision=numbers.screening_precision,
        )

    @property
    def is_screening(self) -> bool:
        """Whether it makes a few steps only: a screening."""
        return self.options.evaluations <= CRITERIA.search.screening_evaluations

    def fitted_with(self, **changes: Any) -> Trial:
        """The same trial with other ``options``."""
        return replace(self, options=replace(self.options, **changes))

    def failed(self, reason: str) -> FailedTrial:
        """The result of this trial where there is no fit."""
        return FailedTrial(self.effect.name, self.effect.family, self.effect.balance, self.effects, reason)

    def candidate(self, fit: Fit) -> Candidate:
        """The result of this trial."""
        return Candidate(
            effect=self.effect.name,
            family=self.effect.family,
            balance=self.effect.balance,
            effects=self.effects,
            own_parameters=tuple(self.composition.parameters[self.effect.name]),
            equations=self.composition.text,
            brief=self.is_screening,
            general=self.effect.general,
            fit=fit,
        )


def crashed(trial: Trial) -> Attempt:
    """The result of a trial whose process died."""
    return trial.failed("the simulation crashed its process")


def run_trial(trial: Trial) -> Attempt:
    """Builds the model and fits the free base parameters together with those of the effects."""
    try:
        own = [name for names in trial.composition.parameters.values() for name in names]
        free = tuple(dict.fromkeys([*trial.data.free_names, *own]))
        fmu = build_source(trial.composition.name, trial.composition.text, trial.files, sensitivities=free)
        with Simulator(fmu) as simulator:
            moved, starts = free_parameters(trial, simulator.interface)
            best = fit(
                simulator,
                trial.data,
                moved,
                starts=starts,
                options=trial.options,
            )
            if trial.effect.general and not trial.is_screening:
                names = trial.composition.parameters[trial.effect.name]
                best = pruned(simulator, trial.data, moved, names, best, trial.options.precision)
            return trial.candidate(best)
    except (SimulationFailure, InputError) as problem:
        return trial.failed(str(problem))
    except Exception as defect:  # whatever one effect runs into must not end the study of the others
        return trial.failed(f"{type(defect).__name__}: {defect}")


def free_parameters(trial: Trial, interface: Interface) -> tuple[tuple[Free, ...], list[dict[str, float]]]:
    """Base parameters and those of the effects, and further points to start from.

    The strength of an unknown effect is uncertain by orders of magnitude: each parameter of the tried effect is
    started at its stated value, and at ten times more and less; in all combinations where they are few. An effect that
    says whatever its family can has many valleys: it is started in combinations of two, and a hundred times off.
    """
    free = list(base_parameters(trial.data, interface))
    known = {f.name for f in free}
    spread: list[list[tuple[str, float]]] = []
    for effect, names in trial.composition.parameters.items():
        for name in names:
            if name in known:
                continue
            v = interface.parameters[name]
            assert v.min is not None and v.max is not None and v.start is not None
            parameter = Free(name, v.min, v.max, v.start, v.unit, v.nominal)
            free.append(parameter)
            if effect == trial.effect.name:
                spread.append([(name, s) for s in _orders(parameter, trial.effect.general)])
    moved = [_from(f, trial.start) for f in free]
    return tuple(moved), [dict(trial.further_start)] * bool(trial.further_start) + _combined(
        spread, trial.effect.general
    )


def _combined(spread: Sequence[Sequence[tuple[str, float]]], pairs: bool) -> list[dict[str, float]]:
    """All combinations of a few parameters' values, or one at a time of many, or two."""
    if not pairs and len(spread) <= CRITERIA.search.combined_parameters:
        return [dict(point) for point in itertools.product(*spread)] if spread else []
    single = [{name: value} for values in spread for name, value in values]
    if not pairs:
        return single
    some = [dict(two) for a, b in itertools.combinations(spread, 2) for two in itertools.product(a[1:3], b[1:3])]
    return single + some


def _orders(free: Free, general: bool) -> Sequence[float]:
    decades = CRITERIA.search.general_decades if general else CRITERIA.search.decades
    values = [free.start * 10.0**k for n in range(decades + 1) for k in (-n, n)]
    return list(dict.fromkeys(min(max(v, free.low), free.high) for v in values))


def _from(free: Free, start: Mapping[str, float]) -> Free:
    value = min(max(start.get(free.name, free.start), free.low), free.high)
    return replace(free, start=value)
