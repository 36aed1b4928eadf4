"""What a name means at its place: a component, a class, or a literal of an enumeration."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from pam_cosim.compiler.instance import Class, Instance, Scope
from pam_cosim.compiler.lookup import Lookup
from pam_cosim.compiler.syntax import Reference
from pam_cosim.errors import ModelError

# Enumerations that the language brings (Modelica 3.6, sections 4.4.4.2 and 8.3.7).
ENUMERATIONS = {
    "StateSelect": ("never", "avoid", "default", "prefer", "always"),
    "AssertionLevel": ("warning", "error"),
}


class AbsentComponent(ModelError):
    """A component that its condition switches off is referred to."""


@dataclass(frozen=True)
class EnumerationLiteral:
    """A value of an enumeration; ``number`` counts from 1."""

    name: str
    number: int


@dataclass(eq=False, repr=False)
class ClassValue:
    """A class or package met on the way through a dotted name."""

    of: Class


class Holders(Protocol):
    """What has components by name: instances, and packages as holders of constants."""

    lookup: Lookup

    def expand(self, instance: Instance) -> Instance:
        """The instance with its parts."""
        ...

    def package(self, of: Class) -> Instance:
        """A package as a holder of constants."""
        ...


def first_of(components: Holders, name: str, scope: Scope, node: Reference) -> Any:
    """What the first name of a reference means in a scope, or in one around it: an instance, or a class.

    Raises:
        ModelError: nothing has that name.
    """
    place = None if node.absolute else scope
    while place is not None:
        if place.instance is not None and name in place.components:
            return place.instance.children[name]
        if place.instance is None and place.definition.kind == "package":
            package = components.package(Class(place.definition, place.outer))
            if name in package.children:
                return package.children[name]
        member = components.lookup.member(place, name)
        if member is not None:
            return ClassValue(member)
        constant = _imported_constant(components, place, name, node)
        if constant is not None:
            return constant
        place = place.outer
    top = components.lookup.first(None, name, True)
    if top is not None:
        return ClassValue(top)
    if name in ENUMERATIONS:
        return name
    raise ModelError(f"'{node.text}' not found in {scope.definition.qualified_name}")


def _imported_constant(components: Holders, place: Scope, name: str, node: Reference) -> Any:
    """A constant of a package that a class imports by name, or with all others of its package; None: there is none."""
    for entry in place.definition.imports:
        *holder, last = entry.type.names if entry.alias != "*" else (*entry.type.names, name)
        if name == (entry.alias if entry.alias != "*" else last) and holder:
            package = components.lookup.qualified(".".join(holder))
            if package is not None and package.definition.kind == "package":
                child = components.package(package).children.get(last)
                if child is not None:
                    return child
    return None


def member_of(components: Holders, holder: Any, name: str, node: Reference) -> Any:
    """What a further name of a reference means within what the names before it mean.

    Raises:
        ModelError: there is no member of that name.
        AbsentComponent: the holder is switched off.
    """
    if isinstance(holder, list):
        return [member_of(components, item, name, node) for item in holder]
    if isinstance(holder, Instance):
        instance = components.expand(holder)
        if instance.elements is not None:
            return [member_of(components, element, name, node) for element in instance.elements]
        if not instance.present:
            raise AbsentComponent(f"'{instance.name}' is switched off by its condition")
        if name in instance.children:
            return instance.children[name]
        if name in instance.classes:
            return ClassValue(instance.classes[name])
        what = (
            instance.type.definition.qualified_name
            if instance.type is not None
            else instance.primitive
        )
        raise ModelError(f"'{node.text}': {what or instance.name} has no '{name}'")
    if isinstance(holder, ClassValue):
        return _class_member(components, holder.of, name, node)
    literals = ENUMERATIONS.get(holder, ()) if isinstance(holder, str) else ()
    if name in literals:
        return EnumerationLiteral(name, literals.index(name) + 1)
    raise ModelError(f"'{node.text}': there is no member '{name}'")


def _class_member(components: Holders, of: Class, name: str, node: Reference) -> Any:
    definition = of.definition
    if definition.literals is not None:
        literals = [literal for literal, _ in definition.literals]
        if name in literals:
            return EnumerationLiteral(name, literals.index(name) + 1)
        raise ModelError(f"enumeration {definition.qualified_name} has no '{name}'")
    nested = components.lookup.class_in(of, name)
    if nested is not None:
        return ClassValue(nested)
    bases = components.lookup.bases(of) if definition.alias is not None else []
    if bases and bases[0].definition.literals is not None:
        return _class_member(components, bases[0], name, node)
    package = components.package(of)
    if name in package.classes:
        return ClassValue(package.classes[name])
    if name not in package.children:
        raise ModelError(f"'{node.text}' not found: {definition.qualified_name} has no '{name}'")
    if package.children[name].variability != "constant" and definition.kind == "package":
        raise ModelError(f"'{node.text}' is not a constant")
    return package.children[name]
