"""A declared type, followed through its short definitions."""

from __future__ import annotations

from dataclasses import dataclass

from pam_cosim.compiler.instance import NOTHING, Class, Mod, Scope
from pam_cosim.compiler.lookup import Lookup
from pam_cosim.compiler.modification import bind, merge
from pam_cosim.compiler.names_of_references import ENUMERATIONS
from pam_cosim.compiler.syntax import Expression, TypeName

PRIMITIVES = frozenset(("Real", "Integer", "Boolean", "String"))
DEPTH = 40  # of short definitions, and of base classes, one upon the other


@dataclass(eq=False, repr=False)
class DeclaredType:
    """A type followed through its short definitions to a built-in type or a class with a body."""

    primitive: str
    type: Class | None
    modification: Mod
    prefixes: frozenset[str] = frozenset()
    dimensions: tuple[tuple[Expression, Scope], ...] = ()


def declared_type(lookup: Lookup, name: TypeName, scope: Scope, modification: Mod) -> DeclaredType:
    """What a type's name stands for in a scope, with the modification of the declaration.

    Raises:
        ModelError: nothing has that name.
    """
    of = lookup.find(scope, name.names, name.absolute)
    if of is None:
        if name.text in PRIMITIVES:
            return DeclaredType(name.text, None, modification)
        if name.text in ENUMERATIONS:
            return DeclaredType("enumeration", None, modification)
        raise lookup.missing(name, scope.definition)
    return _follow(lookup, of, modification, 0)


def _follow(lookup: Lookup, of: Class, modification: Mod, depth: int) -> DeclaredType:
    definition = of.definition
    if definition.literals is not None:
        return DeclaredType("enumeration", of, merge(modification, of.over))
    alias = definition.alias
    if alias is None or depth > DEPTH:
        return DeclaredType("", of, modification)
    names = alias.type.names
    base = lookup.find(of.outer, names, alias.type.absolute)
    place = of.outer or lookup.static_scope(definition)
    if base is None and alias.type.text not in PRIMITIVES:
        raise lookup.missing(alias.type, definition)
    alias_modification = merge(merge(of.over, bind(alias.modification, place, alias.at)), of.under)
    if base is None:
        followed = DeclaredType(alias.type.text, of, merge(modification, alias_modification))
    else:
        followed = _follow(lookup, base, NOTHING, depth + 1)
        if not followed.primitive:
            # a class with a body: populate() walks the aliases again, with their modifications
            followed = DeclaredType("", of, modification, followed.prefixes, followed.dimensions)
        else:
            followed.modification = merge(
                merge(modification, alias_modification), followed.modification
            )
    followed.prefixes |= definition.alias_prefixes
    followed.dimensions = (
        tuple((size, place) for size in definition.alias_dimensions) + followed.dimensions
    )
    return followed
