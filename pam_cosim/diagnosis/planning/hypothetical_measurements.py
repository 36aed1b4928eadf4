"""A data set as it would be if the model were the rig, with whatever further could be measured on it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import simulate_run
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.next_experiment import FACTORS, variations
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, Run, Signal
from pam_cosim.simulation import AnySimulator
from pam_cosim.units import format_quantity

_ASSUMED_NOISE = 0.005  # of the span of a signal: noise of an instrument that does not exist yet
REST_RANGE = 1e-9  # of its largest value: a signal that moves less is at rest


@dataclass(frozen=True)
class Option:
    """Something that could be measured; the first of all is what was.

    Attributes:
        kind: "signal", "run", or "" for what was measured.
        text: what it is, in words.
    """

    kind: str = ""
    text: str = ""


AS_MEASURED = Option()


@dataclass(frozen=True)
class AllOutputs:
    """All that could be measured, as samples of the model.

    Attributes:
        data: with every output as a signal, and the runs that there could be among those to be fitted.
        option: by run and signal, which option each series of samples belongs to.
    """

    data: DataSet
    option: Mapping[tuple[str, str], Option]


def with_all_outputs(simulator: AnySimulator, data: DataSet) -> AllOutputs:
    """What was measured in fitted runs, the outputs that were not, and variations of the longest run.

    Args:
        simulator: the model.
        data: the measurement, with noise levels.

    Raises:
        SimulationFailure: a run of the data set does not reach its end.
    """
    modelled = {run.name: _modelled(simulator, data, run) for run in data.fit_runs}
    signals = {**data.signals, **_unmeasured(simulator, data, list(modelled.values()))}
    # where a reading would lie between two steps nobody knows: rounding is noise here
    signals = {name: replace(s, fitted=True, step=0.0) for name, s in signals.items() if s.sigma}
    discrete = {n for n, v in simulator.interface.inputs.items() if v.is_discrete}
    runs: list[Run] = []
    option: dict[tuple[str, str], Option] = {}
    for run in data.fit_runs:
        runs.append(_as_modelled(run, modelled[run.name], signals))
        for name, signal in signals.items():
            measured = run.sample_count(name) and data.signals[name].fitted
            option[run.name, name] = (
                AS_MEASURED if measured else Option("signal", _measurement_text(signal))
            )
    for number, (varied, change) in enumerate(_varied_runs(data, discrete)):
        try:
            model = _modelled(simulator, data, varied)
        except SimulationFailure:
            continue
        name = f"{varied.name} #{number}"
        measured_signals = {
            n: s for n, s in data.signals.items() if s.fitted and varied.sample_count(n)
        }
        runs.append(replace(_as_modelled(varied, model, measured_signals), name=name))
        for measured_too in runs[-1].measurements:
            option[name, measured_too] = Option("run", f"a run like {varied.name}: {change}")
    return AllOutputs(replace(data, signals=signals, runs=tuple(runs)), option)


def _modelled(simulator: AnySimulator, data: DataSet, run: Run) -> dict[str, Array]:
    tolerance = CRITERIA.search.screening_tolerance
    return simulate_run(simulator, data, run, {}, tolerance).model


def _as_modelled(run: Run, model: Mapping[str, Array], signals: Mapping[str, Signal]) -> Run:
    """A run with the model's values for samples: where there were some, or everywhere for a signal that had none."""
    measured = {
        name: np.where(np.isfinite(run.measurements[name]), model[name], np.nan)
        if run.sample_count(name)
        else model[name]
        for name in signals
    }
    return replace(run, measurements=measured, role="fit")


def _unmeasured(
    simulator: AnySimulator, data: DataSet, modelled: Sequence[Mapping[str, Array]]
) -> dict[str, Signal]:
    """Outputs that nobody measured, with the noise of a usual instrument; none that stand still."""
    signals = {}
    for name, output in simulator.interface.outputs.items():
        if name not in data.signals:
            values = np.concatenate([model[name] for model in modelled])
            span = float(values.max() - values.min())
            if span > REST_RANGE * float(np.abs(values).max()):
                signals[name] = Signal(name, output.unit, _ASSUMED_NOISE * span, estimated=True)
    return signals


def _measurement_text(signal: Signal) -> str:
    return f"{signal.name} in every run, to {format_quantity(signal.sigma, signal.unit, 2)}"


def _varied_runs(data: DataSet, discrete: Collection[str]) -> Iterator[tuple[Run, str]]:
    """The run with most samples, made once more with one thing changed that is not ``discrete``, as a switch is."""
    longest = max(data.fit_runs, key=lambda run: len(run.time))
    factors = FACTORS
    for variation in variations(data, [longest], (min(factors), max(factors))):
        if not any(name in discrete for name in variation.factors):
            yield variation.run, variation.change
