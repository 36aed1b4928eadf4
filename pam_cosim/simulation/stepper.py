"""One run of an FMU step by step: what a loop in the laboratory does, and what a coupling of FMUs is made of."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from fmpy.fmi1 import FMICallException

from pam_cosim.errors import InputError
from pam_cosim.fmu.read import Slot
from pam_cosim.simulation.abilities import Abilities
from pam_cosim.simulation.driver import Callbacks, RunProgress
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.instance import Instance, major_version
from pam_cosim.simulation.values import Values, named_references

_SLOPES_BESIDE_FMI = (
    "pam_set_input_slopes"  # of our own FMUs of version 3.0, which has no slopes of inputs
)
_LAST_SUCCESSFUL_TIME, _TERMINATED = 2, 3  # fmi2StatusKind
_ENDS = "the FMU ends the simulation"


class _Call:
    """Around a call of an FMU; one for all, for they are many."""

    def __init__(self, ended: Callable[[BaseException | None], None]) -> None:
        self._ended = ended

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: object, failure: BaseException | None, place: object) -> None:
        self._ended(failure)


class Stepper:
    """One run of an FMU, in this process, or in another one behind ``RemoteStepper``.

    Values are in the units that the model description declares. Every function but ``abilities`` raises ``RunFailure``
    where the FMU fails; ``save`` and what follows from it raise ``InputError`` where the FMU cannot do that.

    Args:
        instance: FMPy's face of it, instantiated.
        abilities: what it can do.
        callbacks: where its messages arrive.
        slots: its variables by name.
        file: its name, for messages.
    """

    def __init__(
        self,
        instance: Instance,
        abilities: Abilities,
        callbacks: Callbacks,
        slots: Mapping[str, Slot],
        file: str,
    ) -> None:
        self._instance, self._abilities, self._callbacks = instance, abilities, callbacks
        self._slots, self._file = slots, file
        self._version = major_version(instance)
        self._variables = Values(instance, slots, self._version)
        self._states: dict[int, tuple[Any, float]] = {}
        self._next = 0
        self._begun = False
        self._calls, self._active = 0, ""
        self._call = _Call(self._ended)
        self.time = 0.0

    @property
    def progress(self) -> RunProgress | None:
        """The present call of the FMU, for another thread; None between calls."""
        active = self._active
        return RunProgress(active, self._calls, self.time) if active else None

    def abilities(self) -> Abilities:
        """What the FMU can do."""
        return self._abilities

    def take_messages(self) -> list[str]:
        """Messages of the FMU since the last call."""
        return [named_references(text, self._slots) for text in self._callbacks.take_messages()]

    def begin(
        self, values: Mapping[str, float], start_time: float = 0.0, tolerance: float | None = None
    ) -> None:
        """Starts a run with these parameters, inputs and start values; it is then in initialization mode."""
        self._callbacks.take_messages()
        self._begun, self.time = True, start_time
        self._set(values)
        name = f"fmi{self._version}EnterInitializationMode"
        if self._version == 2:
            with self._calling("fmi2SetupExperiment"):
                self._instance.setupExperiment(tolerance=tolerance, startTime=start_time)
            with self._calling(name):
                self._instance.enterInitializationMode()
        else:
            with self._calling(name):
                self._instance.enterInitializationMode(tolerance=tolerance, startTime=start_time)

    def initialised(self) -> None:
        """Ends the initialization mode: steps may follow."""
        with self._calling(f"fmi{self._version}ExitInitializationMode"):
            self._instance.exitInitializationMode()

    def read(self, names: Sequence[str], inputs: Mapping[str, float] | None = None) -> list[float]:
        """Values at the present time, after ``inputs`` were set."""
        self._set(inputs or {})
        if not names:
            return []
        with self._calling(f"fmi{self._version}Get{self._variables.kinds(names)}"):
            values = self._variables.get(names)
        for name, value in zip(names, values, strict=True):
            if not math.isfinite(value):
                raise RunFailure(
                    f"'{name}' is not a finite number at time {self.time:.6g} s", self.time
                )
        return list(values)

    def advance(
        self,
        duration: float,
        inputs: Mapping[str, float] | None = None,
        slopes: Mapping[str, float] | None = None,
        names: Sequence[str] = (),
        can_go_back: bool = False,
    ) -> list[float]:
        """One step of ``duration`` [s], with ``inputs`` at its start that change by ``slopes`` [1/s]; reads ``names``.

        An FMU that takes no slopes gets the value in the middle of the step. ``can_go_back``: the run may return to a
        state from before the step.
        """
        given, ends = dict(inputs or {}), dict[str, float]()
        rising = {
            name: slope
            for name, slope in (slopes or {}).items()
            if not self._variables.selection((name,)).is_discrete[0]
        }
        if self._abilities.slopes:
            self._set(given)
            self._set_slopes(
                {
                    name: rising.get(name, 0.0)
                    for name in given
                    if any(g.is_slope for g in self._variables.selection((name,)).groups)
                }
            )
        else:
            self._set(
                {
                    name: value + 0.5 * duration * rising.get(name, 0.0)
                    for name, value in given.items()
                }
            )
            # what follows at once from an input would else be read half a step late
            ends = {n: given[n] + duration * slope for n, slope in rising.items() if slope}
        self._step(duration, can_go_back)
        self.time += duration
        return self.read(names, ends)

    def save(self) -> int:
        """Keeps the present state under a number."""
        self._demand(self._abilities.saves, "save its state", "canGetAndSetFMUstate")
        with self._calling("fmi2GetFMUstate" if self._version == 2 else "fmi3GetFMUState"):
            return self._keep(self._instance.getFMUState(), self.time)

    def restore(self, number: int) -> None:
        """Goes back to a saved state; it stays saved."""
        state, time = self._states[number]
        with self._calling("fmi2SetFMUstate" if self._version == 2 else "fmi3SetFMUState"):
            self._instance.setFMUState(state)
        self.time = time

    def forget(self, number: int) -> None:
        """Frees a saved state."""
        state, _ = self._states.pop(number)
        with self._calling("fmi2FreeFMUstate" if self._version == 2 else "fmi3FreeFMUState"):
            self._instance.freeFMUState(state)

    def freeze(self, number: int) -> bytes:
        """A saved state as bytes."""
        self._demand(
            self._abilities.serialises, "turn its state into bytes", "canSerializeFMUstate"
        )
        state, _ = self._states[number]
        with self._calling(
            "fmi2SerializeFMUstate" if self._version == 2 else "fmi3SerializeFMUState"
        ):
            return bytes(self._instance.serializeFMUState(state))

    def thaw(self, state: bytes, time: float) -> int:
        """Makes a saved state from bytes, taken at ``time`` [s]; ``restore`` goes there."""
        self._demand(
            self._abilities.serialises, "make its state from bytes", "canSerializeFMUstate"
        )
        with self._calling(
            "fmi2DeSerializeFMUstate" if self._version == 2 else "fmi3DeserializeFMUState"
        ):
            return self._keep(self._instance.deserializeFMUState(state), time)

    def close(self) -> None:
        """Frees the saved states; the instance must still be there."""
        self._begun = False
        for number in list(self._states):
            try:
                self.forget(number)
            except RunFailure:  # it has failed for good, and its memory goes with it
                self._states.clear()
                return

    def _keep(self, state: Any, time: float) -> int:
        self._next += 1
        self._states[self._next] = (state, time)
        return self._next

    def _demand(self, able: bool, what: str, flag: str) -> None:
        if not able:
            raise InputError(
                f"{self._file} cannot {what}: its model description does not declare {flag}; "
                "start it again and repeat the steps instead"
            )

    def _set(self, values: Mapping[str, float]) -> None:
        if not values:
            return
        with self._calling(f"fmi{self._version}Set{self._variables.kinds([*values])}"):
            self._variables.set(values)

    def _set_slopes(self, slopes: Mapping[str, float]) -> None:
        if not slopes:
            return
        references = [self._slots[name].scalar.valueReference for name in slopes]
        values = list(slopes.values())
        if self._version == 2:
            with self._calling("fmi2SetRealInputDerivatives"):
                self._instance.setRealInputDerivatives(references, [1] * len(values), values)
        else:
            self._beside_fmi(references, values)

    def _beside_fmi(self, references: Sequence[int], values: Sequence[float]) -> None:
        from ctypes import c_double, c_int32, c_size_t, c_uint32, c_void_p

        n = len(references)
        function = getattr(self._instance.dll, _SLOPES_BESIDE_FMI)
        arguments = (
            (c_uint32 * n)(*references),
            c_size_t(n),
            (c_int32 * n)(*[1] * n),
            (c_double * n)(*values),
        )
        with self._calling(_SLOPES_BESIDE_FMI):
            if function(c_void_p(self._instance.component), *arguments) > 1:
                raise FMICallException(function=_SLOPES_BESIDE_FMI, status=3)

    def _step(self, duration: float, can_go_back: bool) -> None:
        keep = not can_go_back
        if self._version == 2:
            with self._calling("fmi2DoStep"):
                self._instance.doStep(self.time, duration, int(keep))
            return
        with self._calling("fmi3DoStep"):
            _, terminate, early, reached = self._instance.doStep(self.time, duration, keep)
        if terminate or early:
            raise self._failure("fmi3DoStep", reached, _ENDS)

    def _calling(self, function: str) -> _Call:
        """Around a call of the FMU: keeps the name of the call, and turns a bad status into a failure."""
        if not self._begun and not function.lower().endswith("freefmustate"):
            raise RunFailure(f"the run of {self._file} has ended")
        self._calls += 1
        self._active = function
        return self._call

    def _ended(self, failure: BaseException | None) -> None:
        function, self._active = self._active, ""
        if isinstance(failure, FMICallException):
            default = _ENDS if self._asked(function, "getBooleanStatus", _TERMINATED) else ""
            reached = self._asked(function, "getRealStatus", _LAST_SUCCESSFUL_TIME)
            has_advanced = math.isfinite(reached) and reached > self.time
            raise self._failure(function, reached if has_advanced else self.time, default) from None

    def _asked(self, function: str, query: str, kind: int) -> float:
        """The status of a failed step of an FMU of FMI 2.0; 0: none."""
        if function != "fmi2DoStep":
            return 0.0
        try:
            return float(getattr(self._instance, query)(kind))
        except (FMICallException, AttributeError, KeyError):  # it does not say
            return 0.0

    def _failure(self, function: str, time: float, default: str = "") -> RunFailure:
        messages = self.take_messages()
        reason = default or f"the FMU reports an error in {function} and no reason"
        return RunFailure("; ".join(messages) or reason, time)
