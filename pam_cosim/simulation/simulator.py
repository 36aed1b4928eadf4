"""Runs of one FMU: instantiated once, reset for every run."""

from __future__ import annotations

import ctypes
import math
import shutil
import tempfile
import threading
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.fmu.read import fixed_step, interface_of, read_description, slots
from pam_cosim.model.interface import Interface
from pam_cosim.model.settings import Text
from pam_cosim.simulation.abilities import Abilities, abilities_of
from pam_cosim.simulation.driver import (
    TOO_MANY_STEPS,
    TOO_SLOW,
    Callbacks,
    Driver,
    Outcome,
    Request,
    RunProgress,
    Settle,
)
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.inputs import Inputs, with_held
from pam_cosim.simulation.instance import (
    Instance,
    OwnInstance,
    free_instance,
    instantiate,
    load_instance,
    major_version,
    reset_instance,
    takes_slopes,
)
from pam_cosim.simulation.plan import CommunicationPlan, Steps, plan, points
from pam_cosim.simulation.trajectory import Trajectory
from pam_cosim.simulation.values import named_references
from pam_cosim.units import format_quantity

if TYPE_CHECKING:
    from pam_cosim.simulation.exchange import ExchangeDriver
    from pam_cosim.simulation.stepper import Stepper

# [s] of processor time, and for each row: a thousand times what a run needs
LONGEST_RUN = (30.0, 1e-2)

_OTHER_TOOLS = "FMUs of other tools do not find"
_REMEDY = "look at the values of its parameters, or give it a longer time limit (--timeout)"


class SolverStatistics(NamedTuple):
    """Work of the solver since the start of the last run."""

    steps: int
    rejected: int
    evaluations: int
    jacobians: int
    restarts: int


class Simulator:
    """An FMU ready to run, any number of times; a context manager. Runs that several threads ask for come one by one.

    Args:
        path: a co-simulation FMU of FMI 2.0 or 3.0, of any origin; or the folder that one was unpacked to.

    Attributes:
        limit: processor time [s] that a run may take, and more for each of its rows; None: as long as it likes.
        most_steps: of the solver that a run may take, and more for each of its rows, where the FMU counts them.
        simulations: runs of all simulators of this process so far, those that failed among them; ``rows`` of these.

    Raises:
        InputError: not such an FMU, or none for this platform.
        SimulationFailure: the FMU refuses to be instantiated.
    """

    simulations: ClassVar[int] = 0
    rows: ClassVar[int] = 0

    def __init__(self, path: Path) -> None:
        self.limit: tuple[float, float] | None = LONGEST_RUN
        self.most_steps = (0, 0)
        self.path = Path(path)
        self._description = read_description(self.path)
        self.interface: Interface = interface_of(self._description)
        self._settable = self.interface.settable
        self._slots = slots(self._description)
        self._held = frozenset(n for n, v in self.interface.inputs.items() if v.is_discrete)
        self._units = {name: variable.unit for name, variable in self.interface.variables.items()}
        self._instance: Instance | None = None
        self._stepper: Stepper | None = None
        self._turn = threading.Lock()  # of a run: the instance holds the values of one
        self._directory = None if self.path.is_dir() else tempfile.mkdtemp(prefix="pam-cosim-fmu-")
        try:
            self._load()
        except BaseException:
            self.close()
            raise

    def _usual_limit(self, rows: int) -> float | None:
        """Processor time [s] of a run of so many rows, where runs have a limit."""
        return self.limit[0] + self.limit[1] * rows if self.limit else None

    def _load(self) -> None:
        if self._description.coSimulation is None:
            raise InputError("this FMU has no co-simulation interface", self.path)
        self._callbacks = Callbacks()
        self._instance = load_instance(self.path, self._description, self._directory)
        self._slopes = takes_slopes(self._description, self._instance)
        self._instantiate(self._instance)

    def _renew(self) -> None:
        """A fresh instance, for FMUs that cannot be reset."""
        assert self._instance is not None
        free_instance(self._instance)
        self._instantiate(self._instance)

    def _instantiate(self, instance: Instance) -> None:
        self._instance = None  # while there is none
        instantiate(instance, self._callbacks, self.path.name)
        self._instance = instance
        self._driver = self._new_driver(instance)
        self._used = False

    def _new_driver(self, instance: Instance) -> Driver | ExchangeDriver:
        """What makes the runs of an instance."""
        version = major_version(instance)
        return Driver(instance.dll, instance.component, self._slopes, self._slots, version)

    def __enter__(self) -> Simulator:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __del__(self) -> None:
        if hasattr(self, "_directory"):
            self.close()

    def close(self) -> None:
        """Frees the instance and removes its files; a second call does nothing."""
        self._end_steps()
        instance, self._instance = self._instance, None
        if instance is not None:
            instance.freeInstance()
        if self._directory is not None:
            shutil.rmtree(self._directory, ignore_errors=True)

    def run(
        self,
        times: ArrayLike,
        *,
        parameters: Mapping[str, float] | None = None,
        inputs: Inputs | None = None,
        outputs: Sequence[str] | None = None,
        tolerance: float | None = None,
        start_time: float | None = None,
        max_seconds: float | None = None,
        settle: Settle = "none",
    ) -> Trajectory:
        """Simulates from the start values.

        Where the model has a clock of the record (``Interface.record_delays``), the values are those that are
        recorded at the times: as they were when the run began, until the delay has passed.

        Args:
            times: (n,) [s] of the values wanted, never decreasing; a time given twice, where an input steps,
                yields the values before and after the step.
            parameters: values by name [SI] that differ from the defaults; an input among them is held constant, and
                a state begins there.
            inputs: over time; default: the start values, held.
            outputs: names of outputs or of any other variable; default: every output,
                sensitivities among them.
            tolerance: relative, of the solver; default: the model's.
            start_time: [s]; default: the first of ``times``.
            max_seconds: processor time [s] after which the run counts as failed.
            settle: which states begin at an equilibrium under the first inputs: "others", those whose start value is
                not among the parameters, while these stay; or "all" of them, found from there.

        Raises:
            InputError: unknown names, an input given both ways, or times out of order; an FMU of another tool, which
                does not find equilibria, where states shall settle.
            SimulationFailure: (``RunFailure``) the run did not reach its end.
        """
        wanted = np.ascontiguousarray(times, dtype=float)
        start = float(wanted[0]) if start_time is None and wanted.size else start_time or 0.0
        held, fmu_settings = self._split(parameters)
        all_inputs = with_held(inputs, held, start)
        late = sum(
            fmu_settings.get(name, v.start or 0.0)
            for name, v in self.interface.record_delays.items()
        )
        shown = np.maximum(wanted - late, start) if late else wanted
        layout = plan(shown, start, all_inputs, self._steps(wanted), self._held)
        names = self._wanted(outputs)
        values = all_inputs.values if all_inputs else {}
        if settle != "none" and not self._driver.settles:
            raise InputError(f"a start at rest is an equilibrium, which {_OTHER_TOOLS}", self.path)
        limit = max_seconds or self._usual_limit(len(wanted))
        outcome = self._outcome(
            layout, fmu_settings, values, names, tolerance, limit, settle=settle
        )
        settings = {**fmu_settings, **held}
        if outcome.failed is not None:
            raise self._failure(outcome.failed, outcome.time, settings, limit)
        if outcome.ended:
            self._check_end(wanted, names, outcome, settings)
        self._check_finite(wanted, names, outcome.values, settings)
        return self._trajectory(wanted, names, outcome, _steps_note(layout))

    def _steps(self, times: Array) -> Steps:
        """What the FMU needs of communication points."""
        if not self.abilities.any_step:
            apart = np.diff(np.unique(times))
            usual = float(np.median(apart)) if apart.size else self.interface.interval
            return Steps(fixed=fixed_step(self._description) or usual)
        return Steps(ramps=None if self._slopes else self.interface.interval)

    def equilibria(
        self,
        inputs: Mapping[str, ArrayLike],
        *,
        parameters: Mapping[str, float] | None = None,
        outputs: Sequence[str] | None = None,
        max_seconds: float | None = None,
    ) -> Trajectory:
        """Equilibria of the model, each under inputs of its own; nothing in one depends on another.

        Every derivative is zero, by Newton's method at the end of growing implicit steps from the start values. A
        clock of the record and delays are over.

        Args:
            inputs: name to (n,) [SI].
            parameters: as in ``run``.
            outputs: as in ``run``; sensitivities are those of the equilibria.
            max_seconds: as in ``run``.

        Returns:
            The outputs; "time" is the number of each.

        Raises:
            InputError: unknown names, an input given both ways, inputs of unlike length, or an FMU of another tool,
                which does not find equilibria.
            SimulationFailure: (``RunFailure``) there is no equilibrium, or none was found; the message has the inputs.
        """
        if not self._driver.settles:
            raise InputError(f"quasi-static data need equilibria, which {_OTHER_TOOLS}", self.path)
        held, fmu_settings = self._split(parameters)
        given = {name: np.asarray(values, dtype=float) for name, values in inputs.items()}
        count = max((values.size for values in given.values()), default=1)
        all_inputs = with_held(Inputs(np.arange(count, dtype=float), given), held, 0.0)
        values, names = all_inputs.values if all_inputs else {}, self._wanted(outputs)
        limit = max_seconds or self._usual_limit(count)
        outcome = self._outcome(
            points(values, count), fmu_settings, values, names, None, limit, at_rest=True
        )
        settings = {**fmu_settings, **held}
        if outcome.failed is not None:
            row = int(outcome.time)
            units = self.interface.inputs
            under = ", ".join(
                f"{n} = {format_quantity(float(v[row]), units[n].unit)}" for n, v in values.items()
            )
            failure = self._failure(outcome.failed, None, settings, limit)
            raise (
                RunFailure(f"{failure.reason} (under {under})", None, failure.parameters)
                if under
                else failure
            )
        numbers = np.arange(count, dtype=float)
        self._check_finite(numbers, names, outcome.values, settings)
        return self._trajectory(numbers, names, outcome)

    def _split(
        self, parameters: Mapping[str, float] | None
    ) -> tuple[dict[str, float], dict[str, float]]:
        """Inputs that are held, and parameters."""
        values = {name: _number(name, value) for name, value in (parameters or {}).items()}
        self._check_names(values, self._settable, "parameter or input")
        for name, value in values.items():
            variable = self._settable[name]
            if not variable.allows(value):
                raise InputError(f"'{name}={value:g}': must be {variable.values}")
        held = {name: value for name, value in values.items() if name in self.interface.inputs}
        return held, {name: value for name, value in values.items() if name not in held}

    def _wanted(self, outputs: Sequence[str] | None) -> list[str]:
        return list(
            self.interface.outputs | self.interface.sensitivities if outputs is None else outputs
        )

    def _outcome(
        self,
        layout: CommunicationPlan,
        settings: Mapping[str, float],
        inputs: Iterable[str],
        names: Sequence[str],
        tolerance: float | None,
        max_seconds: float | None,
        at_rest: bool = False,
        settle: Settle = "none",
    ) -> Outcome:
        if self._instance is None:
            raise RuntimeError("the simulator is closed")
        self._check_names(settings, self._settable, "parameter")
        self._check_names(inputs, self.interface.inputs, "input")
        self._check_names(names, self.interface.variables, "output")
        self._callbacks.take_messages()
        model = self.interface
        plain = {*model.outputs, *model.states, *model.rates}.issuperset(names)

        def drive() -> Outcome:
            request = Request(
                layout,
                settings,
                [*inputs],
                names,
                tolerance,
                self._used,
                max_seconds,
                plain,
                at_rest,
                settle,
                self.most_steps[0] + self.most_steps[1] * layout.row_count,
            )
            return self._driver.run(request)

        with self._turn:
            self._end_steps()
            Simulator.simulations += 1
            Simulator.rows += layout.row_count
            outcome = drive()
            if outcome.failed in ("fmi2Reset", "fmi3Reset"):
                self._renew()
                outcome = drive()
            self._used = True
            if outcome.ended:  # some remember it when they are reset
                self._renew()
            return outcome

    def _check_end(
        self, times: Array, names: Sequence[str], outcome: Outcome, settings: Mapping[str, float]
    ) -> None:
        """Raises RunFailure, with the trajectory so far, where the FMU ended the simulation early."""
        tolerance = 1e-9 * max(abs(outcome.time), 1.0)
        is_there = (times <= outcome.time + tolerance) & ~np.isnan(outcome.values).any(axis=1)
        if is_there.all():
            return
        count = int(np.argmin(is_there))
        outcome.values = outcome.values[:count]
        failure = RunFailure("the FMU ends the simulation", outcome.time, self._changed(settings))
        failure.run = self._trajectory(times[:count], names, outcome)
        raise failure

    def _trajectory(
        self, time: Array, names: Sequence[str], outcome: Outcome, note: str = ""
    ) -> Trajectory:
        columns = np.ascontiguousarray(outcome.values.T)
        units = {name: self._units.get(name, "") for name in names}
        warnings = (*([note] if note else []), *self._messages())
        return Trajectory(time.copy(), dict(zip(names, columns, strict=True)), units, warnings)

    def stepper(self) -> Stepper:
        """A new run of the instance, step by step; it ends when another run begins.

        Raises:
            SimulationFailure: the FMU can neither be reset nor made again.
        """
        from pam_cosim.simulation.stepper import Stepper

        if self._instance is None:
            raise RuntimeError("the simulator is closed")
        self._end_steps()
        if self._used:
            self._fresh(self._instance)
        self._used = True
        instance = self._instance
        if isinstance(instance, OwnInstance):
            instance = instance.with_steps()
        self._stepper = Stepper(
            instance, self.abilities, self._callbacks, self._slots, self.path.name
        )
        return self._stepper

    @property
    def abilities(self) -> Abilities:
        """What the FMU can do in addition to a step."""
        return abilities_of(self._description, self._slopes)

    def _fresh(self, instance: Instance) -> None:
        """The instance as it was made."""
        if not reset_instance(instance):
            self._renew()

    def _end_steps(self) -> None:
        stepper, self._stepper = self._stepper, None
        if stepper is not None and self._instance is not None:
            stepper.close()

    @property
    def settles(self) -> bool:
        """Whether the FMU finds equilibria."""
        return self._driver.settles

    @property
    def progress(self) -> RunProgress | None:
        """The progress of the present run, for another thread; None between runs."""
        if self._instance is None:
            return None
        return self._stepper.progress if self._stepper is not None else self._driver.progress

    @property
    def statistics(self) -> SolverStatistics | None:
        """What the last run cost; None for FMUs of other tools."""
        if self._instance is None or not hasattr(self._instance.dll, "pam_get_statistics"):
            return None
        numbers = (ctypes.c_longlong * 5)()
        self._instance.dll.pam_get_statistics(ctypes.c_void_p(self._instance.component), numbers)
        return SolverStatistics(*numbers)

    def _check_names(
        self, names: Iterable[str], variables: Mapping[str, object], role: str
    ) -> None:
        for name in names:
            if name not in variables:
                raise InputError(self.interface.unknown(name, role, variables))

    def _messages(self) -> list[str]:
        """Messages of the FMU since the last run, with its variables named."""
        return [named_references(text, self._slots) for text in self._callbacks.take_messages()]

    def _changed(self, values: Mapping[str, float]) -> dict[str, float]:
        return {
            name: value for name, value in values.items() if value != self._settable[name].start
        }

    def _failure(
        self, function: str, time: float | None, values: Mapping[str, float], limit: float | None
    ) -> RunFailure:
        messages = self._messages()
        if function == TOO_SLOW:
            messages = [
                f"the run takes longer than it may, {limit:.3g} s of processor time; {_REMEDY}"
            ]
        if function == TOO_MANY_STEPS:
            messages = ["the solver takes far more steps than is usual"]
        reason = (
            "; ".join(messages)
            if messages
            else f"the FMU reports an error in {function} and no reason"
        )
        return RunFailure(reason, time, self._changed(values))

    def _check_finite(
        self, times: Array, names: Sequence[str], results: Array, values: Mapping[str, float]
    ) -> None:
        bad = np.argwhere(~np.isfinite(results))
        if bad.size:
            row, column = bad[0]
            reason = f"'{names[column]}' is not a finite number at time {times[row]:.6g} s"
            raise RunFailure(reason, float(times[row]), self._changed(values))


def _number(name: str, value: float) -> float:
    if isinstance(value, Text):
        return value
    number = float(value)
    if not math.isfinite(number):
        raise InputError(f"parameter '{name}' must be a finite number, not {value}")
    return number


def _steps_note(layout: CommunicationPlan) -> str:
    """What equal steps do to a run; "" where all times are ends of them."""
    if layout.grid is None or not (layout.grid.place % 1.0).any():
        return ""
    length = float(layout.times[1] - layout.times[0])
    return (
        f"the FMU takes steps of {length:g} s alone (canHandleVariableCommunicationStepSize is false): outputs "
        "between their ends are interpolated, and inputs are means over each"
    )
