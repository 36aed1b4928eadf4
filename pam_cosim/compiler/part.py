"""A component of a model, and the classes that it consists of."""

from __future__ import annotations

from dataclasses import dataclass

from pam_cosim.compiler.instance import Instance


@dataclass(frozen=True)
class Part:
    """A component that is no variable.

    Attributes:
        path: dotted name from the model; empty for the model itself.
        type: full name of its class.
        bases: full names of all classes it consists of, itself included.
        connectors: its connectors, with the full names of their classes.
        parameters: its public parameters.
    """

    path: str
    type: str
    bases: tuple[str, ...]
    connectors: dict[str, str]
    parameters: tuple[str, ...]


def parts_of(top: Instance) -> tuple[Part, ...]:
    """Every component of a model that is no variable, the model itself first."""
    return tuple(map(_part, component_nodes(top)))


def component_nodes(top: Instance) -> list[Instance]:
    """The components that are neither variables nor connectors nor records."""
    return [node for node in top.nodes() if node.kind not in ("connector", "record")]


def _part(node: Instance) -> Part:
    bases = dict.fromkeys(ancestor.definition.qualified_name for ancestor in node.ancestors)
    public = {
        name: child for name, child in node.children.items() if "protected" not in child.prefixes
    }
    connectors = {
        name: child.type.definition.qualified_name
        for name, child in public.items()
        if child.kind == "connector" and child.type is not None and child.present
    }
    parameters = tuple(name for name, child in public.items() if child.variability == "parameter")
    first = next(a.definition for a in node.ancestors if a.definition.alias is None)
    return Part(node.name, first.qualified_name, tuple(bases), connectors, parameters)
