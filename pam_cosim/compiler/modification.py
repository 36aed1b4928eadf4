"""How a modification is bound to the place where it is written, and how outer ones override inner ones."""

from __future__ import annotations

from pam_cosim.compiler.instance import NOTHING, Bound, Mod, Redeclaration, Scope
from pam_cosim.compiler.syntax import Modification

ATTRIBUTES = frozenset(
    "quantity unit displayUnit min max start fixed nominal stateSelect unbounded".split()  # noqa: SIM905
)


def bind(modification: Modification, scope: Scope, at: int = 0) -> Mod:
    """A modification as written in the class of ``scope``.

    Raises:
        ModelError: an element is modified twice.
    """
    source = scope.definition.source
    value = None if modification.value is None else Bound(modification.value, scope)
    entries: dict[str, Mod] = {}
    for argument in modification.arguments:
        entry = bind(argument.modification, scope, argument.at)
        entry.each, entry.final = argument.each, argument.final
        if argument.redeclaration is not None:
            entry.redeclaration = Redeclaration(argument.redeclaration, scope)
        present = entries.get(argument.name)
        if present is not None:
            if _collide(present, entry):
                raise source.error(f"'{argument.name}' is modified twice", argument.at)
            entry = merge(entry, present)
        entries[argument.name] = entry
    return Mod(at, source, value, entries)


def _collide(first: Mod, second: Mod) -> bool:
    if first.value is not None and second.value is not None:
        return True
    shared = first.entries.keys() & second.entries.keys()
    return (
        first.redeclaration is not None
        and second.redeclaration is not None
        or any(_collide(first.entries[name], second.entries[name]) for name in sorted(shared))
    )


def merge(outer: Mod | None, inner: Mod | None) -> Mod:
    """Both together; where both modify the same element, the outer one counts.

    Raises:
        ModelError: the outer one changes what the inner one declares ``final``.
    """
    if outer is None or inner is None:
        return outer or inner or NOTHING
    _refuse_change_of_final(outer, inner)
    return Mod(
        outer.at if outer.source is not None else inner.at,
        outer.source or inner.source,
        outer.value or inner.value,
        _merged_entries(outer, inner),
        outer.redeclaration or inner.redeclaration,
        outer.each if outer.value is not None else inner.each,
        outer.final or inner.final,
    )


def _refuse_change_of_final(outer: Mod, inner: Mod) -> None:
    is_change = outer.value is not None or outer.redeclaration is not None
    if inner.final and is_change and outer.source is not None:
        raise outer.source.error("this element is declared final: it cannot be modified", outer.at)


def _merged_entries(outer: Mod, inner: Mod) -> dict[str, Mod]:
    entries = dict(inner.entries)
    if outer.value is not None:
        # a new value for a whole record replaces the modifications of its members
        entries = {name: entry for name, entry in entries.items() if name in ATTRIBUTES}
    for name, entry in outer.entries.items():
        entries[name] = merge(entry, entries.get(name))
    return entries
