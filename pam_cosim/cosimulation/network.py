"""A coupled system that runs: its components at one time, and one step of all of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.cosimulation.input_lines import InputLines
from pam_cosim.cosimulation.loops import evaluation_order, torn
from pam_cosim.cosimulation.parts import Component, Connection, Controller, CoupledFmu, Port
from pam_cosim.cosimulation.sampling import sampled
from pam_cosim.errors import SimulationFailure
from pam_cosim.simulation import Inputs, RunFailure
from pam_cosim.simulation.stepper import Stepper

Method = Literal["jacobi", "gauss-seidel"]
Extrapolation = Literal["constant", "linear"]
Loops = Literal["refuse", "delay", "iterate"]
Values = dict[Port, float]

_ITERATIONS = 20  # of Newton's method on an algebraic loop
_LOOP_TOLERANCE = 1e-10  # of the size of a variable of an algebraic loop
_NUDGE = 1e-6  # of the size of a variable of a loop for a finite difference
_SAME_TIME = 1e-9  # of the distance of two samples


class CouplingFailure(RunFailure):
    """A component of a coupled system failed.

    Attributes:
        component: which one.
        cause: what it reported.
        reached: the last time of all components [s].
        run: what was reached, a ``CoupledRun``.
    """

    run: Any = None

    def __init__(self, component: str, model: str, time: float, cause: str) -> None:
        super().__init__(f"component '{component}' ({model}) failed: {cause}")
        self.component, self.cause, self.reached = component, cause, time

    def __str__(self) -> str:
        return f"{self.reason} (coupled up to {self.reached:.6g} s)"


@dataclass
class RunCost:
    """What a run costs.

    Attributes:
        component_steps: steps made by each FMU, those that were taken back among them.
        rollbacks: how often the system went back to a saved state.
    """

    component_steps: dict[str, int] = field(default_factory=dict)
    rollbacks: int = 0


@dataclass
class Moment:
    """All that a system is at one time, but for the states of the FMUs.

    Attributes:
        time: [s].
        values: of every variable that is read.
        slopes: of the outputs that are connected, over the step before [1/s].
    """

    time: float
    values: Values
    slopes: Values

    def copy(self) -> Moment:
        """One that does not change with this one."""
        return Moment(self.time, dict(self.values), dict(self.slopes))


@dataclass(frozen=True)
class SystemState:
    """A state of a whole system: the numbers of the FMUs' states, and the rest."""

    states: Mapping[str, int]
    moment: Moment


class Network:
    """The components of a system in the middle of a run.

    Args:
        components: by name.
        connections: between them.
        steppers: of the FMUs, in initialization mode.
        inputs: of the system over time, by ``component.variable``.
        method: whether components of one step see what those before them have come to.
        extrapolation: what is assumed of an output over a step: that it is held, or is extrapolated linearly.
        loops: what is done about algebraic loops.
        order: of the components in a step.
        observed: further variables to read at every time.

    Raises:
        CouplingFailure: a component cannot be initialised.
        ControllerError: a controller cannot make its first sample.
    """

    def __init__(
        self,
        components: Mapping[str, Component],
        connections: Sequence[Connection],
        steppers: Mapping[str, Stepper],
        inputs: Inputs | None,
        *,
        method: Method = "gauss-seidel",
        extrapolation: Extrapolation = "constant",
        loops: Loops = "refuse",
        order: Sequence[str] = (),
        observed: Sequence[Port] = (),
    ) -> None:
        self.components, self.steppers = components, steppers
        self.sampling = _sampling(components)
        fmus = [name for name, c in components.items() if isinstance(c, CoupledFmu)]
        self.parts = [name for name in (order or fmus) if name not in self.sampling]
        self._sampled_fmus = [name for name in fmus if name in self.sampling]
        self.signals = sorted({c.source for c in connections}, key=str)
        self.work = RunCost(dict.fromkeys(fmus, 0))
        self._sequential, self._linear = method == "gauss-seidel", extrapolation == "linear"
        self._loop, self._passes = _loop_and_passes(components, connections, loops)
        self._loop_sizes = np.array([self.nominal(source) for source in self._loop])
        self._feeds = _feeds(components, connections)
        self._lines = InputLines(inputs)
        self._after = True  # at a time at which an input of the system jumps: its value is that after the jump
        self._read = _to_read(components, observed)
        self._naming = {name: _Naming(self, name) for name in components}
        self.now = Moment(0.0, {}, {})
        self._begin()

    def _begin(self) -> None:
        for name, component in self.components.items():
            self.now.values.update(
                {Port(name, output): 0.0 for output in component.interface.outputs}
            )
        for name in (*self.parts, *self._sampled_fmus):
            self._refresh(name, {})
        self._settle_all()
        if self._sample(0.0):
            self._settle_all()
        for name in (*self.parts, *self._sampled_fmus):
            with self._naming[name]:
                self.steppers[name].initialised()
            self._refresh(name, {})
        self.now.slopes = dict.fromkeys(self.signals, 0.0)

    def nominal(self, signal: Port) -> float:
        """The size of an output that its model declares; 0: it does not."""
        component = self.components[signal.component]
        if not isinstance(component, CoupledFmu):
            return 0.0
        return abs(component.interface.outputs[signal.variable].nominal or 0.0)

    # --- one step ------------------------------------------------------------------------------------------

    def step(self, duration: float, can_go_back: bool = False) -> None:
        """All components make one step; the outputs are then those at its end.

        Raises:
            CouplingFailure: one of them fails; the system is then between two times.
        """
        begin, time = dict(self.now.values), self.now.time
        advanced: set[str] = set()
        for name in self.parts:
            inputs, slopes = self._over_step(name, duration, begin, advanced)
            self.work.component_steps[name] += 1
            with self._naming[name]:
                values = self.steppers[name].advance(
                    duration, inputs, slopes, self._read[name], can_go_back
                )
            self._store(name, values)
            if self._sequential:
                advanced.add(name)
        self.now.time, self._after = time + duration, False
        self._settle()
        self.now.slopes = {s: (self.now.values[s] - begin[s]) / duration for s in self.signals}

    def _over_step(
        self, name: str, duration: float, begin: Values, advanced: set[str]
    ) -> tuple[dict[str, float], dict[str, float]]:
        """A component's inputs at the start of a step, and how fast they are to change in it."""
        inputs, slopes = self._lines.over_step(name, self.now.time, duration)
        for connection in self._feeds[name]:
            source, variable = connection.source, connection.target.variable
            value, rate = begin[source], self.now.slopes.get(source, 0.0) if self._linear else 0.0
            if source.component in advanced:  # where it has come to is known
                end = self.now.values[source]
                value, rate = (value, (end - value) / duration) if self._linear else (end, 0.0)
            inputs[variable], slopes[variable] = connection(value), connection.factor * rate
        return inputs, slopes

    # --- consistent values at one time ---------------------------------------------------------------------

    def _settle_all(self) -> None:
        """Sets all inputs again and reads all outputs."""
        for name in self.parts:
            self._refresh(name, self._inputs_now(name))
        self._settle()

    def _settle(self) -> None:
        """Reads again what depends at once on an input, now that all inputs are known."""
        if self._loop:
            self._solve_loop()
        else:
            self._pass()

    def _pass(self) -> None:
        for name in self._passes:
            self._refresh(name, self._inputs_now(name))

    def _solve_loop(self) -> None:
        """Newton's method for the outputs at which the algebraic loops were cut."""
        guess = np.array([self.now.values[source] for source in self._loop])
        best = np.inf
        for _ in range(_ITERATIONS):
            error = self._residual(guess)
            sizes = np.max([self._loop_sizes, np.abs(guess), np.abs(guess + error)], axis=0)
            miss = float(np.max(np.abs(error) / np.maximum(sizes, 1.0)))
            # of a variable that has only been zero nothing but rounding remains, which has no size to be compared with
            is_rounding = best <= miss <= _LOOP_TOLERANCE
            if is_rounding or np.all(np.abs(error) <= _LOOP_TOLERANCE * sizes):
                self._loop_sizes = np.maximum(self._loop_sizes, np.abs(guess))
                return
            best = min(best, miss)
            try:
                guess = guess - np.linalg.solve(self._slope(guess, error, sizes), error)
            except np.linalg.LinAlgError:
                break
        first, loop = self._loop[0], ", ".join(map(str, self._loop))
        cause = f"the algebraic loop through {loop} has no solution that Newton's method finds"
        raise CouplingFailure(
            first.component, self.components[first.component].model, self.now.time, cause
        )

    def _residual(self, guess: Array) -> Array:
        """What the outputs come to, less the guess that went round the loop."""
        self.now.values.update(zip(self._loop, map(float, guess), strict=True))
        self._pass()
        return np.array([self.now.values[s] - z for s, z in zip(self._loop, guess, strict=True)])

    def _slope(self, guess: Array, error: Array, sizes: Array) -> Array:
        """The residual's derivatives by finite differences, as a matrix."""
        columns = []
        for i in range(guess.size):
            nudged = guess.copy()
            nudged[i] += _NUDGE * (sizes[i] or 1.0)
            columns.append((self._residual(nudged) - error) / (nudged[i] - guess[i]))
        return np.stack(columns, axis=1)

    def _inputs_now(self, name: str) -> dict[str, float]:
        inputs = self._lines.at(name, self.now.time, self._after)
        inputs.update({c.target.variable: c(self.now.values[c.source]) for c in self._feeds[name]})
        return inputs

    def external(self) -> dict[str, float]:
        """Inputs of the system at the present time, by ``component.variable``."""
        return self._lines.every(self.now.time, self._after)

    # --- events --------------------------------------------------------------------------------------------

    def breaks(self, stop: float) -> list[float]:
        """Times up to ``stop`` at which an input of the system jumps or bends, [s]."""
        return self._lines.turns(self.now.time, stop)

    def event(self) -> bool:
        """What happens between two steps: inputs that jump, and samples; whether anything does.

        Raises:
            CouplingFailure: a component fails.
            ControllerError: a controller cannot go on.
        """
        before, self._after = dict(self.now.values), True
        jumps = self._lines.turn(self.now.time)
        if jumps:
            self._settle_all()
        changes = self._sample(self.now.time)
        if changes:
            self._settle_all()
        for signal in self.signals:
            if self.now.values[signal] != before[signal]:
                self.now.slopes[signal] = 0.0  # the previous slope does not hold any more
        return jumps or changes

    def _sample(self, time: float) -> bool:
        """What samples at this time acts; whether an output of it has changed."""
        changed = False
        for name, distance in self.sampling.items():
            samples = time / distance
            if abs(samples - round(samples)) > _SAME_TIME * max(1.0, abs(samples)):
                continue
            for output, value in self._acting(name, time, distance).items():
                changed |= self.now.values[Port(name, output)] != value
                self.now.values[Port(name, output)] = value
        return changed

    def _acting(self, name: str, time: float, distance: float) -> Mapping[str, float]:
        """The outputs of what samples; an FMU makes the step up to now, at the start it is read alone."""
        component, inputs = self.components[name], self._inputs_now(name)
        if isinstance(component, Controller):
            return sampled(name, component, time, inputs)
        stepper, names = self.steppers[name], self._read[name]
        with self._naming[name]:
            if time == 0.0:
                return dict(zip(names, stepper.read(names, inputs), strict=True))
            self.work.component_steps[name] += 1
            return dict(zip(names, stepper.advance(distance, inputs, None, names), strict=True))

    # --- states --------------------------------------------------------------------------------------------

    def save(self) -> SystemState:
        """A state of the whole system."""
        states = {}
        for name in self.parts:
            with self._naming[name]:
                states[name] = self.steppers[name].save()
        return SystemState(states, self.now.copy())

    def restore(self, saved: SystemState) -> None:
        """Goes back to a saved state."""
        self.work.rollbacks += 1
        for name, number in saved.states.items():
            with self._naming[name]:
                self.steppers[name].restore(number)
        self.now = saved.moment.copy()

    def forget(self, saved: SystemState) -> None:
        """Frees a saved state."""
        for name, number in saved.states.items():
            with self._naming[name]:
                self.steppers[name].forget(number)

    def _refresh(self, name: str, inputs: Mapping[str, float]) -> None:
        with self._naming[name]:
            self._store(name, self.steppers[name].read(self._read[name], inputs))

    def _store(self, name: str, values: Sequence[float]) -> None:
        self.now.values.update(
            {Port(name, n): v for n, v in zip(self._read[name], values, strict=True)}
        )


class _Naming:
    """Around the calls of a component: a failure names it and the time."""

    def __init__(self, network: Network, name: str) -> None:
        self._network, self._name = network, name

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: object, failure: BaseException | None, place: object) -> None:
        if isinstance(failure, SimulationFailure):
            network, name = self._network, self._name
            model, reason = network.components[name].model, str(failure).rstrip(". ")
            raise CouplingFailure(name, model, network.now.time, reason) from failure


def _sampling(components: Mapping[str, Component]) -> dict[str, float]:
    """Of the components that sample, the distance of two samples [s]."""
    distances = {name: component.seconds for name, component in components.items()}
    return {name: seconds for name, seconds in distances.items() if seconds is not None}


def _loop_and_passes(
    components: Mapping[str, Component], connections: Sequence[Connection], loops: Loops
) -> tuple[list[Port], list[str]]:
    """The outputs for which algebraic loops are solved, and the order in which components are read at one time."""
    kept, cut = list(connections), list[Connection]()
    if loops != "refuse":
        kept, cut = torn(components, connections)
    sources = dict.fromkeys(connection.source for connection in cut)
    passes = evaluation_order(components, kept, cut)
    return (list(sources) if loops == "iterate" else []), passes


def _feeds(
    components: Mapping[str, Component], connections: Sequence[Connection]
) -> dict[str, list[Connection]]:
    """The connections that end at each component."""
    feeds: dict[str, list[Connection]] = {name: [] for name in components}
    for connection in connections:
        feeds[connection.target.component].append(connection)
    return feeds


def _to_read(components: Mapping[str, Component], observed: Sequence[Port]) -> dict[str, list[str]]:
    names = {name: list(c.interface.outputs) for name, c in components.items()}
    for p in observed:
        if p.variable not in names[p.component]:
            names[p.component].append(p.variable)
    return names
