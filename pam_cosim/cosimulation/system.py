"""A coupled system: what it is made of, and how it is run."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from pam_cosim.cosimulation.coupled_run import CoupledRun
from pam_cosim.cosimulation.loops import algebraic_loop, refuse_loop
from pam_cosim.cosimulation.master import StepControl, integrate
from pam_cosim.cosimulation.network import (
    CouplingFailure,
    Extrapolation,
    Loops,
    Method,
    Network,
    RunCost,
)
from pam_cosim.cosimulation.parts import (
    Component,
    Connection,
    Controller,
    CoupledFmu,
    Port,
    check_name,
    check_once,
    port,
)
from pam_cosim.cosimulation.recorder import Recorder
from pam_cosim.cosimulation.rig import positive_seconds
from pam_cosim.cosimulation.sampling import ControllerError
from pam_cosim.counts import checked_time
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.settings import Setting, settable, value_of
from pam_cosim.simulation import (
    AnySimulator,
    Inputs,
    IsolatedSimulator,
    Simulator,
)
from pam_cosim.simulation.stepper import Stepper
from pam_cosim.units import UnitError, seconds
from pam_cosim.wording import Printed, did_you_mean, shown

METHODS = ("jacobi", "gauss-seidel")
EXTRAPOLATIONS = ("constant", "linear")
LOOPS = ("refuse", "delay", "iterate")
_MOST_PROCESSES = 32  # of FMUs of others
_STEPS = 1000  # of a run without a stated step
MOST_STEPS = 10_000_000


@dataclass(frozen=True)
class System(Printed):
    """Components and the connections between them; ``couple`` makes it.

    Attributes:
        components: by name, in the order in which Gauss-Seidel takes them.
        connections: between outputs and inputs.
        values: parameters, start values and inputs that are held, by component [the model's own units].
        timeout: as in ``simulate``.
        title: for people.
        stop_time: of a run without a stated one [s]; None: the longest of the FMUs' own.
        scratch: keeps the FMUs' files, where they were unpacked for this system.
    """

    components: Mapping[str, Component]
    connections: tuple[Connection, ...]
    values: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    timeout: float | None = None
    title: str = ""
    stop_time: float | None = None
    scratch: object = field(default=None, repr=False, compare=False)

    def __post_init__(self) -> None:
        if self.timeout is not None:
            checked_time(self.timeout)
        if not any(c.seconds is None for c in self.components.values()):
            raise InputError("a system needs an FMU at least that makes every step")
        for name in self.components:
            check_name(name)
        apart = sum(isinstance(c, CoupledFmu) and c.foreign for c in self.components.values())
        if apart > _MOST_PROCESSES:
            raise InputError(
                f"{apart} FMUs would run in a process each, and {_MOST_PROCESSES} can; couple fewer, or join some of "
                "them into one FMU"
            )
        given = {f"{c}.{n}": "a value" for c, values in self.values.items() for n in values}
        check_once(self.connections, given)

    def __str__(self) -> str:
        lines = [self.title] * bool(self.title)
        for name, component in self.components.items():
            samples = f", every {component.seconds:.6g} s" if component.seconds is not None else ""
            lines.append(f"{name}: {component.model}{samples}")
        lines += [f"  {connection}" for connection in self.connections]
        if loop := self.algebraic_loop:
            lines.append(f"algebraic loop: {' -> '.join(map(str, loop))}")
        return "\n".join(lines)

    @property
    def algebraic_loop(self) -> list[Port]:
        """Variables of which each acts at once on the next, the first again at the end; empty where there is none."""
        return algebraic_loop(self.components, self.connections)

    @property
    def inputs(self) -> dict[str, Variable]:
        """Inputs of the components that are not connected, by ``component.variable``."""
        taken = {str(c.target) for c in self.connections}
        names = {
            f"{c}.{n}": v
            for c, part in self.components.items()
            for n, v in part.interface.inputs.items()
        }
        return {name: variable for name, variable in names.items() if name not in taken}

    @property
    def interface(self) -> Interface:
        """The whole system's, with names ``component.variable``; inputs are those that are not connected."""
        groups: dict[str, dict[str, Variable]] = {"outputs": {}, "parameters": {}, "locals": {}}
        for name, component in self.components.items():
            for group, variables in groups.items():
                group_variables: Mapping[str, Variable] = getattr(component.interface, group)
                variables.update(
                    {
                        f"{name}.{n}": replace(v, name=f"{name}.{n}")
                        for n, v in group_variables.items()
                    }
                )
        inputs = {name: replace(variable, name=name) for name, variable in self.inputs.items()}
        return Interface(
            self.title or "the system",
            inputs,
            groups["outputs"],
            groups["parameters"],
            groups["locals"],
        )

    def having(self, parameters: Mapping[str, Setting]) -> System:
        """The same system with other values, by ``component.variable`` as in ``couple``.

        Raises:
            InputError: an unknown name, or a value that cannot be used.
        """
        for name in parameters:
            settable(name, self.interface)
        values = {name: dict(values_of_part) for name, values_of_part in self.values.items()}
        for component, values_of_part in couple_values(parameters, self.components).items():
            values[component] = values.get(component, {}) | values_of_part
        return replace(self, values=values)

    def sampling(self, samples: Mapping[str, float | str]) -> System:
        """The same system with FMUs that act at samples, as a controller does, by name: [s], or a text such as "10 ms".

        Raises:
            InputError: an unknown name, one that is no FMU, or no such time.
        """
        components = dict(self.components)
        for name, interval in samples.items():
            part = components.get(name)
            if not isinstance(part, CoupledFmu):
                fmu_names = [n for n, c in components.items() if isinstance(c, CoupledFmu)]
                raise InputError(
                    f"there is no FMU '{name}' in the system; {did_you_mean(name, fmu_names)}"
                )
            components[name] = replace(part, seconds=positive_seconds(interval))
        return replace(self, components=components)

    def simulate(
        self,
        stop_time: float | str | None = None,
        *,
        method: Method = "gauss-seidel",
        step: float | str | None = None,
        tolerance: float | None = None,
        extrapolation: Extrapolation = "linear",
        loops: Loops = "refuse",
        inputs: Inputs | None = None,
        outputs: Sequence[str] = (),
        order: Sequence[str] = (),
        solver_tolerance: float | None = None,
        progress: Callable[[float, float], None] = lambda time, stop: None,
    ) -> CoupledRun:
        """Runs the system from zero.

        Args:
            stop_time: [s], or a text such as "500 ms"; default: the longest of the FMUs' own.
            method: "jacobi": all components make a step at once, from what was known at its start; "gauss-seidel": one
                after the other, each with what those before it have come to.
            step: between communication points; with ``tolerance`` the first one. Default: a thousandth of the run.
            tolerance: relative error of a step, by which steps are chosen: each is made once whole and once in halves,
                and taken back if the two differ by more. None: fixed steps.
            extrapolation: what is assumed of an output over a step: "constant", or "linear" from the step before.
            loops: algebraic loops: "refuse", "iterate" (Newton's method at every communication point), or "delay" (one
                connection of each loop is taken a step late).
            inputs: of the system over time, by ``component.variable``.
            outputs: further variables of components to record, such as "muscle.load.v".
            order: of the components for Gauss-Seidel; default: that of the system.
            solver_tolerance: relative, of the solvers inside the FMUs.
            progress: called with the time reached and the end [s].

        Raises:
            InputError: names or numbers that cannot be used, an algebraic loop that is not to be solved, an FMU that
                cannot go back where steps are chosen by their error; a controller that raised an exception
                (``ControllerError``).
            SimulationFailure: (``CouplingFailure``) a component failed; the error names it and the time.
                Both errors then have what was reached as ``run``, a ``CoupledRun``.
        """
        _choice("method", method, METHODS)
        _choice("extrapolation", extrapolation, EXTRAPOLATIONS)
        _choice("loops", loops, LOOPS)
        if loops == "refuse":
            refuse_loop(self.components, self.connections)
        observed = [self._observed(name) for name in outputs]
        self._check_inputs(inputs)
        self._check_order(order)
        stop = self._stop(stop_time, inputs)
        plan = self._plan(step, tolerance, extrapolation, stop)
        with self._running(solver_tolerance) as steppers:
            network = Network(
                self.components,
                self.connections,
                steppers,
                inputs,
                method=method,
                extrapolation=extrapolation,
                loops=loops,
                order=order,
                observed=observed,
            )
            recorder = Recorder(self._columns(observed, inputs))
            try:
                integrate(
                    network,
                    plan,
                    stop,
                    lambda: self._write_down(network, recorder, inputs),
                    progress,
                )
            except (CouplingFailure, ControllerError) as error:
                error.run = _run(recorder, method, plan, network.work)
                raise
            warnings = [
                f"{name}: {text}"
                for name, stepper in steppers.items()
                for text in dict.fromkeys(stepper.take_messages())
            ]
            return _run(recorder, method, plan, network.work, warnings)

    def _plan(
        self, step: float | str | None, tolerance: float | None, extrapolation: str, stop: float
    ) -> StepControl:
        if tolerance is not None and not (tolerance > 0 and math.isfinite(tolerance)):
            raise InputError(f"the tolerance of a step must be larger than zero, not {tolerance}")
        length = stop / _STEPS if step is None else _time("step", step)
        if tolerance is None and stop / length > MOST_STEPS:
            raise InputError(
                f"a run has {MOST_STEPS} steps at most; {stop:g} s in steps of {length:g} s are more"
            )
        order = 2 if extrapolation == "linear" else 1
        return StepControl(min(length, stop), tolerance, order)

    def _stop(self, stop_time: float | str | None, inputs: Inputs | None) -> float:
        if stop_time is not None:
            return _time("stop time", stop_time)
        if inputs is not None and inputs.time[-1] > 0:
            return float(inputs.time[-1])
        stop_times = [
            c.interface.stop_time for c in self.components.values() if isinstance(c, CoupledFmu)
        ]
        return self.stop_time or max(stop_times)

    @contextlib.contextmanager
    def _running(self, tolerance: float | None) -> Iterator[dict[str, Stepper]]:
        """The FMUs, in initialization mode; they are closed at the end."""
        with contextlib.ExitStack() as stack:
            steppers: dict[str, Stepper] = {}
            for name, part in self.components.items():
                if not isinstance(part, CoupledFmu):
                    continue
                try:
                    simulator = self._opened(part)
                    stack.callback(simulator.close)
                    steppers[name] = simulator.stepper()
                    steppers[name].begin(self.values.get(name, {}), 0.0, tolerance)
                except SimulationFailure as failure:
                    raise CouplingFailure(name, part.model, 0.0, str(failure)) from failure
            yield steppers

    def _opened(self, part: CoupledFmu) -> AnySimulator:
        return IsolatedSimulator(part.path, self.timeout) if part.foreign else Simulator(part.path)

    def _observed(self, name: str) -> Port:
        end = port(name, self.components)
        interface = self.components[end.component].interface
        variables = interface.variables
        if end.variable not in variables:
            raise InputError(
                f"{interface.model} has no variable '{end.variable}'; {did_you_mean(end.variable, variables)}"
            )
        return end

    def _check_inputs(self, inputs: Inputs | None) -> None:
        for name in inputs.values if inputs is not None else ():
            if name not in self.inputs:
                if name in {str(c.target) for c in self.connections}:
                    raise InputError(f"input '{name}' is connected and cannot be given over time")
                raise InputError(
                    f"the system has no free input '{name}'; {did_you_mean(name, self.inputs)}"
                )
            component, _, variable = name.partition(".")
            if variable in self.values.get(component, {}):
                raise InputError(
                    f"the input '{name}' is given over time and as a constant; keep one of them"
                )

    def _check_order(self, order: Sequence[str]) -> None:
        parts = [name for name, c in self.components.items() if c.seconds is None]
        if order and sorted(order) != sorted(parts):
            raise InputError(f"the order must name each FMU once: {', '.join(parts)}")

    def _columns(self, observed: Sequence[Port], inputs: Inputs | None) -> dict[str, str]:
        units = {
            f"{name}.{n}": v.unit
            for name, part in self.components.items()
            for n, v in part.interface.outputs.items()
        }
        for end in observed:
            units[str(end)] = self.components[end.component].interface.variables[end.variable].unit
        units.update(
            {name: self.inputs[name].unit for name in (inputs.values if inputs is not None else ())}
        )
        return units

    def _write_down(self, network: Network, recorder: Recorder, inputs: Inputs | None) -> None:
        values = {str(port): value for port, value in network.now.values.items()}
        values.update(network.external())
        recorder.add(network.now.time, [values[name] for name in recorder.units])


def couple_values(
    parameters: Mapping[str, Setting], components: Mapping[str, Component]
) -> dict[str, dict[str, float]]:
    """Settings by ``component.variable``, by component and in the model's own units.

    Raises:
        InputError: an unknown name, or a value that cannot be used.
    """
    values: dict[str, dict[str, float]] = {}
    for name, value in parameters.items():
        end = port(name, components)
        if isinstance(components[end.component], Controller):
            raise InputError(f"'{name}': a controller's inputs come from connections or over time")
        variable = settable(end.variable, components[end.component].interface)
        values.setdefault(end.component, {})[end.variable] = value_of(value, variable)
    return values


def _time(what: str, value: float | str) -> float:
    try:
        length = seconds(value)
    except UnitError as problem:
        raise InputError(f"the {what}: {problem}") from None
    if not length > 0:
        raise InputError(f"the {what} must be larger than zero, not {value}")
    return length


def _choice(what: str, value: str, choices: Sequence[str]) -> None:
    if value not in choices:
        raise InputError(f"unknown {what} {shown(value)}; {did_you_mean(str(value), choices)}")


def _run(
    recorder: Recorder,
    method: str,
    plan: StepControl,
    work: RunCost,
    warnings: Sequence[str] = (),
) -> CoupledRun:
    sizes = plan.lengths or [0.0]
    return CoupledRun(
        recorder.trajectory(warnings),
        method,
        len(plan.lengths),
        plan.rejected,
        dict(work.component_steps),
        work.rollbacks,
        min(sizes),
        max(sizes),
    )
