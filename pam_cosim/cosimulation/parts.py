"""What a coupled system is made of: FMUs, controllers written in Python, and the connections between them."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from pam_cosim.cosimulation.rig import input_of, positive_seconds
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, convert, is_dimensionless
from pam_cosim.wording import Printed, did_you_mean, listed, shown

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_-]*")
_ARROW = re.compile(r"\s*(\S+)\s*->\s*(\S+)\s*")


@dataclass(frozen=True)
class CoupledFmu:
    """One FMU of a system.

    Attributes:
        name: in the system.
        model: what it was made from, as the user names it.
        path: of the FMU.
        interface: its variables.
        feedthrough: by output, the inputs it depends on at once.
        declared: whether its model description states it; else every output depends on every input.
        foreign: it runs in a process of its own.
        seconds: distance of its samples [s], where it acts as a controller does: at each sample it makes one step with
            the inputs of that time, its outputs are held until the next one, and it is never taken back. None: it
            makes every step of the system.
    """

    name: str
    model: str
    path: Path
    interface: Interface
    feedthrough: Mapping[str, frozenset[str]]
    declared: bool = True
    foreign: bool = False
    seconds: float | None = None


@dataclass(frozen=True)
class Controller(Printed):
    """A function of Python's as a component, called at equal distances of time; its outputs are held in between.

    The function gets the time [s] and its inputs by name, and returns its outputs by name, or one number where it has
    one output. It is called once for every sample, in order, and never for a step that is taken back: it may keep a
    memory.

    Attributes:
        function: ``function(time, **inputs)``.
        inputs, outputs: name to unit.
        interval: [s] between two calls, or a text such as "10 ms".
    """

    function: Callable[..., Any]
    inputs: Mapping[str, str]
    outputs: Mapping[str, str]
    interval: float | str = "10 ms"
    seconds: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "seconds", positive_seconds(self.interval))
        if not self.outputs:
            raise InputError("a controller needs an output at least")

    def __str__(self) -> str:
        ports = f"{', '.join(self.inputs)} -> {', '.join(self.outputs)}"
        return f"{self.model}: {ports}, every {self.seconds:g} s"

    @property
    def model(self) -> str:
        """Its name, for messages."""
        return str(getattr(self.function, "__name__", "controller"))

    @property
    def interface(self) -> Interface:
        """Inputs and outputs, as an FMU has them."""
        inputs = {name: Variable(name, unit) for name, unit in self.inputs.items()}
        return Interface(
            self.model, inputs, {name: Variable(name, unit) for name, unit in self.outputs.items()}
        )

    def __call__(self, *arguments: Any, **inputs: Any) -> Any:
        """As the function itself."""
        return self.function(*arguments, **inputs)


def controller(
    *, inputs: Mapping[str, str], outputs: Mapping[str, str], interval: float | str = "10 ms"
) -> Callable[[Callable[..., Any]], Controller]:
    """Makes a component of a function.

    ```python
    @pam.controller(inputs={"x": "m"}, outputs={"u_in": "A"}, interval="10 ms")
    def lift(time, x):
        return 0.35 if x < 0.02 else 0.0
    ```
    """
    return partial(Controller, inputs=inputs, outputs=outputs, interval=interval)


Component = CoupledFmu | Controller


class Port(NamedTuple):
    """A variable of a component."""

    component: str
    variable: str

    def __str__(self) -> str:
        return f"{self.component}.{self.variable}"


@dataclass(frozen=True)
class Connection:
    """An output that an input follows: target = factor source + offset, in the units of the two models."""

    source: Port
    target: Port
    factor: float = 1.0
    offset: float = 0.0

    def __str__(self) -> str:
        return f"{self.source} -> {self.target}"

    def __call__(self, value: float) -> float:
        """The input where the output has this value."""
        return self.factor * value + self.offset


def port(text: str, components: Mapping[str, Component]) -> Port:
    """``component.variable``.

    Raises:
        InputError: there is no such component; names the nearest one.
    """
    name, dot, variable = text.partition(".")
    if not dot or not variable:
        raise InputError(f"{shown(text)}: write COMPONENT.VARIABLE")
    if name not in components:
        raise InputError(
            f"{shown(text)}: there is no component '{name}'; {did_you_mean(name, components)}"
        )
    return Port(name, variable)


def connect(text: str, components: Mapping[str, Component]) -> Connection:
    """``a.out -> b.in``, with the units converted.

    Raises:
        InputError: not of that form, unknown names, or units that do not fit.
    """
    match = _ARROW.fullmatch(text)
    if match is None:
        raise InputError(f"connection {shown(text)}: write 'a.output -> b.input'")
    return joined(port(match[1], components), port(match[2], components), components)


def joined(source: Port, target: Port, components: Mapping[str, Component]) -> Connection:
    """The connection of two ports, with the units converted.

    Raises:
        InputError: as ``connect``.
    """
    try:
        given = output_of(source.variable, components[source.component].interface)
        taken = input_of(target.variable, components[target.component].interface)
    except InputError as problem:
        raise InputError(f"connection '{source} -> {target}': {problem.message}") from None
    if not _takes(given, taken):
        raise InputError(
            f"connection '{source} -> {target}': the source is of type {given.kind}, and the target must be "
            f"{taken.values}"
        )
    if (
        not given.unit
        or not taken.unit
        or given.unit == taken.unit
        or (is_dimensionless(given.unit) and is_dimensionless(taken.unit))
    ):
        return Connection(source, target)  # of one unit, or one of them does not say what it is
    try:
        low, high = convert(np.array([0.0, 1.0]), given.unit, taken.unit)
    except UnitError as problem:
        raise InputError(f"connection '{source} -> {target}': {problem}") from None
    return Connection(source, target, float(high - low), float(low))


def _takes(given: Variable, taken: Variable) -> bool:
    """Whether every value of one variable is one of another: 0 and 1 are numbers, and items are whole ones."""
    if taken.kind == "Enumeration":
        return {*(given.items or {}).values()} <= {*(taken.items or {}).values()} and bool(
            given.items
        )
    order = ["Boolean", "Integer", "Real"]
    kind = "Integer" if given.kind == "Enumeration" else given.kind
    return order.index(kind) <= order.index(taken.kind)


def output_of(name: str, interface: Interface) -> Variable:
    """The output of that name.

    Raises:
        InputError: there is none; names the nearest one.
    """
    if name not in interface.outputs:
        raise InputError(interface.unknown(name, "output", interface.outputs))
    return interface.outputs[name]


def check_name(name: str) -> None:
    """Raises ``InputError`` where this cannot be the name of a component."""
    if not _NAME.fullmatch(name):
        raise InputError(
            f"{shown(name)} cannot name a component: letters, digits, '_' and '-', no dot"
        )


def check_once(connections: tuple[Connection, ...], given: Mapping[str, str]) -> None:
    """Every input has one source.

    Args:
        connections: of the system.
        given: inputs that get their values otherwise, and how.

    Raises:
        InputError: one has two.
    """
    sources: dict[Port, list[str]] = {}
    for connection in connections:
        sources.setdefault(connection.target, []).append(str(connection.source))
    for target, names in sources.items():
        names = names + [given[str(target)]] if str(target) in given else names
        if len(names) > 1:
            raise InputError(
                f"input '{target}' has more than one source: {listed(names)}; keep one of them"
            )
