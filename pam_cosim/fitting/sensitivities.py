"""The sensitivities that a fit reads from the model: which free parameter acts on which run, and on which signals."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from pam_cosim.fitting.free import Free
from pam_cosim.measurement import Run
from pam_cosim.model.interface import sensitivity_name
from pam_cosim.model.references import is_ratio

Slopes = Mapping[str, Sequence[tuple[int, str]]]
"""By signal: number of a free parameter, and name of the output that is the signal's sensitivity to it."""


def acts_on(free: Free, run: Run, free_parameters: Sequence[Free]) -> bool:
    """Whether a parameter acts on a run: one that is known for it, or is the run's own, does not.

    Args:
        free: the parameter.
        run: the run.
        free_parameters: all free parameters.
    """
    if free.run:
        return free.run == run.name
    if is_ratio(free.name):
        return free.parameter in run.parameters
    has_run_value = any(
        f.run == run.name and f.parameter == free.parameter for f in free_parameters
    )
    return free.parameter not in run.parameters and not has_run_value


def sensitivities_of_run(
    run: Run, signals: Sequence[str], free: Sequence[Free], available: Collection[str]
) -> Slopes:
    """The sensitivities of the signals of a run to the parameters that act on it, where the model has them.

    Args:
        run: the run.
        signals: with samples in it.
        free: the free parameters.
        available: names of the model's sensitivities.
    """
    acting = [
        (i, parameter.parameter)
        for i, parameter in enumerate(free)
        if acts_on(parameter, run, free)
    ]
    return {
        signal: [
            (i, name)
            for i, parameter in acting
            if (name := sensitivity_name(signal, parameter)) in available
        ]
        for signal in signals
    }


def has_sensitivities(
    signals: Sequence[Collection[str]], free: Sequence[Free], available: Collection[str]
) -> list[bool]:
    """For each free parameter, whether the model has its sensitivity for each signal of each run."""
    signal_names = {signal for of_run in signals for signal in of_run}
    return [
        all(sensitivity_name(s, parameter.parameter) in available for s in signal_names)
        for parameter in free
    ]


def outputs_of(slopes: Slopes) -> list[str]:
    """The outputs that are read from the model in a run: the signals, and their sensitivities."""
    return [*slopes, *(name for of_signal in slopes.values() for _, name in of_signal)]
