"""What may take the place of a replaceable class or component: it has all that its constraint has."""

from __future__ import annotations

from dataclasses import replace

from pam_cosim.compiler.declared_type import DEPTH
from pam_cosim.compiler.instance import NOTHING, Class, Mod, Redeclaration, Scope
from pam_cosim.compiler.lookup import Lookup
from pam_cosim.compiler.syntax import ClassDefinition, ComponentDeclaration


def followed(lookup: Lookup, of: Class) -> Class:
    """The class with a body that a short class stands for."""
    bases = lookup.bases(of) if of.definition.alias is not None else []
    return followed(lookup, bases[0]) if bases else of


def redeclared_class(
    lookup: Lookup,
    original: ClassDefinition,
    entry: Mod,
    redeclaration: Redeclaration,
    scope: Scope,
    under: Mod | None,
) -> Class:
    """The class that stands in the place of a replaceable one.

    Args:
        lookup: of the classes.
        original: the replaceable class.
        entry: the modification that redeclares it, which may modify the new one too.
        redeclaration: of ``entry``.
        scope: of the original one.
        under: what its constraint modifies.

    Raises:
        ModelError: it is not replaceable, or the new one is no class or lacks something of the constraint.
    """
    new, place = redeclaration.declaration, redeclaration.scope
    source = place.definition.source
    if not isinstance(new, ClassDefinition):
        raise source.error(
            f"'{new.name}' is a class: write 'redeclare model {new.name} = ...'", new.at
        )
    if "replaceable" not in original.prefixes:
        raise source.error(f"class '{new.name}' is not replaceable", new.at)
    over = replace(entry, redeclaration=None, value=None) if entry.entries else None
    redeclared = Class(new, place, over, under)
    if original.constraint is not None:
        limit: Class | None = lookup.require(scope, original.constraint.type, original)
    else:
        limit = followed(lookup, Class(original, scope))
    _check_constraint(lookup, redeclared, limit, new.at)
    return redeclared


def check_component_redeclaration(
    lookup: Lookup,
    old: ComponentDeclaration,
    new: ComponentDeclaration | ClassDefinition,
    scope: Scope,
    place: Scope,
) -> None:
    """Whether a new component, written in ``place``, may stand for an old one of ``scope``.

    Raises:
        ModelError: it may not.
    """
    source = place.definition.source
    if not isinstance(new, ComponentDeclaration):
        raise source.error(f"'{new.name}' is a component, not a class", new.at)
    if "replaceable" not in old.prefixes:
        raise source.error(f"component '{new.name}' is not replaceable", new.at)
    limit_name = old.type if old.constraint is None else old.constraint.type
    limit = lookup.find(scope, limit_name.names, limit_name.absolute)
    new_type = lookup.find(place, new.type.names, new.type.absolute)
    if new_type is not None:
        _check_constraint(lookup, Class(new_type.definition, new_type.outer), limit, new.at)


def _check_constraint(lookup: Lookup, new: Class, limit: Class | None, at: int) -> None:
    if limit is None or limit.definition.kind == "function":
        return
    if new.definition.alias is not None and new.outer is not None:
        lookup.require(new.outer, new.definition.alias.type, new.outer.definition)
    wanted = _public_names(lookup, limit)
    offered = set(_public_names(lookup, new))
    missing = [name for name in wanted if name not in offered]
    if missing:
        where = new.outer.definition.source if new.outer is not None else new.definition.source
        target = (
            new.definition.alias.type.text
            if new.definition.alias is not None
            else new.definition.name
        )
        raise where.error(
            f"'{target}' does not fit here: it lacks {', '.join(missing)} of {limit.definition.qualified_name}",
            at,
        )


def _public_names(lookup: Lookup, of: Class, depth: int = 0) -> list[str]:
    """Names of the public components of a class, inherited ones included."""
    if depth > DEPTH:
        return []
    names = [n for n, c in of.definition.components.items() if "protected" not in c.prefixes]
    for base in lookup.bases(of):
        names += [name for name in _public_names(lookup, base, depth + 1) if name not in names]
    return names


def body_redeclarations(scope: Scope) -> Mod:
    """What a class redeclares in its own body, as the modification of its base classes that it is."""
    entries = {}
    source = scope.definition.source
    for new in scope.definition.redeclared:
        entries[new.name] = Mod(new.at, source, redeclaration=Redeclaration(new, scope))
    return Mod(scope.definition.at, source, entries=entries) if entries else NOTHING
