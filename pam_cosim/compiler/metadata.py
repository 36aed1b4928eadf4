"""Names, units and attributes of variables; the experiment annotation."""

from __future__ import annotations

from typing import Any

from pam_cosim.compiler.arithmetic import simplified
from pam_cosim.compiler.evaluation import Evaluator
from pam_cosim.compiler.instance import Instance
from pam_cosim.compiler.names_of_references import EnumerationLiteral
from pam_cosim.compiler.syntax import Literal, Modification, Unary
from pam_cosim.errors import ModelError
from pam_cosim.model.interface import Variable

EXPERIMENT = {"StopTime": "stop_time", "Interval": "interval", "Tolerance": "tolerance"}
_INTERVALS = 500
_TEXTS = {"unit": "unit", "displayUnit": "display_unit", "quantity": "quantity"}
_ATTRIBUTES = {**_TEXTS, **{name: name for name in ("start", "min", "max", "nominal")}}


def variable(instance: Instance, constants: Evaluator, start: float | None = None) -> Variable:
    """The quantity that an instance is, with the attributes of its type and its modifications.

    Args:
        instance: a Real variable.
        constants: evaluates attributes at the default parameters.
        start: the value at the start, if it is known better than the ``start`` attribute.
    """

    stated: dict[str, Any] = {}
    for name, field in _ATTRIBUTES.items():
        if name not in instance.attributes or (name == "start" and start is not None):
            continue
        value = _attribute(instance, name, constants)
        if name in _TEXTS and isinstance(value, str):
            stated[field] = value
        elif name not in _TEXTS and isinstance(value, int | float) and not isinstance(value, bool):
            stated[field] = float(value)
    if start is not None:
        stated["start"] = start
    return Variable(name=instance.name, description=instance.description, **stated)


def _attribute(instance: Instance, name: str, constants: Evaluator) -> object:
    bound = instance.attributes.get(name)
    return None if bound is None else simplified(constants.bound(bound))


def is_fixed(instance: Instance, constants: Evaluator) -> bool:
    """Whether the start value is an equation."""
    return _attribute(instance, "fixed", constants) is True


def state_preference(instance: Instance, constants: Evaluator) -> float:
    """How strongly a variable is preferred as a state: by ``stateSelect``, then by ``fixed``.

    A class may let a parameter say so; the states are the same in either case.
    """
    chosen = _attribute(instance, "stateSelect", constants)
    name = chosen.name if isinstance(chosen, EnumerationLiteral) else "default"
    weight = {"never": -1000.0, "avoid": -100.0, "default": 0.0, "prefer": 100.0, "always": 1000.0}[
        name
    ]
    return weight + (3.0 if "fixed" in instance.attributes else 0.0)


def experiment(instance: Instance) -> dict[str, Any]:
    """``stop_time``, ``interval`` and ``tolerance`` from the experiment annotation.

    The annotation of the class counts, else that of a class it extends. Without an interval, the duration is
    divided by 500.
    """
    for ancestor in instance.ancestors:
        argument = ancestor.definition.annotation.argument("experiment")
        if argument is not None:
            return _settings(argument.modification, ancestor.definition.qualified_name)
    return {}


def libraries(root: Instance) -> tuple[tuple[str, str], ...]:
    """Name and version of every top-level package with a ``version`` annotation that a component comes from."""
    versions: dict[str, str] = {}
    for node in root.nodes():
        for ancestor in node.ancestors:
            package = ancestor.definition
            while package.parent is not None:
                package = package.parent
            version = package.annotation.argument("version")
            if version is not None and isinstance(version.modification.value, Literal):
                versions[package.name] = str(version.modification.value.value)
    return tuple(sorted(versions.items()))


def _settings(modification: Modification, where: str) -> dict[str, float]:
    settings = {}
    for entry in modification.arguments:
        key = EXPERIMENT.get(entry.name)
        if key is not None:
            value = entry.modification.value
            if not isinstance(value, Literal) or not isinstance(value.value, int | float):
                kind = "a number" if not isinstance(value, Unary) else "a positive number"
                raise ModelError(f"experiment annotation of {where}: {entry.name} must be {kind}")
            settings[key] = float(value.value)
    if "stop_time" in settings and "interval" not in settings:
        settings["interval"] = settings["stop_time"] / _INTERVALS
    return settings
