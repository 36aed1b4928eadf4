"""A run of an FMU by its model-exchange interface: its equations, integrated by CVode of SUNDIALS, as FMPy has it."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from ctypes import c_double
from typing import Any

import numpy as np
from fmpy.fmi1 import FMICallException
from fmpy.sundials import CVodeSolver
from fmpy.sundials.nvector_serial import NV_DATA_S

from pam_cosim.fmu.description_file import ModelDescription
from pam_cosim.fmu.read import slots
from pam_cosim.simulation.driver import TOO_SLOW, Callbacks, Outcome, Request, RunProgress
from pam_cosim.simulation.instance import Instance, major_version
from pam_cosim.simulation.values import Values

CVODE = "CVode"
_MOST_STEPS = 100_000  # from row to row, as our own solver
_MOST_ITERATIONS = 1000  # of discrete states at one event
_TOLERANCE = 1e-6  # relative, where neither the run nor the FMU states one
_LONGEST_STEP = 0.02  # of a run, as FMPy has it: no short pulse of an input is stepped over
_NO_DISTANCE = 1e-12  # of the time: two points so close are one
_FATAL = 4  # status of FMI: nothing may be called after it


class _Ended(Exception):
    """The run cannot continue; ``function`` names the call."""

    def __init__(self, function: str, reason: str = "") -> None:
        super().__init__(reason)
        self.function = function


class _EndedByModel(Exception):
    """The FMU ends the simulation."""


class _NoInput:
    """The inputs of FMPy's solver: ``_Integrator`` sets them itself."""

    def apply(self, time: float) -> None:
        """Nothing."""


class _Integrator(CVodeSolver):  # type: ignore[misc]
    """CVode on the equations of an FMU.

    A value for which these cannot be computed makes it try a shorter step; what went wrong is kept.
    """

    def __init__(
        self, equations: ExchangeDriver, start: float, longest: float, tolerance: float
    ) -> None:
        model, self._equations = equations.model, equations
        self.problem: Exception | None = None
        rates = (
            model.getContinuousStateDerivatives
            if major_version(model) == 3
            else model.getDerivatives
        )
        super().__init__(
            nx=equations.states,
            nz=equations.indicators,
            get_x=model.getContinuousStates,
            set_x=model.setContinuousStates,
            get_dx=rates,
            get_z=model.getEventIndicators,
            get_nominals=equations.scales,
            set_time=equations.move_to,
            input=_NoInput(),
            startTime=start,
            maxStep=longest,
            relativeTolerance=tolerance,
            maxNumSteps=_MOST_STEPS,
        )

    def f(self, t: float, y: Any, ydot: Any, user_data: Any) -> int:
        """The rates; 1: there are none at this state, -1: there will be none."""
        try:
            self._equations.check_time()
            super().f(t, y, ydot, user_data)
            rates = np.ctypeslib.as_array(NV_DATA_S(ydot), (self.nx,))
            return 0 if np.isfinite(rates).all() else 1
        except Exception as problem:
            return self._noted(problem)

    def g(self, t: float, y: Any, gout: Any, user_data: Any) -> int:
        """The event indicators; likewise."""
        try:
            super().g(t, y, gout, user_data)
            return 0
        except Exception as problem:
            return self._noted(problem)

    def _noted(self, problem: Exception) -> int:
        self.problem = problem
        recoverable = isinstance(problem, FMICallException) and problem.status < _FATAL
        return 1 if recoverable else -1


class ExchangeDriver:
    """As ``Driver``, for an instance for model exchange.

    Args:
        model: FMPy's face of the instance.
        description: of its model.
        callbacks: where its messages arrive.
    """

    settles = False

    def __init__(
        self, model: Instance, description: ModelDescription, callbacks: Callbacks
    ) -> None:
        self.model, self._callbacks = model, callbacks
        self.states = int(description.numberOfContinuousStates)
        self.indicators = int(description.numberOfEventIndicators or 0)
        assert description.modelExchange is not None
        self._told_steps = description.modelExchange.needsCompletedIntegratorStep
        self._tolerance = _given(description)
        self._variables = Values(model, slots(description), major_version(model))
        self._calls, self._function = 0, ""
        self.time = 0.0

    @property
    def progress(self) -> RunProgress | None:
        """As ``Driver.progress``."""
        return RunProgress(self._function, self._calls, self.time) if self._function else None

    def run(self, request: Request) -> Outcome:
        """As ``Driver.run``; there are neither sensitivities nor equilibria."""
        plan = self._plan = request.plan
        self._inputs, self._outputs = list(request.inputs), list(request.outputs)
        self._is_held = self._variables.selection(self._inputs).is_discrete
        self._deadline = time.process_time() + (request.max_seconds or math.inf)
        self._values = np.full((plan.row_count, len(self._outputs)), np.nan)
        self._knot, self._next_event = -1, math.inf
        failed, ended = None, False
        try:
            self._initialise(request)
            self._integrate(request.tolerance or self._tolerance)
            self._calling("terminate").terminate()
        except FMICallException as problem:
            failed = problem.function
        except _EndedByModel:
            ended = True
        except _Ended as end:
            failed = end.function
            if str(end):
                self._callbacks.note(None, 3, b"", str(end).encode())
        finally:
            self._function = ""
        return Outcome(self._values[plan.rows], self.time, failed, ended)

    def _calling(self, function: str) -> Instance:
        self._calls += 1
        self._function = function
        return self.model

    def check_time(self) -> None:
        """Ends a run that takes longer than it may."""
        self._calling("derivatives")
        if time.process_time() > self._deadline:
            raise _Ended(TOO_SLOW)

    # Initialisation and events

    def _initialise(self, request: Request) -> None:
        self.time = start = float(self._plan.times[0])
        if request.must_reset:
            self._calling("reset").reset()
        self._write(request.parameters)
        model = self._calling("enterInitializationMode")
        if major_version(model) == 3:
            model.enterInitializationMode(tolerance=request.tolerance, startTime=start)
        else:
            model.setupExperiment(tolerance=request.tolerance, startTime=start)
            model.enterInitializationMode()
        self._take_knot(int(self._plan.knots[0]))
        self._calling("exitInitializationMode").exitInitializationMode()
        self._settle_discrete()

    def _settle_discrete(self) -> None:
        """From event mode, where the discrete states change until they stay, to continuous time."""
        model = self._calling("newDiscreteStates")
        iterate = (
            model.updateDiscreteStates if major_version(model) == 3 else model.newDiscreteStates
        )
        for _ in range(_MOST_ITERATIONS):
            again, terminate, _, _, timed, at = iterate()
            if terminate:
                raise _EndedByModel
            if not again:
                break
        else:
            raise _Ended(
                "newDiscreteStates",
                f"the discrete states still change after {_MOST_ITERATIONS} iterations",
            )
        self._next_event = float(at) if timed else math.inf
        self._calling("enterContinuousTimeMode").enterContinuousTimeMode()

    def _event(self, solver: _Integrator, knot: int = -1) -> None:
        self._calling("enterEventMode").enterEventMode()
        self._take_knot(knot)
        self._settle_discrete()
        solver.reset(self.time)

    # Inputs and outputs

    def _write(self, values: Mapping[str, float]) -> None:
        if values:
            self._calling("set")
            self._variables.set(values)

    def _take_knot(self, knot: int) -> None:
        """The inputs from here on."""
        if knot < 0:
            return
        self._knot, self._since = knot, self.time
        self._write(dict(zip(self._inputs, self._plan.values[knot].tolist(), strict=True)))
        slopes = self._plan.slopes[knot]
        self._rising = np.flatnonzero((slopes != 0.0) & ~self._is_held).tolist()

    def move_to(self, time: float) -> None:
        """Sets the time of the FMU [s], and the inputs that change with it."""
        self.model.setTime(time)
        if self._knot >= 0 and self._rising:
            values, slopes = self._plan.values[self._knot], self._plan.slopes[self._knot]
            ahead = values + slopes * (time - self._since)
            self._write({self._inputs[i]: float(ahead[i]) for i in self._rising})

    def _read(self, row: int) -> None:
        if row >= 0 and self._outputs:
            self._calling("get")
            self._values[row] = self._variables.get(self._outputs)

    def scales(self, values: Any, count: int) -> None:
        """Sizes of the states, by which their errors are judged: nominal values, or else where they start."""
        self.model.getNominalsOfContinuousStates(values, count)
        sizes = np.ctypeslib.as_array(values, (count,))
        undeclared = sizes == 1.0
        present = (c_double * count)()
        self.model.getContinuousStates(present, count)
        start = np.abs(np.array(present))
        sizes[:] = np.where(
            undeclared, np.where(start == 0.0, 1.0, np.clip(start, 1e-6, 1.0)), np.abs(sizes)
        )

    # Integration

    def _integrate(self, tolerance: float) -> None:
        plan = self._plan
        span = float(plan.times[-1] - plan.times[0])
        solver = _Integrator(self, self.time, _LONGEST_STEP * span or math.inf, tolerance)
        for point, goal in enumerate(plan.times.tolist()):
            try:
                self._advance(solver, goal)
            except _EndedByModel:
                if goal - self.time <= _near(goal):
                    self._read(int(plan.rows_after[point]))
                raise
            self._read(int(plan.rows_before[point]))
            if point and plan.knots[point] >= 0:
                self._event(solver, int(plan.knots[point]))
            self._read(int(plan.rows_after[point]))

    def _advance(self, solver: _Integrator, goal: float) -> None:
        """To a time [s], over the events before it."""
        tolerance = _near(goal)
        while goal - self.time > tolerance:
            self.check_time()
            happened = self._step(solver, min(goal, max(self._next_event, self.time)))
            ended = False
            if self._told_steps:
                entered, ended = self._calling("completedIntegratorStep").completedIntegratorStep()
                happened = happened or entered
            if ended:
                raise _EndedByModel
            if happened or self.time >= self._next_event - tolerance:
                self._event(solver)

    def _step(self, solver: _Integrator, goal: float) -> bool:
        """Integrates to a time [s], or to an event of the state before it: whether there was one."""
        if goal - self.time <= _near(goal):
            self.time = goal
            self.move_to(goal)
            return True
        solver.problem = None
        try:
            happened, _, reached = solver.step(self.time, goal)
        except Exception as error:  # FMPy raises bare Exceptions
            problem = solver.problem
            if isinstance(problem, _Ended):
                raise problem from None
            raise _Ended(
                CVODE, f"CVode gives up: {error if problem is None else problem}"
            ) from None
        if solver.problem is not None:
            self._callbacks.take_messages()  # of states that were only tried
        self.time = float(reached)
        self.move_to(self.time)
        return bool(happened)


def _given(description: ModelDescription) -> float:
    experiment = description.defaultExperiment
    given = (
        float(experiment.tolerance)
        if experiment is not None and experiment.tolerance
        else _TOLERANCE
    )
    return min(given, _TOLERANCE)


def _near(time: float) -> float:
    """The distance [s] of points that are one."""
    return _NO_DISTANCE * max(abs(time), 1.0)
