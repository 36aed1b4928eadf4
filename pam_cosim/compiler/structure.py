"""The components and replaceable classes of one model as it is put together, redeclarations included."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from pam_cosim.compiler.budget import bounded
from pam_cosim.compiler.compile import instantiate
from pam_cosim.compiler.instance import Instance
from pam_cosim.compiler.instantiation import Instantiator
from pam_cosim.compiler.part import Part, component_nodes, parts_of
from pam_cosim.compiler.redeclaration import followed
from pam_cosim.compiler.syntax import ClassDefinition


@dataclass(frozen=True)
class Slot:
    """A replaceable class inside a model.

    Attributes:
        path: component that has it; empty for the model itself.
        name: name of the class there.
        constraint: full name of the class that a replacement must extend.
        default: full name of the class that its declaration puts there.
        current: full name of the class that is there now.
    """

    path: str
    name: str
    constraint: str
    default: str
    current: str


@dataclass(frozen=True)
class Structure:
    """All parts and slots of a model, outer ones first."""

    model: str
    parts: tuple[Part, ...]
    slots: tuple[Slot, ...]


@bounded
def read_structure(
    model: str, *, files: Sequence[Path] = (), root: Path | None = None
) -> Structure:
    """What a model consists of; arguments as for :func:`pam_cosim.compiler.compile_model`.

    Raises:
        ModelError: the model cannot be found or put together.
    """
    instantiator, top = instantiate(model, files=files, root=root)
    slots = [slot for node in component_nodes(top) for slot in _slots(node, instantiator)]
    return Structure(top.ancestors[0].definition.qualified_name, parts_of(top), tuple(slots))


def _slots(node: Instance, instantiator: Instantiator) -> list[Slot]:
    slots = []
    for ancestor in node.ancestors:
        for name, nested in ancestor.definition.classes.items():
            if "replaceable" in nested.prefixes and name in node.classes:
                lookup = instantiator.lookup
                classes = (lookup.of(nested), node.classes[name])
                default, current = (followed(lookup, c).definition.qualified_name for c in classes)
                constraint = _constraint(nested, instantiator, default)
                slots.append(Slot(node.name, name, constraint, default, current))
    return slots


def _constraint(nested: ClassDefinition, instantiator: Instantiator, default: str) -> str:
    lookup = instantiator.lookup
    if nested.constraint is None:
        return default
    assert nested.parent is not None
    scope = lookup.static_scope(nested.parent)
    return lookup.require(scope, nested.constraint.type, nested).definition.qualified_name
