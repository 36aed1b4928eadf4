"""A model that is driven step by step, as a rig is in the laboratory."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator, Mapping, Sequence
from math import isclose

from pam_cosim.cosimulation.recorder import Recorder
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.settings import Setting, resolve, value_of
from pam_cosim.simulation import AnySimulator, Trajectory
from pam_cosim.simulation.stepper import Stepper
from pam_cosim.units import UnitError, convert, format_quantity, seconds
from pam_cosim.wording import Printed, did_you_mean

_MARK = b"pam-cosim state\0"
_SIZE = struct.Struct("<Q")
_ROUNDING = 1e-12  # two inputs that differ by less are one, such as 0.35 A and 350 mA
_LONGEST_HEAD = 1 << 20  # bytes: names and values of some thousand inputs


class Readings(Printed, Mapping[str, float]):
    """Values by name in the model's own (SI) units, which prints itself in units that are easy to read."""

    def __init__(self, values: Mapping[str, float], units: Mapping[str, str]) -> None:
        self._values, self.units = dict(values), dict(units)

    def __getitem__(self, name: str) -> float:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __str__(self) -> str:
        return ", ".join(
            f"{name} = {format_quantity(value, self.units[name])}"
            for name, value in self._values.items()
        )


class RigState(Printed):
    """A state of a rig to which it can go back; ``Rig.save`` makes it.

    Attributes:
        time: at which it was saved [s].
    """

    def __init__(self, rig: Rig, number: int, rows: int) -> None:
        self._rig, self._number, self.time = rig, number, rig.time
        self._inputs, self._rows = rig._held.copy(), rig._record.rows[:rows]

    def __str__(self) -> str:
        return f"state of {self._rig.interface.model} at {self.time:.6g} s"

    def to_bytes(self) -> bytes:
        """The state as bytes, for a file or another process; ``Rig.restore`` reads them.

        Raises:
            InputError: the FMU cannot do that.
        """
        content = self._rig._run().freeze(self._number)
        head = {"model": self._rig.interface.model, "time": self.time, "inputs": self._inputs}
        text = json.dumps(head).encode()
        return _MARK + _SIZE.pack(len(text)) + text + content


class Rig(Printed):
    """A model in the middle of a run; ``start`` makes it. A context manager.

    ``rig["p"]`` is the present value of any variable in the model's own (SI) unit.

    Args:
        simulator: an FMU that is ready to run; closed with the rig.
        parameters: as in ``simulate``.
        outputs: names of the variables to record; default: every output.
        start_time: [s].
        tolerance: relative, of the FMU's solver; default: its own.
    """

    def __init__(
        self,
        simulator: AnySimulator,
        parameters: Mapping[str, Setting] | None = None,
        outputs: Sequence[str] | None = None,
        start_time: float = 0.0,
        tolerance: float | None = None,
    ) -> None:
        self._simulator, self.interface = simulator, simulator.interface
        self._variables = self.interface.variables
        values = resolve(parameters or {}, self.interface)
        self._names = list(self.interface.outputs if outputs is None else outputs)
        for name in self._names:
            self._variable(name)
        self._held = {n: values.get(n, v.start or 0.0) for n, v in self.interface.inputs.items()}
        self._record = Recorder({n: self._variables[n].unit for n in (*self._held, *self._names)})
        self._warnings: list[str] = []
        self.time = start_time
        self._stepper: Stepper | None = simulator.stepper()
        self._stepper.begin(values, start_time, tolerance)
        self._stepper.initialised()
        self._write_down()

    def __enter__(self) -> Rig:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Ends the run; what it recorded stays."""
        self._stepper = None
        self._simulator.close()

    def step(
        self,
        duration: float | str,
        settings: Mapping[str, Setting] | None = None,
        /,
        **inputs: Setting,
    ) -> Readings:
        """Advances by ``duration`` with the inputs given, which are held from now on.

        Args:
            duration: a number [s] or a text such as "10 ms".
            settings: inputs whose names are no Python names, such as {"valve.u": "0.35 A"}.
            inputs: by name, a number [SI] or a text with a unit.

        Returns:
            What is recorded, at the end of the step.

        Raises:
            InputError: an unknown input, a value or a duration that cannot be used; nothing has moved.
            SimulationFailure: the step could not be made; the rig can go back to a saved state, and what was recorded
                is kept.
        """
        run, length = self._run(), positive_seconds(duration, "the duration of a step")
        changed = self._resolved({**(settings or {}), **inputs})
        if any(not isclose(changed[name], self._held[name], rel_tol=_ROUNDING) for name in changed):
            self._held.update(changed)
            run.read((), self._held)
            self._write_down()
        try:
            values = run.advance(length, self._held, None, self._names, can_go_back=True)
        except SimulationFailure:
            self._warnings += self._said()
            raise
        self._warnings += self._said()
        self.time += length
        self._record.add(self.time, [*self._held.values(), *values])
        return self._readings(values)

    def __getitem__(self, name: str) -> float:
        """The present value of any variable [SI].

        Raises:
            InputError: there is no such variable; names the nearest one.
        """
        self._variable(name)
        return self._run().read([name])[0]

    def read(self, name: str, unit: str | None = None) -> float:
        """The present value of any variable, in ``unit`` such as "kPa" (default: the model's own).

        Raises:
            InputError: there is no such variable, or the unit does not fit.
        """
        value, own_unit = self[name], self._variable(name).unit
        try:
            return value if unit is None else float(convert(value, own_unit, unit))
        except UnitError as problem:
            raise InputError(f"'{name}': {problem}") from None

    @property
    def readings(self) -> Readings:
        """What was recorded last."""
        return self._readings(self._record.rows[-1][1][len(self._held) :])

    @property
    def inputs(self) -> Readings:
        """The inputs that are held now."""
        return Readings(self._held, {name: self._variables[name].unit for name in self._held})

    @property
    def trajectory(self) -> Trajectory:
        """What happened so far: the inputs and what is recorded; where an input steps, a time stands twice."""
        return self._record.trajectory(self._warnings)

    def save(self) -> RigState:
        """The present state, with its inputs and what was recorded.

        Raises:
            InputError: the FMU cannot save its state.
        """
        return RigState(self, self._run().save(), len(self._record.rows))

    def restore(self, state: RigState | bytes) -> None:
        """Goes back, or on, to a saved state; from bytes, the record restarts at its time.

        Raises:
            InputError: a state of another rig, bytes that are no state of this model, or an FMU that cannot do that.
        """
        run = self._run()
        if isinstance(state, bytes):
            self._thaw(run, state)
            return
        if state._rig is not self:
            raise InputError(
                "this state was saved by another rig; give its bytes, state.to_bytes()"
            )
        run.restore(state._number)
        self.time, self._held = state.time, state._inputs.copy()
        self._record.rows = state._rows.copy()

    def _thaw(self, run: Stepper, state: bytes) -> None:
        time, inputs, content = _unpacked(state, self.interface)
        try:
            number = run.thaw(content, time)
            run.restore(number)
            run.forget(number)
        except SimulationFailure as failure:
            raise InputError(
                f"these bytes are no state of {self.interface.model}: {failure}"
            ) from failure
        self.time, self._held, self._record.rows = time, inputs, []
        self._write_down()

    def __str__(self) -> str:
        ended = "" if self._stepper is not None else ", ended"
        return f"{self.interface.model} at {self.time:.6g} s{ended}: {self.readings}"

    def _run(self) -> Stepper:
        if self._stepper is None:
            raise InputError(f"the run of {self.interface.model} has ended; start it again")
        return self._stepper

    def _write_down(self) -> None:
        self._record.add(self.time, [*self._held.values(), *self._run().read(self._names)])

    def _said(self) -> list[str]:
        try:
            return self._run().take_messages()
        except SimulationFailure:  # its process has ended
            return []

    def _readings(self, values: Sequence[float]) -> Readings:
        return Readings(
            dict(zip(self._names, values, strict=True)),
            {n: self._variables[n].unit for n in self._names},
        )

    def _variable(self, name: str) -> Variable:
        if name not in self._variables:
            raise InputError(
                f"{self.interface.model} has no variable '{name}'; {did_you_mean(name, self._variables)}"
            )
        return self._variables[name]

    def _resolved(self, inputs: Mapping[str, Setting]) -> dict[str, float]:
        return {
            name: value_of(value, input_of(name, self.interface)) for name, value in inputs.items()
        }


def input_of(name: str, interface: Interface) -> Variable:
    """The input of that name.

    Raises:
        InputError: there is none; names the nearest one, or that it is something else.
    """
    if name in interface.inputs:
        return interface.inputs[name]
    if name in interface.settable:
        raise InputError(f"'{name}' is no input of {interface.model}: it is set at the start")
    raise InputError(interface.unknown(name, "input", interface.inputs))


def positive_seconds(value: float | str, what: str = "the interval of a controller") -> float:
    """A time [s].

    Raises:
        InputError: not a time, or not longer than zero.
    """
    try:
        time = seconds(value)
    except UnitError as problem:
        raise InputError(f"{what}: {problem}") from None
    if not time > 0:
        raise InputError(f"{what} must be longer than zero, not {value}")
    return time


def _unpacked(state: bytes, interface: Interface) -> tuple[float, dict[str, float], bytes]:
    """Time [s], inputs, and the FMU's own bytes."""
    start = len(_MARK) + _SIZE.size
    try:
        if state[: len(_MARK)] != _MARK:
            raise ValueError
        (length,) = _SIZE.unpack(state[len(_MARK) : start])
        if length > _LONGEST_HEAD:
            raise ValueError
        head = json.loads(state[start : start + length])
        model, time, given = head["model"], float(head["time"]), head["inputs"]
        inputs = (
            {name: float(given[name]) for name in interface.inputs}
            if model == interface.model
            else {}
        )
    except (ValueError, KeyError, TypeError, struct.error):
        raise InputError("these bytes are no saved state of a rig") from None
    if model != interface.model:
        raise InputError(f"this state is one of {model}, not of {interface.model}")
    return time, inputs, state[start + length :]
