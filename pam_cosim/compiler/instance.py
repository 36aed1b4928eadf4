"""The tree of components that a model consists of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from pam_cosim.compiler.modification import NOTHING, Bound, Mod
from pam_cosim.compiler.scope import Class, Scope
from pam_cosim.compiler.syntax import ComponentDeclaration, Section


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
    classes: dict[str, Class] = field(default_factory=dict)
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
