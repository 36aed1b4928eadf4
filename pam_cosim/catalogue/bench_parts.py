"""The parts that a rig can be put together from: every class of the library and the user's files that is one.

A library says which they are by its interfaces: ``Interfaces.Pneumatics`` feeds a muscle, ``Interfaces.Mechanics``
holds its load end, ``Interfaces.RigMuscle`` is one, ``Interfaces.Instrument`` reads a signal, and ``Interfaces.Rig``
stands around them. A part is chosen by the name of its class, in small letters with hyphens.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from pam_cosim.catalogue.effects import component_name
from pam_cosim.catalogue.place import is_connector, libraries
from pam_cosim.compiler import ClassTree, names
from pam_cosim.compiler.class_info import ClassInfo, ComponentInfo
from pam_cosim.errors import InputError
from pam_cosim.wording import Printed, did_you_mean

ROLES = {
    "pneumatics": "Interfaces.Pneumatics",
    "mechanics": "Interfaces.Mechanics",
    "muscle": "Interfaces.RigMuscle",
    "instrument": "Interfaces.Instrument",
}
FRAME = "Interfaces.Rig"


@dataclass(frozen=True)
class BenchPart(Printed):
    """One part, as its Modelica class declares it.

    Attributes:
        role: ``pneumatics``, ``mechanics``, ``muscle`` or ``instrument``.
        name: by which it is chosen; ``qualified_name`` is that of its class.
        description: one line.
        inputs: names of quantities from outside, which become inputs of the rig.
        signals: names of what it reads; of pneumatics and mechanics, what is usually read where they are used.
        parameters: names of its public parameters that have a value, a minimum and a maximum.
        component_name: name that its instance takes.
        library: the package whose interface it extends.
        usual: it is taken where none is named.
        file: where it is written.
    """

    role: str
    name: str
    qualified_name: str
    description: str
    inputs: tuple[str, ...]
    signals: tuple[str, ...]
    parameters: tuple[str, ...]
    component_name: str
    library: str
    usual: bool
    file: Path

    def __str__(self) -> str:
        return f"{self.name} ({self.role}): {self.description}"


def rig_parts(tree: ClassTree) -> list[BenchPart]:
    """Every part of every library, by role; the order is that of the files, the library's own first."""
    parts: list[BenchPart] = []
    for part in _declared(tree):
        siblings = [
            sibling
            for sibling in parts
            if (sibling.role, sibling.library) == (part.role, part.library)
        ]
        is_usual = part.usual and not any(sibling.usual for sibling in siblings)
        parts.append(part if part.usual == is_usual else replace(part, usual=False))
    return parts


@lru_cache(maxsize=8)
def _declared(tree: ClassTree) -> tuple[BenchPart, ...]:
    parts: list[BenchPart] = []
    for role, interface in ROLES.items():
        for library in libraries(tree):
            base = f"{library}.{interface}"
            names = tree.subtypes(base) if base in tree.classes else []
            parts += [_part(tree, n, role, library) for n in names if _is_complete(tree.classes[n])]
    return tuple(parts)


def _is_complete(info: ClassInfo) -> bool:
    return not info.partial and info.kind in ("model", "block", "class")


def chosen(parts: Sequence[BenchPart], role: str, name: str | None) -> BenchPart:
    """The part of a role that a name means: that of its class, with or without packages; the usual one without a name.

    Raises:
        InputError: there is none, or there are several.
    """
    choices = [part for part in parts if part.role == role]
    if name is None:
        return _usual(choices, role)
    exact = [part for part in choices if part.qualified_name == name]
    matching_parts = exact or [part for part in choices if _bare(part.name) == _bare(name)]
    if not matching_parts:
        hint = did_you_mean(name, [part.name for part in choices])
        raise InputError(f"there is no {role} '{name}'; {hint}")
    if len(matching_parts) > 1:
        full = " or ".join(part.qualified_name for part in matching_parts)
        raise InputError(f"'{name}' is the name of several parts; write {full}")
    return matching_parts[0]


def _usual(choices: Sequence[BenchPart], role: str) -> BenchPart:
    usual = next((part for part in choices if part.usual), None)
    if usual is None:
        raise InputError(
            f"name the {role}; known: {', '.join(part.name for part in choices) or 'none'}"
        )
    return usual


def kebab(name: str) -> str:
    """``HangingLoad`` as ``hanging-load``."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", names.unquoted(name).replace("_", "-")).lower()


def _bare(name: str) -> str:
    """A name without what separates its words: ``DMSP-20`` is ``DMSP20``."""
    return kebab(name).replace("-", "").replace(" ", "")


def connectors(tree: ClassTree, name: str) -> list[ComponentInfo]:
    """The public connectors of a class, in the order of their declaration."""
    return [
        c
        for c in tree.components(name)
        if "protected" not in c.prefixes and is_connector(tree, c.type)
    ]


def free_inputs(tree: ClassTree, name: str) -> list[ComponentInfo]:
    """The inputs of a class that nothing in it binds."""
    bound = _bound(tree, name)
    return [c for c in _public(tree, name, "input") if c.name not in bound]


def measured_outputs(tree: ClassTree, name: str) -> list[ComponentInfo]:
    """The outputs of a class."""
    return _public(tree, name, "output")


def open_parameters(tree: ClassTree, name: str) -> list[ComponentInfo]:
    """The parameters of a class that have no value."""
    bound = _bound(tree, name)
    return [c for c in _public(tree, name, "parameter") if c.name not in bound]


def known_parameters(tree: ClassTree, name: str) -> list[ComponentInfo]:
    """The parameters of a class that have a value."""
    bound = _bound(tree, name)
    return [c for c in _public(tree, name, "parameter") if c.name in bound]


def _public(tree: ClassTree, name: str, prefix: str) -> list[ComponentInfo]:
    return [
        c for c in tree.components(name) if prefix in c.prefixes and "protected" not in c.prefixes
    ]


def _bound(tree: ClassTree, name: str) -> set[str]:
    """What has a value in a class, by itself or by a modification on the way to it."""
    bound_names = {c.name for c in tree.components(name) if c.value}
    heirs = (tree.classes[ancestor] for ancestor in (name, *tree.bases(name)))
    return bound_names.union(*(clause.modifications for info in heirs for clause in info.extends))


def _part(tree: ClassTree, name: str, role: str, library: str) -> BenchPart:
    info, short = tree.classes[name], names.last(name)
    shows = str(tree.constant(name, "shows") or "")
    signals = (
        [c.name for c in measured_outputs(tree, name)] if role == "instrument" else split(shows)
    )
    return BenchPart(
        role=role,
        name=kebab(short),
        qualified_name=name,
        description=info.description,
        inputs=tuple(c.name for c in free_inputs(tree, name)),
        signals=tuple(signals),
        parameters=tuple(
            c.name for c in known_parameters(tree, name) if {"min", "max"} <= c.modifications.keys()
        ),
        component_name=component_name(short, next(filter(None, _stated_names(tree, name)), "")),
        library=library,
        usual=bool(tree.constant(name, "usual")),
        file=Path(info.file),
    )


def _stated_names(tree: ClassTree, name: str) -> Iterator[str]:
    """The default instance names that a class and its bases state: a class that extends a muscle is a muscle too."""
    return (
        tree.classes[ancestor].annotations.get("defaultComponentName", "")
        for ancestor in (name, *tree.bases(name))
    )


def split(listed: str) -> list[str]:
    """``"p, x"`` as names."""
    return [entry.strip() for entry in listed.split(",") if entry.strip()]
