"""A coupled system that runs: its components at one time, and one step of all of them."""

from __future__ import annotations

import math
import traceback
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypeVar

import numpy as np

from pam_cosim.cosimulation.loops import evaluation_order, torn
from pam_cosim.cosimulation.parts import Component, Connection, Controller, Part, Port
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.simulation import AnyStepper, Inputs, RunFailure
from pam_cosim.simulation.inputs import Pieces, pieces
from pam_cosim.wording import listed, shown

Method = Literal["jacobi", "gauss-seidel"]
Extrapolation = Literal["constant", "linear"]
Loops = Literal["refuse", "delay", "iterate"]
Values = dict[Port, float]
T = TypeVar("T")

_ITERATIONS = 20  # of Newton's method on an algebraic loop
_LOOP_TOLERANCE = 1e-10  # relative, of the variables of an algebraic loop
_NUDGE = 1e-6  # relative, of a variable of a loop for a finite difference
_SAME_TIME = 1e-9  # of a step: times closer than this part of it are one
_ROUNDING = 1e-12  # of the largest time, likewise


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


class ControllerError(InputError):
    """A controller raised an exception or did not return its outputs; ``run`` is what was reached, a ``CoupledRun``."""

    run: Any = None


@dataclass
class Work:
    """What a run costs.

    Attributes:
        component_steps: steps made by each FMU, those that were taken back among them.
        rollbacks: how often the system went back to a saved state.
    """

    component_steps: dict[str, int] = field(default_factory=dict)
    rollbacks: int = 0


@dataclass
class Moment:
    """All that a system is at one time, but for the states of the FMUs."""

    time: float
    values: Values
    slopes: Values


Saved = tuple[dict[str, int], Moment]


class Network:
    """The components of a system in the middle of a run.

    Args:
        components: by name.
        connections: between them.
        steppers: of the FMUs, in initialization mode.
        inputs: of the system over time, by ``component.variable``.
        method: whether components of one step see what those before them have come to.
        extrapolation: what is assumed of an output over a step: that it is held, or goes on along a line.
        loops: what is done about algebraic loops.
        order: of the components in a step.
        observed: further variables to read at every time.
        start_time: [s].
    """

    def __init__(
        self,
        components: Mapping[str, Component],
        connections: Sequence[Connection],
        steppers: Mapping[str, AnyStepper],
        inputs: Inputs | None,
        *,
        method: Method = "gauss-seidel",
        extrapolation: Extrapolation = "constant",
        loops: Loops = "refuse",
        order: Sequence[str] = (),
        observed: Sequence[Port] = (),
        start_time: float = 0.0,
    ) -> None:
        self.components, self.steppers = components, steppers
        self.method, self.extrapolation = method, extrapolation
        self.parts = [name for name in (order or components) if isinstance(components[name], Part)]
        self.controllers = {name: c for name, c in components.items() if isinstance(c, Controller)}
        kept, cut = torn(components, connections) if loops != "refuse" else (list(connections), [])
        self._loop = cut if loops == "iterate" else []
        self._passes = evaluation_order(components, kept, cut)
        self._feeds: dict[str, list[Connection]] = {name: [] for name in components}
        for connection in connections:
            self._feeds[connection.target.component].append(connection)
        self._courses = _courses(inputs)
        self._read = _to_read(components, observed)
        self.signals = sorted({c.source for c in connections}, key=str)
        self.now = Moment(start_time, {}, {})
        self._start = start_time
        self._after = True  # at a time at which an input of the system jumps: its value is that after the jump
        self.work = Work(dict.fromkeys(self.parts, 0))
        self._begin()

    def _begin(self) -> None:
        for name, stepper in self.steppers.items():
            self._of(name, lambda s=stepper, n=name: self._store(n, self._read[n], s.read(self._read[n])))  # type: ignore[misc]
        for name, one in self.controllers.items():
            self.now.values.update({Port(name, output): 0.0 for output in one.outputs})
        self.settle(every_input=True)
        if self.sample(self.now.time, first=True):
            self.settle(every_input=True)
        for name, stepper in self.steppers.items():
            self._of(name, stepper.initialised)
            self._of(name, lambda s=stepper, n=name: self._store(n, self._read[n], s.read(self._read[n])))  # type: ignore[misc]
        self.now.slopes = dict.fromkeys(self.signals, 0.0)

    # --- one step ------------------------------------------------------------------------------------------

    def step(self, duration: float, can_go_back: bool = False) -> None:
        """All components make one step; the outputs are then those at its end.

        Raises:
            CouplingFailure: one of them fails; the system is then between two times.
        """
        begin, time = dict(self.now.values), self.now.time
        advanced: set[str] = set()
        for name in self.parts:
            inputs, slopes = self._over_step(name, time, duration, begin, advanced)
            stepper, names = self.steppers[name], self._read[name]
            self.work.component_steps[name] += 1
            values = self._of(name, lambda: stepper.advance(duration, inputs, slopes, names, can_go_back))  # noqa: B023
            self._store(name, names, values)
            if self.method == "gauss-seidel":
                advanced.add(name)
        self.now.time, self._after = time + duration, False
        self.settle()
        values_now = self.now.values
        self.now.slopes = {s: (values_now[s] - begin[s]) / duration for s in self.signals}
        for name in self.controllers:  # held
            for signal in self.signals:
                if signal.component == name:
                    self.now.slopes[signal] = 0.0

    def _over_step(
        self, name: str, time: float, duration: float, begin: Values, advanced: set[str]
    ) -> tuple[dict[str, float], dict[str, float]]:
        """A component's inputs at the start of a step, and how fast they are to change in it."""
        inputs, slopes = {}, {}
        for variable, (line, _) in self._courses.get(name, {}).items():
            value, slope = line.at(np.array([time + _SAME_TIME * duration]))
            inputs[variable], slopes[variable] = float(value[0]), float(slope[0])
        linear = self.extrapolation == "linear"
        for connection in self._feeds[name]:
            source, variable = connection.source, connection.target.variable
            start = begin[source]
            rate = self.now.slopes.get(source, 0.0) if linear else 0.0
            if source.component in advanced:
                end = self.now.values[source]
                start, rate = (start, (end - start) / duration) if linear else (end, 0.0)
            inputs[variable] = connection(start)
            slopes[variable] = connection.factor * rate
        return inputs, slopes

    def settle(self, every_input: bool = False) -> None:
        """Reads again what depends at once on an input, now that all inputs are known.

        Raises:
            CouplingFailure: a component fails, or an algebraic loop has no solution.
        """
        if every_input:
            for name in self.parts:
                inputs = self._inputs_now(name)
                stepper, names = self.steppers[name], self._read[name]
                self._of(name, lambda: self._store(name, names, stepper.read(names, inputs)))  # noqa: B023
        if self._loop:
            self._solve_loop()
        else:
            self._pass()

    def _pass(self) -> None:
        for name in self._passes:
            inputs, names = self._inputs_now(name), self._read[name]
            stepper = self.steppers[name]
            self._of(name, lambda: self._store(name, names, stepper.read(names, inputs)))  # noqa: B023

    def _solve_loop(self) -> None:
        """Newton's method for the variables at which the algebraic loops were cut."""
        sources = list(dict.fromkeys(c.source for c in self._loop))
        guess = np.array([self.now.values[s] for s in sources])

        def residual(z: np.ndarray) -> np.ndarray:
            self.now.values.update(zip(sources, map(float, z), strict=True))
            self._pass()
            return np.array([self.now.values[s] - zi for s, zi in zip(sources, z, strict=True)])

        for _ in range(_ITERATIONS):
            error = residual(guess)
            if np.all(np.abs(error) <= _LOOP_TOLERANCE * (np.abs(guess) + np.abs(guess + error)) + 1e-300):
                return
            slope = np.empty((guess.size, guess.size))
            for i in range(guess.size):
                nudged = guess.copy()
                nudged[i] += _NUDGE * max(abs(guess[i]), abs(error[i]))
                slope[:, i] = (residual(nudged) - error) / (nudged[i] - guess[i])
            try:
                guess = guess - np.linalg.solve(slope, error)
            except np.linalg.LinAlgError:
                break
        loop = ", ".join(map(str, sources))
        raise CouplingFailure(
            sources[0].component, self.components[sources[0].component].model, self.now.time,
            f"the algebraic loop through {loop} has no solution that Newton's method finds",
        )  # fmt: skip

    def _inputs_now(self, name: str) -> dict[str, float]:
        inputs = {v: self._course_at(course, self.now.time) for v, course in self._courses.get(name, {}).items()}
        inputs.update({c.target.variable: c(self.now.values[c.source]) for c in self._feeds[name]})
        return inputs

    def _course_at(self, course: tuple[Pieces, float], time: float) -> float:
        line, near = course
        return float(line.at(np.array([time + near if self._after else time - near]))[0][0])

    # --- events --------------------------------------------------------------------------------------------

    def breaks(self, stop: float) -> list[float]:
        """Times up to ``stop`` at which an input of the system jumps or bends, [s]."""
        times = {float(t) for courses in self._courses.values() for line, _ in courses.values() for t in line.time}
        return sorted(t for t in times if self.now.time < t < stop)

    def event(self, time: float) -> bool:
        """What happens between two steps: inputs that jump, and controllers whose sample it is; whether anything does.

        Raises:
            ControllerError: a controller cannot go on.
        """
        before, self._after = dict(self.now.values), True
        courses = [one for some in self._courses.values() for one in some.values()]
        jumps = any(bool(np.any(np.abs(line.time - time) <= near)) for line, near in courses)
        if jumps:
            self.settle(every_input=True)
        sampled = self.sample(time)
        if sampled:
            self.settle(every_input=True)
        for signal in self.signals:
            if self.now.values[signal] != before[signal]:
                self.now.slopes[signal] = 0.0
        return jumps or sampled

    def sample(self, time: float, first: bool = False) -> bool:
        """Calls the controllers whose sample it is; whether an output of theirs has changed."""
        changed = False
        for name, one in self.controllers.items():
            since = (time - self._start) / one.seconds if not first else 0.0
            if abs(since - round(since)) > _SAME_TIME * max(1.0, abs(since)):
                continue
            inputs = {c.target.variable: c(self.now.values[c.source]) for c in self._feeds[name]}
            inputs |= {v: self._course_at(course, time) for v, course in self._courses.get(name, {}).items()}
            for output, value in _called(name, one, time, inputs).items():
                changed |= self.now.values.get(Port(name, output)) != value
                self.now.values[Port(name, output)] = value
        return changed

    def external(self) -> dict[str, float]:
        """Inputs of the system at the present time, by ``component.variable``."""
        now = self.now.time
        return {f"{c}.{v}": self._course_at(one, now) for c, some in self._courses.items() for v, one in some.items()}

    # --- states --------------------------------------------------------------------------------------------

    def moment(self) -> Moment:
        """A copy of the present time and its values."""
        return Moment(self.now.time, dict(self.now.values), dict(self.now.slopes))

    def save(self) -> Saved:
        """A state of the whole system."""
        states = {name: self._of(name, self.steppers[name].save) for name in self.parts}
        return states, self.moment()

    def restore(self, saved: Saved) -> None:
        """Goes back to a saved state."""
        states, moment = saved
        self.work.rollbacks += 1
        for name, number in states.items():
            self._of(name, lambda: self.steppers[name].restore(number))  # noqa: B023
        self.now = Moment(moment.time, dict(moment.values), dict(moment.slopes))

    def forget(self, saved: Saved) -> None:
        """Frees a saved state."""
        for name, number in saved[0].items():
            self._of(name, lambda: self.steppers[name].forget(number))  # noqa: B023

    def _store(self, name: str, names: Sequence[str], values: Iterable[float]) -> None:
        self.now.values.update({Port(name, n): v for n, v in zip(names, values, strict=True)})

    def _of(self, name: str, call: Callable[[], T]) -> T:
        """Around a call of a component: a failure names it and the time."""
        try:
            return call()
        except CouplingFailure:
            raise
        except SimulationFailure as failure:
            reason = str(failure).rstrip(". ")
            raise CouplingFailure(name, self.components[name].model, self.now.time, reason) from failure


def _to_read(components: Mapping[str, Component], observed: Sequence[Port]) -> dict[str, list[str]]:
    names = {name: list(c.interface.outputs) for name, c in components.items()}
    for one in observed:
        if one.variable not in names[one.component]:
            names[one.component].append(one.variable)
    return names


def _courses(inputs: Inputs | None) -> dict[str, dict[str, tuple[Pieces, float]]]:
    """Inputs of the system by component and variable, with the time [s] after a jump at which it is over."""
    courses: dict[str, dict[str, tuple[Pieces, float]]] = {}
    if inputs is None:
        return courses
    near = _ROUNDING * max(1.0, float(np.max(np.abs(inputs.time))))
    for name, values in inputs.values.items():
        component, _, variable = name.partition(".")
        line = pieces(inputs.time, values, inputs.interpolation)
        courses.setdefault(component, {})[variable] = (line, near)
    return courses


def _called(name: str, one: Controller, time: float, inputs: dict[str, float]) -> dict[str, float]:
    """What a controller returns, checked."""
    where = f"controller '{name}' ({one.model})"
    try:
        answer: Any = one(time, **inputs)
    except Exception as error:  # whatever a user's function raises
        place = traceback.extract_tb(error.__traceback__)[-1]
        what = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
        raise ControllerError(
            f"{where} raised {what} at {time:.6g} s, in line {place.lineno} of {place.filename}"
        ) from error
    values = answer if isinstance(answer, Mapping) else dict.fromkeys(list(one.outputs)[:1], answer)
    if set(values) != set(one.outputs):
        given = f"returned {listed(map(str, values))}" if isinstance(answer, Mapping) else "returned one value"
        raise ControllerError(f"{where} {given} at {time:.6g} s; its outputs are {listed(one.outputs)}")
    numbers = {}
    for output, value in values.items():
        try:
            numbers[output] = float(value)
        except (TypeError, ValueError):
            numbers[output] = math.nan
        if not math.isfinite(numbers[output]):
            raise ControllerError(
                f"{where} returned {output} = {shown(value)} at {time:.6g} s; it must be a finite number"
            )
    return numbers
