"""A class in the class tree: its bases, components, and replaceable parts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class BaseInfo:
    """One ``extends``: full name of the base class, and what modifies it, as text by (dotted) name."""

    name: str
    modifications: dict[str, str]
    text: str


@dataclass(frozen=True)
class ComponentInfo:
    """One declared component.

    Attributes:
        name: as declared.
        type: full name of its class, or a built-in type; as written if it cannot be found.
        prefixes: ``parameter``, ``input``, ``inner``, ``replaceable``, ``protected``, ..., with those of a short class
            that is its type.
        modifications: text by (dotted) name; ``value`` is the binding.
        text: the whole modification as text.
        dimensions: sizes as text.
        condition: as text, empty if there is none.
        constraint: full name of the constraining class of a replaceable component, else empty.
        owner: full name of the class that declares it.
        position: middle of its place in an icon or a diagram, None if it has none.
        own_annotation: the entries of its annotation ``VENDOR``, by name: a text, or the numbers in braces; none for
            anything else.
    """

    name: str
    type: str
    prefixes: frozenset[str]
    modifications: dict[str, str]
    value: str
    text: str
    dimensions: tuple[str, ...]
    condition: str
    description: str
    constraint: str
    owner: str
    line: int
    position: tuple[float, float] | None = None
    own_annotation: Mapping[str, str | tuple[float, ...]] = field(default_factory=dict)


@dataclass(frozen=True)
class ReplaceableInfo:
    """A replaceable class: ``replaceable model Gas = Default constrainedby Constraint``, full names."""

    name: str
    kind: str
    default: str
    constraint: str
    description: str
    owner: str


@dataclass(frozen=True)
class ClassInfo:
    """What a class declares itself; what it inherits is found by the methods of :class:`ClassTree`.

    Attributes:
        name: full name.
        kind: ``model``, ``package``, ``function``, ``connector``, ``record``, ``type`` or ``block``.
        prefixes: of a short class, ``input`` in ``connector RealInput = input Real``.
        annotations: top-level annotations as text, by name, but for graphics.
        documentation: the ``info`` string of the Documentation annotation.
    """

    name: str
    kind: str
    partial: bool
    description: str
    extends: tuple[BaseInfo, ...]
    components: tuple[ComponentInfo, ...]
    replaceables: tuple[ReplaceableInfo, ...]
    prefixes: frozenset[str]
    annotations: dict[str, str]
    documentation: str
    file: Path | str
    line: int
