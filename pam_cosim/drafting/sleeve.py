"""A sleeve by the measures that the user states: what shall follow from them is zero, and no default."""

from __future__ import annotations

from collections.abc import Mapping

from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface
from pam_cosim.units import UnitError, parse_quantity
from pam_cosim.wording import listed

_MEASURES = ("L0", "D0", "turns", "b", "alpha_0")
_AROUND = ("D0", "turns")
_ENOUGH = 3  # of them, one of them around, determine a sleeve


def following_measures(stated: Mapping[str, str], interface: Interface) -> dict[str, str]:
    """Zero for each measure of a sleeve that follows from those that are stated, and would contradict them.

    Raises:
        InputError: a default contradicts what is stated, and nothing says which one; says what to state.
    """
    owners = dict.fromkeys(name.rpartition(".")[0] for name in stated)
    return {name: "0" for owner in owners for name in _following(f"{owner}.", stated, interface)}


def _following(owner: str, stated: Mapping[str, str], interface: Interface) -> list[str]:
    names = [owner + one for one in _MEASURES]
    if not all(name in interface.parameters for name in names):
        return []
    said = [name for name in names if name in stated and _is_there(name, stated[name], interface)]
    left = [name for name in names if name not in stated and interface.parameters[name].start]
    if len(said) + len(left) <= _ENOUGH or not left:
        return []
    if len(said) >= _ENOUGH and {*said} & {owner + one for one in _AROUND}:
        return left
    hint = " or ".join(f"--parameter {name}=0" for name in left)
    raise InputError(
        f"the sleeve is determined by three of {listed(names)}: {listed(said)} is stated, and the default of "
        f"{listed(left)} holds too; state three, or say what shall follow from the others: {hint}"
    )


def _is_there(name: str, value: str, interface: Interface) -> bool:
    """Whether a stated value is one; zero means that it follows."""
    try:
        return parse_quantity(value, interface.parameters[name].unit) != 0.0
    except UnitError:
        return True  # Its fault is told where values are checked.
