"""Runs in a process of their own: an FMU that crashes or never returns takes nothing else down."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from numpy.typing import ArrayLike

from pam_cosim.counts import checked_time
from pam_cosim.errors import InputError
from pam_cosim.fmu.read import read_description, read_interface
from pam_cosim.model.interface import Interface
from pam_cosim.simulation.driver import Settle
from pam_cosim.simulation.failure import ProcessFailure, RunFailure
from pam_cosim.simulation.inputs import Inputs
from pam_cosim.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from pam_cosim.simulation.stepper import Stepper

# [s] without progress: loading and each call of an FMU take milliseconds as a rule
TIME_LIMIT = 60.0


class IsolatedSimulator:
    """As ``Simulator``, for FMUs that are not trusted: one that crashes or hangs ends one run only.

    Between this process and the FMU's stands a third one, which ends the latter when it makes no progress or when this
    process ends, however it does (``watchdog``). One that hangs while it is loaded is not loaded again.

    A run is made by co-simulation. Where the FMU has none, or reports that it fails, as explicit solvers do on stiff
    models, it is made by model exchange with CVode, in another process, and ``Trajectory.solver`` states it. That
    depends on the run alone, not on those before it.

    Args:
        path: an FMU of FMI 2.0 or 3.0.
        timeout: [s] without progress, after which the FMU is ended: to load it, or in any one call such as a step.
            A running simulation may last any time. None: ``TIME_LIMIT``; infinite: no limit. By model exchange
            a run may also take no more processor time than this; None: than ``LONGEST_RUN``.

    Raises:
        InputError: not such an FMU, or no such limit.
    """

    def __init__(self, path: Path, timeout: float | None = None) -> None:
        self.path, self.timeout = (
            Path(path),
            checked_time(TIME_LIMIT if timeout is None else timeout),
        )
        self._longest = None if timeout is None else self.timeout
        self.interface: Interface = read_interface(self.path)
        self._settles: bool | None = None
        from pam_cosim.simulation.fmu_process import EXCHANGE, FmuProcess

        self._process = FmuProcess(self.path, self.timeout)
        self._exchange = FmuProcess(self.path, self.timeout, EXCHANGE)

    def __enter__(self) -> IsolatedSimulator:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __del__(self) -> None:
        if hasattr(self, "_exchange"):
            self.close()

    def close(self) -> None:
        """Frees the FMU and ends its process, even if it does not respond; the next run starts another."""
        self._process.close()
        self._exchange.close()

    def run(
        self,
        times: ArrayLike,
        *,
        parameters: Mapping[str, float] | None = None,
        inputs: Inputs | None = None,
        outputs: Sequence[str] | None = None,
        tolerance: float | None = None,
        start_time: float | None = None,
        settle: Settle = "none",
    ) -> Trajectory:
        """As ``Simulator.run``; a crash of the FMU, or a call that does not return, is a ``RunFailure`` as well."""
        request = {
            "times": times,
            "parameters": parameters,
            "inputs": inputs,
            "outputs": outputs,
            "tolerance": tolerance,
            "start_time": start_time,
            "settle": settle,
        }
        if read_description(self.path).coSimulation is None:
            return self._exchanged(
                request, f"{self.path.name} is for model exchange: run with CVode"
            )
        try:
            answer = self._process.answer("run", request)
        except ProcessFailure:
            raise
        except RunFailure as failure:
            return self._second_attempt(request, failure)
        assert isinstance(answer, Trajectory)
        return answer

    def _second_attempt(self, request: dict[str, Any], failure: RunFailure) -> Trajectory:
        """The run by model exchange; the first failure, where there is none or it fails as well."""
        if failure.run is not None or read_description(self.path).modelExchange is None:
            raise failure
        name, reason = self.path.name, RunFailure(failure.reason, failure.time)
        solver = f"the co-simulation of {name} fails, so that its model exchange was run with CVode: {reason}"
        try:
            return self._exchanged(request, solver)
        except (RunFailure, InputError):
            raise failure from None

    def _exchanged(self, request: dict[str, Any], solver: str) -> Trajectory:
        try:
            answer = self._exchange.answer("run", request | {"max_seconds": self._longest})
        except RunFailure as failure:
            if failure.run is not None:
                failure.run = replace(failure.run, solver=solver)
            raise
        assert isinstance(answer, Trajectory)
        return replace(answer, solver=solver)

    def equilibria(
        self,
        inputs: Mapping[str, ArrayLike],
        *,
        parameters: Mapping[str, float] | None = None,
        outputs: Sequence[str] | None = None,
    ) -> Trajectory:
        """As ``Simulator.equilibria``; likewise."""
        answer = self._process.answer(
            "equilibria", {"inputs": inputs, "parameters": parameters, "outputs": outputs}
        )
        assert isinstance(answer, Trajectory)
        return answer

    @property
    def settles(self) -> bool:
        """As ``Simulator.settles``."""
        if read_description(self.path).coSimulation is None:
            return False
        if self._settles is None:
            self._settles = bool(self._process.answer("settles", {}))
        return self._settles

    def stepper(self) -> Stepper:
        """A new run, step by step, in the FMU's process; it ends when another run begins, and with that process."""
        return cast("Stepper", RemoteStepper(self._process.answer))


class RemoteStepper:
    """A run of an FMU in a process of its own: every function of ``Stepper`` is called there.

    Args:
        answer: what that process makes of a call.
    """

    def __init__(self, answer: Callable[[str, dict[str, Any], bool], Any]) -> None:
        self._answer = answer

    def __getattr__(self, name: str) -> Callable[..., Any]:
        from pam_cosim.simulation.stepper import Stepper

        if name.startswith("_") or name not in vars(Stepper):
            raise AttributeError(name)
        return lambda *arguments, **named: self._answer(
            name, {"positional": arguments, **named}, name == "begin"
        )
