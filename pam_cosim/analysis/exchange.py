"""An FMU for model exchange: rates, values and their exact derivatives at any time, state and input."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Mapping, Sequence
from ctypes import c_double
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from fmpy.fmi3 import FMU3Model

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.fmu.read import exchange_description, interface_of, slots, state_names
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.simulation.driver import Callbacks, RunProgress
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.instance import instantiate, load_instance
from pam_cosim.simulation.values import Values

EXACT, DIFFERENCES = "directional derivatives of the FMU", "central differences"
# Of central differences, relative: the cube root of the rounding error balances it with the truncation error.
_STEP = float(np.cbrt(np.finfo(float).eps))
_MOST_EVENT_ITERATIONS = 100

T = TypeVar("T")


class ExchangeModel:
    """An instance for model exchange; a context manager.

    Between ``restart`` and the end of its use the discrete states stay as they were initialised: no events are handled.

    Attributes:
        interface: as that of a simulator.
        states: names of the continuous states, in the FMU's order; their derivatives are ``rate_names``.
        nominal: (n,) sizes of the states as the FMU declares them.
        exact: whether the FMU gives directional derivatives.
        event_indicators: how many the FMU has.

    Args:
        path: an FMU of FMI 2.0 or 3.0 with model exchange.

    Raises:
        InputError: not such an FMU, or none for this platform.
        SimulationFailure: it refuses to be instantiated.
    """

    def __init__(self, path: Path) -> None:
        self.path = Path(path)
        self._description = exchange_description(self.path)
        self.interface: Interface = interface_of(self._description)
        self._variables = self.interface.variables
        self._references = slots(self._description)
        pairs = list(state_names(self._description))
        self.rate_names, self.states = [rate for _, rate in pairs], [state for state, _ in pairs]
        assert self._description.modelExchange is not None
        self.exact = self._description.modelExchange.providesDirectionalDerivatives
        self.nominal = np.ones(len(self.states))
        self._calls = 0
        self.event_indicators = int(self._description.numberOfEventIndicators or 0)
        self._slots = {name: i for i, name in enumerate(self.states)}
        self._inputs = list(self.interface.inputs)
        self._started = False
        self._directory = tempfile.mkdtemp(prefix="pam-cosim-fmu-")
        self._model: Any = None
        try:
            self._load()
        except BaseException:
            self.close()
            raise

    def _load(self) -> None:
        self._callbacks = Callbacks()
        model = load_instance(self.path, self._description, self._directory, exchange=True)
        self._rates = (c_double * max(1, len(self.states)))()
        self._state = (c_double * max(1, len(self.states)))()
        instantiate(model, self._callbacks, self.path.name)
        self._model = model
        version = 3 if isinstance(model, FMU3Model) else 2
        self._values = Values(model, self._references, version)

    def __enter__(self) -> ExchangeModel:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Frees the instance and removes its files; a second call does nothing."""
        model, self._model = self._model, None
        if model is not None:
            model.freeInstance()
        shutil.rmtree(self._directory, ignore_errors=True)

    @property
    def progress(self) -> RunProgress:
        """How far the work is, which distinguishes an FMU that hangs from one that works."""
        return RunProgress("in a call of its equations", self._calls, getattr(self, "time", 0.0))

    def restart(self, parameters: Mapping[str, float] | None = None, time: float = 0.0) -> None:
        """Initialises at the start values.

        Args:
            parameters: by name [SI], what differs from the defaults: parameters, inputs, start values.
            time: [s].

        Raises:
            InputError: an unknown name.
            SimulationFailure: the FMU refuses.
        """
        settings = dict(parameters or {})
        for name in settings:
            if name not in self.interface.settable:
                settable = self.interface.settable
                raise InputError(self.interface.unknown(name, "parameter or input", settable))
        self._call(lambda: self._initialise(settings, time))
        self.time = time

    def _initialise(self, settings: Mapping[str, float], time: float) -> None:
        model = self._model
        if self._started:
            model.reset()
        self._started = True
        self._values.set(settings)
        if isinstance(model, FMU3Model):
            model.enterInitializationMode(startTime=time)
        else:
            model.setupExperiment(startTime=time)
            model.enterInitializationMode()
        model.exitInitializationMode()
        iterate = (
            model.updateDiscreteStates if isinstance(model, FMU3Model) else model.newDiscreteStates
        )
        for _ in range(_MOST_EVENT_ITERATIONS):
            if not iterate()[0]:
                break
        model.enterContinuousTimeMode()
        if self.states:
            model.getNominalsOfContinuousStates(self._rates, len(self.states))
            nominal = np.abs(np.array(self._rates[: len(self.states)]))
            self.nominal = np.where(nominal > 0, nominal, 1.0)

    def unit(self, name: str) -> str:
        """Of any variable; "" where it has none."""
        variable = self.variable(name)
        return variable.unit if variable is not None else ""

    def variable(self, name: str) -> Variable | None:
        """What the FMU states of a variable; None where it only names it."""
        return self._variables.get(name)

    def check(self, names: Sequence[str], role: str = "variable") -> None:
        """Raises InputError, with the nearest name, where the model lacks one."""
        available: Mapping[str, object] = (
            self.interface.inputs if role == "input" else self._references
        )
        for name in names:
            if name not in available:
                raise InputError(self.interface.unknown(name, role, available))

    def state(self) -> Array:
        """(n,) the present state."""
        if not self.states:
            return np.zeros(0)
        self._call(lambda: self._model.getContinuousStates(self._state, len(self.states)))
        return np.array(self._state[: len(self.states)])

    def inputs(self) -> Array:
        """(m,) the present inputs, in the order of ``interface.inputs``."""
        return self.values(self._inputs)

    def set(
        self, time: float | None = None, state: Array | None = None, inputs: Array | None = None
    ) -> None:
        """Goes to a time [s], a state (n,) and inputs (m,); what is None stays."""
        self._call(lambda: self._set(time, state, inputs))

    def _set(self, time: float | None, state: Array | None, inputs: Array | None) -> None:
        if time is not None and time != self.time:
            self._model.setTime(time)
            self.time = time
        if inputs is not None and len(inputs):
            self._values.set(dict(zip(self._inputs, inputs.tolist(), strict=True)))
        if state is not None and self.states:
            self._state[: len(state)] = state.tolist()
            self._model.setContinuousStates(self._state, len(self.states))

    def rates(self) -> Array:
        """(n,) derivatives of the states by time."""
        if not self.states:
            return np.zeros(0)
        get = (
            self._model.getContinuousStateDerivatives
            if isinstance(self._model, FMU3Model)
            else self._model.getDerivatives
        )
        self._call(lambda: get(self._rates, len(self.states)))
        return np.array(self._rates[: len(self.states)])

    def values(self, names: Sequence[str]) -> Array:
        """(k,) of any variables."""
        return np.array(self._call(lambda: self._values.get(names)), dtype=float)

    def jacobian(self, unknowns: Sequence[str], knowns: Sequence[str]) -> tuple[Array, str]:
        """(k, l) derivatives of rates and other variables by states and inputs, here; and how they were found.

        Where the FMU gives no directional derivatives, or not these, they are central differences.
        """
        if self.exact:
            try:
                return self._exact(unknowns, knowns), EXACT
            except RunFailure:
                pass
        return self._differences(unknowns, knowns), DIFFERENCES

    def _exact(self, unknowns: Sequence[str], knowns: Sequence[str]) -> Array:
        rows, columns = (
            [self._references[name].scalar.valueReference for name in names]
            for names in (unknowns, knowns)
        )
        derivatives = np.zeros((len(rows), len(columns)))
        for j, column in enumerate(columns if rows else ()):
            derivatives[:, j] = self._call(
                lambda column=column: self._model.getDirectionalDerivative(rows, [column], [1.0])  # type: ignore[misc]
            )
        return derivatives

    def _differences(self, unknowns: Sequence[str], knowns: Sequence[str]) -> Array:
        state, inputs = self.state(), self.inputs()
        derivatives = np.zeros((len(unknowns), len(knowns)))
        for j, name in enumerate(knowns):
            sides = []
            size = self._size(name, state, inputs)
            for sign in (1.0, -1.0):
                moved_state, moved_inputs = state.copy(), inputs.copy()
                vector, at = self._place(name, moved_state, moved_inputs)
                vector[at] += sign * _STEP * size
                self.set(state=moved_state, inputs=moved_inputs)
                sides.append((float(vector[at]), self.values(unknowns)))
            (high, above), (low, below) = sides
            derivatives[:, j] = (above - below) / (high - low)
        self.set(state=state, inputs=inputs)
        return derivatives

    def _place(self, name: str, state: Array, inputs: Array) -> tuple[Array, int]:
        return (
            (state, self._slots[name])
            if name in self._slots
            else (inputs, self._inputs.index(name))
        )

    def _size(self, name: str, state: Array, inputs: Array) -> float:
        vector, at = self._place(name, state, inputs)
        return max(abs(float(vector[at])), self.scale(name))

    def scale(self, name: str) -> float:
        """A typical size of a variable: its nominal value, its start value where it declares none, or 1."""
        if name in self._slots and self.nominal[self._slots[name]] != 1.0:
            return float(self.nominal[self._slots[name]])
        variable = self.variable(name)
        magnitudes = (
            (variable.nominal, variable.start, variable.max) if variable is not None else ()
        )
        return next((abs(v) for v in magnitudes if v), 1.0)

    def _call(self, ask: Callable[[], T]) -> T:
        self._calls += 1
        try:
            return ask()
        except Exception as error:  # FMPy's FMICallException is a bare Exception
            messages = (
                "; ".join(self._callbacks.take_messages()) or f"the FMU reports an error: {error}"
            )
            raise RunFailure(messages, getattr(self, "time", None)) from error
