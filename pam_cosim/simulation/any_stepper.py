"""What can be asked of a model that goes in steps, whatever stands behind it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from fmpy.model_description import ModelDescription


@dataclass(frozen=True)
class Abilities:
    """What an FMU says it can do beside a step.

    Attributes:
        saves: it can save its state and go back to it.
        serialises: a saved state can be turned into bytes and back.
        slopes: inputs may be given with their slopes.
        any_step: the distance of communication points may change.
    """

    saves: bool
    serialises: bool
    slopes: bool
    any_step: bool


def abilities_of(description: ModelDescription, slopes: bool) -> Abilities:
    """What a model description declares; ``slopes`` where the binary has been asked."""
    flags = description.coSimulation
    return Abilities(
        bool(flags.canGetAndSetFMUstate),
        bool(flags.canGetAndSetFMUstate and flags.canSerializeFMUstate),
        slopes,
        bool(flags.canHandleVariableCommunicationStepSize),
    )


class AnyStepper(Protocol):
    """One run of an FMU, in this process or in another.

    Values are in the units that the model description declares. Every function but ``abilities`` raises ``RunFailure``
    where the FMU fails; ``save`` and what follows from it raise ``InputError`` where the FMU cannot do that.
    """

    def abilities(self) -> Abilities:
        """What the FMU can do."""

    def begin(
        self, values: Mapping[str, float], start_time: float = 0.0, tolerance: float | None = None
    ) -> None:
        """Starts a run with these parameters, inputs and start values; it is then in initialization mode."""

    def initialised(self) -> None:
        """Ends the initialization mode: steps may follow."""

    def read(self, names: Sequence[str], inputs: Mapping[str, float] | None = None) -> list[float]:
        """Values at the present time, after ``inputs`` were set."""

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

    def save(self) -> int:
        """Keeps the present state under a number."""

    def restore(self, number: int) -> None:
        """Goes back to a saved state; it stays saved."""

    def forget(self, number: int) -> None:
        """Frees a saved state."""

    def freeze(self, number: int) -> bytes:
        """A saved state as bytes."""

    def thaw(self, state: bytes, time: float) -> int:
        """Makes a saved state from bytes, taken at ``time`` [s]; ``restore`` goes there."""

    def take_messages(self) -> list[str]:
        """What the FMU has said since the last call."""
