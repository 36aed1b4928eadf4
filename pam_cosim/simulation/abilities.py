"""What an FMU can do in addition to a step."""

from __future__ import annotations

from typing import NamedTuple

from pam_cosim.fmu.description_file import ModelDescription


class Abilities(NamedTuple):
    """What an FMU declares that it can do in addition to a step.

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
    """What a model description declares; ``slopes`` where the binary has been queried."""
    flags = description.coSimulation
    assert flags is not None
    return Abilities(
        flags.canGetAndSetFMUState,
        flags.canGetAndSetFMUState and flags.canSerializeFMUState,
        slopes,
        flags.canHandleVariableCommunicationStepSize,
    )
