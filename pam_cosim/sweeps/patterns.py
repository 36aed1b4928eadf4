"""Inputs over time that are varied from run to run, each under a name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import Inputs

INPUTS = "inputs"  # what stands for all inputs over time among the names that are varied


@dataclass(frozen=True)
class Pattern:
    """Inputs over time, and what they are called in results."""

    name: str
    inputs: Inputs


def varies_inputs(vary: Any, interface: Interface) -> bool:
    """Whether inputs over time are varied; a model may have a parameter of that name itself."""
    return isinstance(vary, Mapping) and INPUTS in vary and INPUTS not in interface.settable


def read_patterns(given: Any, read: Callable[[Any], Inputs | None]) -> tuple[Pattern, ...]:
    """The patterns of a list, or by their names of a mapping.

    Args:
        given: several inputs over time; a file has its own name, others their place from 0.
        read: makes inputs of one of them.

    Raises:
        InputError: not a list, none at all, two of one name; as ``read``.
    """
    if isinstance(given, (str, Path)) or not isinstance(given, Iterable):
        raise InputError(
            f"'{INPUTS}' is varied: give a list of inputs over time, or a mapping of names to them"
        )
    pairs = (
        list(given.items())
        if isinstance(given, Mapping)
        else [(str(s if isinstance(s, (str, Path)) else i), s) for i, s in enumerate(given)]
    )
    patterns = []
    for name, source in pairs:
        inputs = read(source)
        if inputs is None:
            raise InputError(f"'{INPUTS}' is varied, but '{name}' has no inputs")
        patterns.append(Pattern(str(name), inputs))
    if not patterns:
        raise InputError(f"'{INPUTS}' is varied over no value at all; give one at least")
    names = [p.name for p in patterns]
    twice = next((n for n in names if names.count(n) > 1), None)
    if twice is not None:
        raise InputError(f"'{INPUTS}' is varied over '{twice}' twice; give each a name of its own")
    return tuple(patterns)
