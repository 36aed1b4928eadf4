"""Finding the class that a name means at its place."""

from __future__ import annotations

from collections.abc import Callable

from pam_cosim.compiler import names
from pam_cosim.compiler.budget import LIMITS
from pam_cosim.compiler.instance import Class, Instance, Scope
from pam_cosim.compiler.library import Library
from pam_cosim.compiler.syntax import ClassDefinition, Extends, TypeName
from pam_cosim.errors import ModelError


class Lookup:
    """Finds classes by name, statically or through the redeclarations of an instance."""

    def __init__(self, library: Library) -> None:
        self.library = library
        self.package_of: Callable[[Class], Instance] | None = None  # where packages are instances
        self._static: dict[ClassDefinition, Scope] = {}
        self._static_bases: dict[ClassDefinition, list[Class]] = {}
        self._static_members: dict[tuple[ClassDefinition, str], Class | None] = {}
        self._depth = 0

    def static_scope(self, definition: ClassDefinition) -> Scope:
        """The place of a class that is not part of an instance."""
        scope = self._static.get(definition)
        if scope is None:
            outer = None if definition.parent is None else self.static_scope(definition.parent)
            scope = self._static[definition] = Scope(definition, None, outer)
        return scope

    def qualified(self, name: str) -> Class | None:
        """The class of a full name, also if it is inherited by a package on the way."""
        first, *rest = names.parts(name)
        inserted = self.library.inserted.get(name)
        if inserted is not None:
            return self.of(inserted)
        return self._descend(self._root(first), tuple(rest))

    def of(self, definition: ClassDefinition) -> Class:
        """The class as its definition stands in the library."""
        return Class(
            definition, None if definition.parent is None else self.static_scope(definition.parent)
        )

    def find(
        self, scope: Scope | None, names: tuple[str, ...], absolute: bool = False
    ) -> Class | None:
        """The class that a dotted name means at ``scope``."""
        return self._descend(self.first(scope, names[0], absolute), names[1:])

    def require(self, scope: Scope | None, name: TypeName, holder: ClassDefinition) -> Class:
        """The class that a name in the text of ``holder`` means.

        Raises:
            ModelError: there is no such class.
        """
        required = self.find(scope, name.names, name.absolute)
        if required is None:
            raise self.missing(name, holder)
        return required

    def missing(self, name: TypeName, holder: ClassDefinition, what: str = "class") -> ModelError:
        """The error that a name in the text of ``holder`` means no class, with the classes that it may stand for."""
        text = f"{what} '{name.text}' not found in {holder.qualified_name}{self.library.similar(name.text)}"
        return holder.source.error(text, name.at)

    def first(self, scope: Scope | None, name: str, absolute: bool = False) -> Class | None:
        """The class that a single name means: here, or in an enclosing class, or at the root."""
        place = None if absolute else scope
        while place is not None:
            member = self.member(place, name)
            if member is not None:
                return member
            place = place.outer
        return self._root(name)

    def member(self, scope: Scope, name: str) -> Class | None:
        """A class that is declared in, inherited or imported by the class of ``scope``.

        Raises:
            ModelError: classes inherit from or import one another without end.
        """
        if scope is not self._static.get(scope.definition):
            return self._bounded_member(scope, name)
        key = (
            scope.definition,
            name,
        )  # there nothing can be redeclared: the answer is always the same
        if key not in self._static_members:
            self._static_members[key] = self._bounded_member(scope, name)
        return self._static_members[key]

    def _bounded_member(self, scope: Scope, name: str) -> Class | None:
        definition = scope.definition
        if self._depth >= LIMITS.classes:
            text = f"'{name[:60]}' is looked for without end: {definition.qualified_name} inherits or imports itself"
            raise definition.source.error(text, definition.at)
        self._depth += 1
        try:
            return self._member(scope, name)
        finally:
            self._depth -= 1

    def _member(self, scope: Scope, name: str) -> Class | None:
        if scope.instance is not None and name in scope.classes:
            return scope.instance.classes[name]
        definition = scope.definition
        if name in definition.classes:
            return Class(definition.classes[name], scope)
        if self.library.inserted and (
            inserted := self.library.inserted.get(f"{definition.qualified_name}.{name}")
        ):
            return Class(inserted, scope)
        if scope.instance is None:
            package_class = self._class_of_package(Class(definition, scope.outer), name)
            if package_class is not None:
                return package_class
            for base in self.bases(Class(definition, scope.outer)):
                inherited = self.member(self.inside(base), name)
                if inherited is not None:
                    return inherited
        return self._imported(definition, name)

    def class_in(self, of: Class, name: str) -> Class | None:
        """A class that is declared in, inherited or imported by a class, with what modifies that one."""
        package_class = self._class_of_package(of, name) if of.over is not None else None
        return package_class or self.member(self.inside(of), name)

    def _class_of_package(self, of: Class, name: str) -> Class | None:
        """A class as the package has it, in which constants may have other values than where it is inherited from."""
        definition = of.definition
        inherits = bool(definition.extends) or definition.alias is not None or of.over is not None
        if self.package_of is None or definition.kind != "package" or not inherits:
            return None
        return self.package_of(of).classes.get(name)

    def bases(self, of: Class) -> list[Class]:
        """The classes that a class extends or is short for, as far as they are found; built-in types are not."""
        parent = of.definition.parent
        if of.outer is not (None if parent is None else self.static_scope(parent)):
            return self._bases(of)
        if of.definition not in self._static_bases:
            self._static_bases[of.definition] = self._bases(of)
        return self._static_bases[of.definition]

    def _bases(self, of: Class) -> list[Class]:
        definition = of.definition
        if definition.alias is not None:
            target = definition.alias.type
            return [
                base
                for base in [self.find(of.outer, target.names, target.absolute)]
                if base is not None
            ]
        return [
            base for clause in definition.extends if (base := self.base(of, clause)) is not None
        ]

    def base(self, of: Class, clause: Extends) -> Class | None:
        """The class that one ``extends`` of a class names; its name is not looked up among what is inherited."""
        if clause.inherited:
            return self._inherited(of, clause.type.names[0])
        names, absolute = clause.type.names, clause.type.absolute
        local_class = of.definition.classes.get(names[0]) if not absolute else None
        here = (
            Class(local_class, self.inside(of))
            if local_class is not None
            else self._imported(of.definition, names[0])
        )
        return self._descend(here or self.first(of.outer, names[0], absolute), names[1:])

    def _inherited(self, of: Class, name: str) -> Class | None:
        """The class of a name that the class around ``of`` inherits."""
        if of.outer is None:
            return None
        for base in self.bases(Class(of.outer.definition, of.outer.outer)):
            inherited = self.member(self.inside(base), name)
            if inherited is not None:
                return inherited
        return None

    def inside(self, of: Class) -> Scope:
        """The place inside a class that is not instantiated."""
        definition = of.definition
        parent = definition.parent
        if parent is None and of.outer is None:
            return self.static_scope(definition)
        if parent is not None and of.outer is self.static_scope(parent):
            return self.static_scope(definition)
        return Scope(definition, None, of.outer)

    def _imported(self, definition: ClassDefinition, name: str) -> Class | None:
        for entry in definition.imports:
            if entry.alias == name:
                return self.qualified(entry.type.text)
            if entry.alias == "*":
                package = self.qualified(entry.type.text)
                imported = None if package is None else self.member(self.inside(package), name)
                if imported is not None:
                    return imported
        return None

    def _root(self, name: str) -> Class | None:
        definition = self.library.top.get(name)
        return None if definition is None else Class(definition, None)

    def _descend(self, of: Class | None, names: tuple[str, ...]) -> Class | None:
        for name in names:
            if of is None:
                return None
            of = self.class_in(of, name)
        return of
