"""From one communication point to the next: fixed steps, or steps chosen by an estimate of their error."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from pam_cosim.cosimulation.network import CouplingFailure, Moment, Network, SystemState
from pam_cosim.cosimulation.parts import Port
from pam_cosim.errors import InputError

# Hairer, Norsett, Wanner, Solving ODEs I, II.4: safety, and how much a step may change at once.
_SAFETY, _SHRINK, _GROW = 0.9, 0.2, 3.0
_EXACT = 1e-10  # an error, over what is allowed, that counts as none
_SMALLEST = 1e-9  # of the run: no step is shorter
_SAME_TIME = 1e-9  # of a step
_FEWEST = 20  # steps in a run, so that the picture of it is not a polygon


@dataclass
class StepControl:
    """How steps are chosen, and what came of it.

    Attributes:
        length: fixed or first step [s].
        tolerance: relative error of a step; None: fixed steps.
        order: of the method: halving the step divides the error of a run by 2 to this power.
        lengths: of the steps made [s].
        rejected: steps taken back.
    """

    length: float
    tolerance: float | None
    order: int
    lengths: list[float] = field(default_factory=list)
    rejected: int = 0


def integrate(
    network: Network,
    plan: StepControl,
    stop: float,
    write_down: Callable[[], None],
    progress: Callable[[float, float], None],
) -> None:
    """Runs the network up to ``stop`` [s], writing down every communication point.

    Raises:
        InputError: an FMU that cannot do what such steps need.
        CouplingFailure: a component fails, or no step is short enough for the tolerance.
        ControllerError: a controller cannot go on.
    """
    _check_abilities(network, plan)
    write_down()
    chooser = _Chooser(network, plan, stop) if plan.tolerance is not None else None
    for index, end in enumerate(_stretches(network, plan, stop)):
        if chooser is None:
            begin = network.now.time
            network.step(end - begin)
            network.now.time = end
            plan.lengths.append(end - begin)
            write_down()
        else:
            chooser.go(end, write_down)
        if network.event():
            write_down()
        if index % 16 == 0 or end == stop:
            progress(end, stop)


def _check_abilities(network: Network, plan: StepControl) -> None:
    for name in network.parts:
        able, model = network.steppers[name].abilities(), network.components[name].model
        if plan.tolerance is not None and not able.saves:
            raise InputError(
                f"component '{name}' ({model}) cannot repeat a step, which error-controlled steps require: its "
                "model description does not declare canGetAndSetFMUstate; use fixed steps, or sample the component as "
                "a controller is sampled (samples=, [samples], --sample)"
            )
        if plan.tolerance is not None and not able.any_step:
            raise InputError(
                f"component '{name}' ({model}) needs steps of one length; use fixed steps"
            )


def _stretches(network: Network, plan: StepControl, stop: float) -> list[float]:
    """Ends of the steps [s], or where their length is chosen, the times that no step may cross."""
    start = network.now.time
    ends = {stop, *network.breaks(stop)}
    grids = list(network.sampling.values())
    if plan.tolerance is None:
        grids.append(plan.length)
    for distance in grids:
        count = math.floor((stop - start) / distance * (1 - _SAME_TIME))
        ends.update(start + i * distance for i in range(1, count + 1))
    ordered: list[float] = []
    tolerance = _SAME_TIME * min([*grids, stop - start])
    for time in sorted(ends):
        if not ordered or time - ordered[-1] > tolerance:
            ordered.append(time)
    if stop - ordered[-1] <= tolerance:
        ordered[-1] = stop
    return ordered


@contextlib.contextmanager
def _instead(failure: CouplingFailure | None) -> Iterator[None]:
    """A component that cannot go back after a failure has that failure, and no other."""
    try:
        yield
    except CouplingFailure as second:
        raise failure or second from None


@dataclass(frozen=True)
class _Trial:
    """A step that was tried.

    Attributes:
        error: over what is allowed.
        worst: the signal that has it; None: a component failed, or there are no signals.
        middle: between the two halves.
        failure: of a component.
    """

    error: float
    worst: Port | None
    middle: Moment
    failure: CouplingFailure | None = None


class _Chooser:
    """Chooses steps so that the error of each, estimated by halving it, is within the tolerance."""

    def __init__(self, network: Network, plan: StepControl, stop: float) -> None:
        self._network, self._plan = network, plan
        self._next = plan.length
        self._largest, self._smallest = stop / _FEWEST, _SMALLEST * stop
        self._nominal = {signal: network.nominal(signal) for signal in network.signals}
        self._seen = dict.fromkeys(network.signals, 0.0)

    def go(self, end: float, write_down: Callable[[], None]) -> None:
        """Up to ``end`` [s]."""
        network = self._network
        while network.now.time < end:
            saved = network.save()
            self._one(saved, end, write_down)
            network.forget(saved)  # where a component fails, its states go with it

    def _one(self, saved: SystemState, end: float, write_down: Callable[[], None]) -> None:
        """One step that stands, in two halves."""
        network, plan, start = self._network, self._plan, self._network.now.time
        while True:
            length, wished = self._length(end - start)
            trial = self._try(saved, length, end if length == end - start else start + length)
            if trial.error <= 1:
                break
            plan.rejected += 1
            with _instead(trial.failure):
                network.restore(saved)
            if length <= self._smallest:
                raise trial.failure or self._too_short(trial, start)
            self._next = max(self._smallest, length * max(_SHRINK, self._factor(trial.error)))
        last = network.now
        for moment in (trial.middle, last):
            network.now = moment
            write_down()
            for signal in network.signals:
                self._seen[signal] = max(self._seen[signal], abs(moment.values[signal]))
        plan.lengths += [trial.middle.time - start, last.time - trial.middle.time]
        proposed = length * min(_GROW, self._factor(trial.error))
        cut_short = length < wished * (1 - _SAME_TIME) and proposed >= length
        self._next = max(self._next, proposed) if cut_short else proposed

    def _length(self, remaining_time: float) -> tuple[float, float]:
        """Of the next step, and what it would be if there was no end [s]; the last two are alike."""
        wished = min(self._next, self._largest)
        if remaining_time <= wished * (1 + _SAME_TIME):
            return remaining_time, wished
        return (remaining_time / 2 if remaining_time < 2 * wished else wished), wished

    def _too_short(self, trial: _Trial, start: float) -> CouplingFailure:
        assert trial.worst is not None
        cause = f"no step is short enough for the tolerance {self._plan.tolerance:g}; the error is in '{trial.worst}'"
        component = trial.worst.component
        return CouplingFailure(component, self._network.components[component].model, start, cause)

    def _factor(self, error: float) -> float:
        """By which the length of a step changes."""
        return (
            _SAFETY * max(error, _EXACT) ** (-1 / (self._plan.order + 1))
            if math.isfinite(error)
            else 0.0
        )

    def _try(self, saved: SystemState, length: float, end: float) -> _Trial:
        """The step as a whole and in halves, at whose end the network then is."""
        network = self._network
        middle = network.now
        try:
            network.step(length, can_go_back=True)
            values_of_one_step = dict(network.now.values)
            network.restore(saved)
            network.step(length / 2, can_go_back=True)
            middle = network.now.copy()
            network.step(end - network.now.time, can_go_back=True)
        except CouplingFailure as failure:
            return _Trial(math.inf, None, middle, failure)
        network.now.time = end
        errors = {
            signal: self._error(signal, network.now.values[signal], values_of_one_step[signal])
            for signal in network.signals
        }
        worst = max(errors, key=lambda signal: errors[signal], default=None)
        return _Trial(errors[worst] if worst is not None else 0.0, worst, middle)

    def _error(self, signal: Port, two_steps: float, one_step: float) -> float:
        """The estimated error of a signal over what is allowed."""
        assert self._plan.tolerance is not None
        scale = max(self._nominal[signal], self._seen[signal], abs(two_steps))
        allowed = self._plan.tolerance * scale * (2**self._plan.order - 1)
        return abs(two_steps - one_step) / allowed if allowed > 0 else 0.0
