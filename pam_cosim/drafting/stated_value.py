"""Values that the user states of a recording, and how ``experiment.toml`` has them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pam_cosim.model.interface import Interface
from pam_cosim.units import UnitError, parse_quantity, readable_factor, readable_unit


@dataclass(frozen=True)
class StatedValue:
    """A value that is known of one recording: as text for the file, and why.

    ``is_start``: the recording itself happens to begin so; nobody chose it.
    """

    value: str
    number: float
    why: str
    is_start: bool = False


def text_of(value: float, unit: str) -> str:
    """A value [SI] as ``experiment.toml`` has it, in a unit that is easy to read."""
    number = f"{value * readable_factor(unit):.6g}"
    shown = readable_unit(unit)
    shown = {"mm²": "mm2", "L": "l"}.get(shown, shown)
    return f"{number} {shown}".strip()


def stated_values(own: Mapping[str, str], interface: Interface) -> dict[str, StatedValue]:
    """What the user states of one recording."""
    variables = {**interface.parameters, **interface.inputs}
    return {
        name: StatedValue(
            value, parse_quantity(value, variables[name].unit) if name in variables else 0.0, ""
        )
        for name, value in own.items()
    }


def check_stated(stated: Mapping[str, str], interface: Interface) -> None:
    """Raises UnitError where a stated value has a unit that does not fit; names are checked when all is read."""
    for name, value in stated.items():
        variable = {**interface.parameters, **interface.inputs}.get(name)
        if variable is not None:
            try:
                parse_quantity(value, variable.unit)
            except UnitError as error:
                raise UnitError(f"{name}: {error}") from None
