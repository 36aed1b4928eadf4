"""The compiled loop over communication points (``fmu/pam_driver.c``) and its Python face."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.fmu.read import Slot
from pam_cosim.simulation.native import (
    SLOTS,
    CallbackFunctions,
    DriverRun,
    DriverVariables,
    MessageLog,
    address,
    driver_library,
)
from pam_cosim.simulation.plan import CommunicationPlan
from pam_cosim.simulation.values import Selection
from pam_cosim.wording import printable

# In the order of the function pointers in driver_run, by major version of FMI; version 3 sets up the experiment when it
# enters initialization mode, and has no slopes of inputs: our own FMUs have a function for them in addition to FMI, and
# one for equilibria. Functions that set and get values are those of the variables' types.
FUNCTIONS: dict[int, tuple[str | None, ...]] = {
    2: (
        "fmi2Reset",
        "fmi2SetupExperiment",
        "fmi2EnterInitializationMode",
        "fmi2ExitInitializationMode",
        None,
        None,
        "fmi2SetRealInputDerivatives",
        "fmi2DoStep",
        "fmi2Terminate",
        "pam_settle",
        "fmi2GetRealStatus",
        "fmi2GetBooleanStatus",
    ),
    3: (
        "fmi3Reset",
        None,
        "fmi3EnterInitializationMode",
        "fmi3ExitInitializationMode",
        None,
        None,
        "pam_set_input_slopes",
        "fmi3DoStep",
        "fmi3Terminate",
        "pam_settle",
        None,
        None,
    ),
}
Settle = Literal["none", "others", "all"]
_SETTLING: dict[Settle, int] = {"none": 0, "others": 1, "all": 2}  # as the loop numbers them
# Named instead of a function where the run took too long.
TOO_SLOW, TOO_MANY_STEPS = "time limit", "limit of steps"


class Callbacks:
    """Memory, and a log in C that keeps the FMU's warnings and errors; must outlive the instance."""

    def __init__(self) -> None:
        library = driver_library()
        self._log = MessageLog()
        self.functions = CallbackFunctions(
            address(library, "pam_driver_logger"),
            address(library, "pam_driver_allocate"),
            address(library, "pam_driver_free"),
            None,
            ctypes.addressof(self._log),
        )

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


class RunProgress(NamedTuple):
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
        values: (n, outputs), meaningless where the run failed, and NaN where it did not come.
        time: reached [s].
        failed: name of the FMI function that failed; None: none did.
        ended: the FMU has ended the simulation at ``time``.
    """

    def __init__(self, values: Array, time: float, failed: str | None, ended: bool = False) -> None:
        self.values, self.time, self.failed, self.ended = values, time, failed, ended


class Request(NamedTuple):
    """A request for a simulation by a driver.

    Attributes:
        plan: when what is set and read.
        parameters: by name.
        inputs, outputs: names; the plan has the values of the inputs.
        tolerance: relative, of the solver; None: the model's.
        must_reset: the instance was used before.
        max_seconds: of processor time; None: as long as it likes. max_steps: of the solver; 0: as many as it likes.
        plain: none of the outputs is a sensitivity.
        at_rest: each point of the plan is an equilibrium under its own inputs, not a time.
        settle: as in ``Simulator.run``.
    """

    plan: CommunicationPlan
    parameters: Mapping[str, float]
    inputs: Sequence[str]
    outputs: Sequence[str]
    tolerance: float | None
    must_reset: bool
    max_seconds: float | None
    plain: bool = False
    at_rest: bool = False
    settle: Settle = "none"
    max_steps: int = 0


class _Selected:
    """Variables of a run, as C reads them.

    Attributes:
        selection: which they are.
        variables: the same for C.
        functions: types in the names of functions, by the addresses of groups.
    """

    def __init__(self, selection: Selection, library: Any) -> None:
        self.selection = selection
        groups, self._kept = selection.driver_groups(lambda name: address(library, name))
        self._groups = groups
        begin, size = ctypes.addressof(groups), ctypes.sizeof(groups) // len(groups)
        self.functions = {begin + i * size: g.function for i, g in enumerate(selection.groups)}
        self.variables = DriverVariables(len(selection.groups), begin, selection.width)


class Driver:
    """Runs one instance of an FMU.

    Args:
        library: the FMU's shared library.
        instance: its fmi2Component or fmi3Instance.
        slopes: whether the FMU understands derivatives of inputs.
        slots: its variables by name.
        version: major version of FMI, 2 or 3.

    Attributes:
        settles: whether the FMU finds equilibria.
    """

    def __init__(
        self,
        library: Any,
        instance: int,
        slopes: bool,
        slots: Mapping[str, Slot],
        version: int = 2,
    ) -> None:
        self._library, self._slots = library, slots
        self._selected: dict[tuple[str, ...], _Selected] = {}
        names = dict(zip(SLOTS, FUNCTIONS[version], strict=True))
        self._names = [name or "" for name in names.values()]
        self._addresses = {slot: address(library, name) for slot, name in names.items()}
        self._follow = address(library, "pam_follow_sensitivities")
        self._keep_starts = address(library, "pam_keep_starts")
        self._settle_at = address(library, "pam_settle_start")
        self._statistics = address(library, "pam_get_statistics")
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
            else RunProgress(self._function(run, run.active), run.calls, run.time_reached)
        )

    def _function(self, run: DriverRun, stage: int) -> str:
        """The function of FMI of a stage; of values that of their type."""
        way = {"set_values": "Set", "get_values": "Get"}.get(SLOTS[stage])
        if way is None:
            return self._names[stage]
        kinds = (selected.functions.get(run.group) for selected in [*self._selected.values()])
        kind = next(filter(None, kinds), "")
        return f"fmi{self._version}{way}{kind}"

    def _select(self, names: Iterable[str]) -> _Selected:
        key = tuple(names)
        if key not in self._selected:
            selection = Selection(key, self._slots, self._version)
            self._selected[key] = _Selected(selection, self._library)
        return self._selected[key]

    def run(self, request: Request) -> Outcome:
        """One simulation."""
        plan, tolerance = request.plan, request.tolerance
        selected = [self._select(n) for n in (request.parameters, request.inputs, request.outputs)]
        parameters, inputs, outputs = (choice.selection for choice in selected)
        settings = list(request.parameters.values())
        values = parameters.spread(np.array(settings, dtype=np.float64))
        texts = parameters.texts(settings)
        strings = (ctypes.c_char_p * max(1, len(texts)))(*texts)
        values_at_knots, slopes = inputs.spread(plan.values), inputs.spread(plan.slopes, 0.0)
        sloped = [group for group in inputs.groups if group.is_slope]
        count = len(sloped[0].references) if sloped else 0
        orders = np.ones(count, dtype=np.int32)
        result = np.full((plan.row_count, outputs.width), np.nan)
        buffer = np.empty(max(1, *(choice.selection.width for choice in selected)))
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
            statistics=self._statistics,
            max_steps=request.max_steps,
            at_rest=request.at_rest,
            parameters=selected[0].variables,
            parameter_values=values.ctypes.data,
            texts=ctypes.addressof(strings),
            inputs=selected[1].variables,
            input_values=values_at_knots.ctypes.data,
            input_slopes=slopes.ctypes.data if self._slopes and not request.at_rest else None,
            n_slopes=count,
            orders=orders.ctypes.data,
            outputs=selected[2].variables,
            output_values=result.ctypes.data,
            buffer=buffer.ctypes.data,
            n_points=plan.times.size,
            times=plan.times.ctypes.data,
            knots=plan.knots.ctypes.data,
            means=None if plan.means is None else plan.means.ctypes.data,
            rows_before=plan.rows_before.ctypes.data,
            rows_after=plan.rows_after.ctypes.data,
        )
        self._running = run
        try:
            driver_library().pam_driver_run(ctypes.byref(run))
        finally:
            self._running = None
        failed = None
        if run.stage >= 0:
            limits = dict(enumerate((TOO_SLOW, TOO_MANY_STEPS), len(SLOTS)))
            failed = limits.get(run.stage) or self._function(run, run.stage)
        table = plan.table(outputs.named(result), outputs.is_discrete)
        return Outcome(table, run.time_reached, failed, bool(run.ended))
