"""The compiled loop over communication points (``fmu/pam_driver.c``) and its Python face."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol

import numpy as np
from fmpy.fmi2 import (
    fmi2CallbackAllocateMemoryTYPE,
    fmi2CallbackFreeMemoryTYPE,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
)

from pam_cosim.arrays import Array
from pam_cosim.simulation.native import SLOTS, DriverRun, MessageLog, address, driver_library
from pam_cosim.simulation.plan import CommunicationPlan
from pam_cosim.wording import printable

# In the order of the function pointers in driver_run, by major version of FMI; version 3 sets up the experiment when
# it enters initialization mode, and has no slopes of inputs: our own FMUs have a function for them beside FMI, and one
# for equilibria.
FUNCTIONS: dict[int, tuple[str | None, ...]] = {
    2: (
        "fmi2Reset",
        "fmi2SetupExperiment",
        "fmi2EnterInitializationMode",
        "fmi2ExitInitializationMode",
        "fmi2SetReal",
        "fmi2GetReal",
        "fmi2SetRealInputDerivatives",
        "fmi2DoStep",
        "fmi2Terminate",
        "pam_settle",
    ),
    3: (
        "fmi3Reset",
        None,
        "fmi3EnterInitializationMode",
        "fmi3ExitInitializationMode",
        "fmi3SetFloat64",
        "fmi3GetFloat64",
        "pam_set_input_slopes",
        "fmi3DoStep",
        "fmi3Terminate",
        "pam_settle",
    ),
}
Settle = Literal["none", "others", "all"]
_SETTLING: dict[Settle, int] = {"none": 0, "others": 1, "all": 2}  # as the loop numbers them
# Named instead of a function where the run took too long.
TOO_SLOW = "time limit"


class Callbacks:
    """Memory, and a log in C that keeps the FMU's warnings and errors; must outlive the instance."""

    def __init__(self) -> None:
        library = driver_library()
        self._log = MessageLog()
        self.functions = fmi2CallbackFunctions()
        self.functions.logger = ctypes.cast(library.pam_driver_logger, fmi2CallbackLoggerTYPE)
        self.functions.allocateMemory = ctypes.cast(
            library.pam_driver_allocate, fmi2CallbackAllocateMemoryTYPE
        )
        self.functions.freeMemory = ctypes.cast(library.pam_driver_free, fmi2CallbackFreeMemoryTYPE)
        self.functions.componentEnvironment = ctypes.addressof(self._log)

    def note(self, environment: object, status: int, category: bytes, message: bytes) -> None:
        """The log of FMI 3.0, as a function for FMPy; messages of status warning and worse are kept."""
        text = self._log.text + message + b"\n"
        if status > 0 and len(text) < 8192:
            self._log.text = text

    def take_messages(self) -> list[str]:
        """Messages since the last call."""
        text = self._log.text.decode("utf-8", "replace")
        self._log.used, self._log.text = 0, b""
        return [printable(line) for line in text.splitlines() if line.strip()]


@dataclass(frozen=True)
class RunProgress:
    """Of a run that has not ended.

    Attributes:
        function: of FMI, that was called last.
        calls: number of calls before it.
        time: reached [s].
    """

    function: str
    calls: int
    time: float


class Outcome:
    """What a run left behind.

    Attributes:
        values: (n, outputs), meaningless where the run failed.
        time: reached [s].
        failed: name of the FMI function that failed; None: none did.
    """

    def __init__(self, values: Array, time: float, failed: str | None) -> None:
        self.values, self.time, self.failed = values, time, failed


@dataclass(frozen=True)
class Request:
    """A simulation that is asked of a driver.

    Attributes:
        plan: when what is set and read.
        parameters: their value references, and values.
        inputs, outputs: value references; the plan has the values of the inputs.
        tolerance: relative, of the solver; None: the model's.
        must_reset: the instance was used before.
        max_seconds: of processor time; None: as long as it likes.
        plain: none of the outputs is a sensitivity.
        at_rest: each point of the plan is an equilibrium under its own inputs, not a time.
        settle: as in ``Simulator.run``.
    """

    plan: CommunicationPlan
    parameters: tuple[Sequence[int], Sequence[float]]
    inputs: Sequence[int]
    outputs: Sequence[int]
    tolerance: float | None
    must_reset: bool
    max_seconds: float | None
    plain: bool = False
    at_rest: bool = False
    settle: Settle = "none"


class AnyDriver(Protocol):
    """What runs one instance of an FMU; its members are those of ``Driver``."""

    @property
    def settles(self) -> bool:
        """Whether the FMU finds equilibria."""

    @property
    def progress(self) -> RunProgress | None:
        """How far a run in another thread is."""

    def run(self, request: Request) -> Outcome:
        """One simulation."""


class Driver:
    """Runs one instance of an FMU.

    Args:
        library: the FMU's shared library.
        instance: its fmi2Component or fmi3Instance.
        slopes: whether the FMU understands derivatives of inputs.
        version: major version of FMI, 2 or 3.

    Attributes:
        settles: whether the FMU finds equilibria.
    """

    def __init__(self, library: Any, instance: int, slopes: bool, version: int = 2) -> None:
        names = dict(zip(SLOTS, FUNCTIONS[version], strict=True))
        self._names = [name or "" for name in names.values()]
        self._addresses = {slot: address(library, name) for slot, name in names.items()}
        self._follow = address(library, "pam_follow_sensitivities")
        self._keep_starts = address(library, "pam_keep_starts")
        self._settle_at = address(library, "pam_settle_start")
        self._instance, self._slopes, self._version = instance, slopes, version
        self.settles = self._addresses["settle"] is not None
        self._running: DriverRun | None = None

    @property
    def progress(self) -> RunProgress | None:
        """How far a run in another thread is; None where there is none."""
        run = self._running
        return (
            None
            if run is None
            else RunProgress(self._names[run.active], run.calls, run.time_reached)
        )

    def run(self, request: Request) -> Outcome:
        """One simulation."""
        plan, parameters, inputs, outputs = (
            request.plan,
            request.parameters,
            request.inputs,
            request.outputs,
        )
        tolerance = request.tolerance
        references = [np.array(r, dtype=np.uint32) for r in (parameters[0], inputs, outputs)]
        values = np.array(parameters[1], dtype=np.float64)
        orders = np.ones(len(inputs), dtype=np.int32)
        result = np.empty((plan.row_count, len(outputs)))
        run = DriverRun(
            **self._addresses,
            instance=self._instance,
            version=self._version,
            must_reset=request.must_reset,
            tolerance_defined=tolerance is not None,
            tolerance=tolerance or 0.0,
            max_seconds=request.max_seconds or 0.0,
            follow=self._follow,
            keep_starts=self._keep_starts,
            plain=request.plain,
            settle_start=_SETTLING[request.settle],
            settle_at=self._settle_at,
            at_rest=request.at_rest,
            n_parameters=values.size,
            parameters=references[0].ctypes.data,
            parameter_values=values.ctypes.data,
            n_inputs=len(inputs),
            inputs=references[1].ctypes.data,
            input_values=plan.values.ctypes.data,
            input_slopes=plan.slopes.ctypes.data if self._slopes and not request.at_rest else None,
            orders=orders.ctypes.data,
            n_outputs=len(outputs),
            outputs=references[2].ctypes.data,
            output_values=result.ctypes.data,
            n_points=plan.times.size,
            times=plan.times.ctypes.data,
            knots=plan.knots.ctypes.data,
            rows_before=plan.rows_before.ctypes.data,
            rows_after=plan.rows_after.ctypes.data,
        )
        self._running = run
        try:
            driver_library().pam_driver_run(ctypes.byref(run))
        finally:
            self._running = None
        failed = (*self._names, TOO_SLOW)[run.stage] if run.stage >= 0 else None
        return Outcome(result[plan.rows], run.time_reached, failed)
