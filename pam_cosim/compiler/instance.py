"""The tree of components that a model consists of, the places where names are looked up, and what modifies them.

They refer to each other: a place belongs to an instance, a modification to its place, an instance to both.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from pam_cosim.compiler.lazy import LazyDict
from pam_cosim.compiler.source import SourceText
from pam_cosim.compiler.syntax import (
    ClassDefinition,
    ComponentDeclaration,
    Element,
    Expression,
    Member,
    Section,
)


@dataclass(eq=False, repr=False)
class Scope:
    """A class body as a place for lookup.

    Attributes:
        definition: the class whose text is being read.
        instance: the instance that this class contributes to, if there is one.
        outer: the enclosing place; none for the root.
        components, classes: names of the instance that this class declares or inherits. A class that
            inherits from this one may add more to the instance, which are not visible from here.
    """

    definition: ClassDefinition
    instance: Instance | None
    outer: Scope | None
    components: set[str] = field(default_factory=set)
    classes: set[str] = field(default_factory=set)


@dataclass(eq=False, repr=False)
class Class:
    """A class definition, the place where it stands, and what modifies it there.

    Attributes:
        over: modifications with priority over those of a component of this class's own definition.
        under: modifications that a constraining clause supplies.
    """

    definition: ClassDefinition
    outer: Scope | None
    over: Mod | None = None
    under: Mod | None = None


@dataclass(eq=False, repr=False)
class Bound:
    """An expression and the place where its names are looked up; but for ``names`` that have values already."""

    expression: Expression
    scope: Scope
    names: Mapping[str, Any] = field(default_factory=dict)

    def element(self, index: int) -> Bound:
        """Element ``index`` (from 0) of an array-valued expression."""
        return replace(self, expression=Element(self.expression.at, self.expression, index))

    def member(self, name: str) -> Bound:
        """A member of a record-valued expression."""
        return replace(self, expression=Member(self.expression.at, self.expression, name))

    @property
    def source(self) -> SourceText:
        """The text that holds the expression."""
        return self.scope.definition.source


@dataclass(eq=False, repr=False)
class Redeclaration:
    """A new declaration for a replaceable element, and the place where it is written."""

    declaration: ComponentDeclaration | ClassDefinition
    scope: Scope


@dataclass(eq=False, repr=False)
class Mod:
    """The modification of one element from outside: its value, its parts, its replacement."""

    at: int
    source: SourceText | None
    value: Bound | None = None
    entries: dict[str, Mod] = field(default_factory=dict)
    redeclaration: Redeclaration | None = None
    each: bool = False
    final: bool = False

    def element(self, index: int) -> Mod:
        """The modification of element ``index`` (from 0) of an array of components."""
        value = self.value
        if value is not None and not self.each:
            value = value.element(index)
        entries = {
            name: entry if entry.each else entry.element(index)
            for name, entry in self.entries.items()
        }
        return Mod(self.at, self.source, value, entries, self.redeclaration, False, self.final)

    def of_one(self) -> Mod:
        """The modification of one component of an array, from that of the whole array."""
        entries = {name: replace(entry, each=False) for name, entry in self.entries.items()}
        return replace(self, entries=entries)


NOTHING = Mod(0, None)


@dataclass(eq=False, repr=False)
class Instance:
    """One component, an array of components, or the model itself.

    Attributes:
        name: dotted path from the model, with subscripts; empty for the model itself.
        parent: the instance that holds this one.
        scope: the place where the declaration stands, of a redeclared component the new one.
        home: the place of the original declaration; condition and sizes are looked up there.
        declaration: none for the model itself.
        prefixes: of the declaration, with those that apply to all parts of a holder
            (``parameter``, ``constant``, ``protected``, ``final``).
        primitive: ``Real``, ``Integer``, ``Boolean``, ``String`` or ``enumeration`` for a variable.
        kind: kind of the class: ``model``, ``connector``, ``record``, ...
        elements: for an array, its elements.
        target: for an ``outer`` component, the ``inner`` one.
        present: false if its condition is false.
    """

    name: str
    parent: Instance | None
    scope: Scope | None
    declaration: ComponentDeclaration | None
    modification: Mod = NOTHING
    prefixes: frozenset[str] = frozenset()
    home: Scope | None = None
    primitive: str = ""
    kind: str = ""
    definition: Class | None = None
    type: Class | None = None
    elements: list[Instance] | None = None
    children: dict[str, Instance] = field(default_factory=dict)
    classes: LazyDict[Class] = field(default_factory=LazyDict)
    sections: list[tuple[Section, Scope]] = field(default_factory=list)
    attributes: dict[str, Bound] = field(default_factory=dict)
    binding: Bound | None = None
    target: Instance | None = None
    present: bool = True
    expanded: bool = False
    ancestors: list[Class] = field(default_factory=list)

    @property
    def variability(self) -> str:
        """``constant``, ``parameter`` or nothing."""
        return next((word for word in ("constant", "parameter") if word in self.prefixes), "")

    @property
    def local_name(self) -> str:
        """The last part of the name."""
        return self.declaration.name if self.declaration is not None else ""

    @property
    def description(self) -> str:
        """The description string of the declaration."""
        return self.declaration.description if self.declaration is not None else ""

    def resolved(self) -> Instance:
        """The instance itself, or the ``inner`` one it stands for."""
        return self.target if self.target is not None else self

    def leaves(self) -> Iterator[Instance]:
        """All variables below, in order of declaration; absent and outer components left out."""
        if not self.present or self.target is not None:
            return
        if self.elements is not None:
            for element in self.elements:
                yield from element.leaves()
        elif self.primitive:
            yield self
        else:
            for child in self.children.values():
                yield from child.leaves()

    def nodes(self) -> Iterator[Instance]:
        """This instance and all that are not variables below."""
        if not self.present or self.target is not None or self.primitive:
            return
        if self.elements is not None:
            for element in self.elements:
                yield from element.nodes()
        else:
            yield self
            for child in self.children.values():
                yield from child.nodes()
