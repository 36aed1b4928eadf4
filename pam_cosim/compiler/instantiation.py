"""From a class to the tree of its components: inheritance, modification, redeclaration, conditions, arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TypeAlias

from pam_cosim.compiler.budget import Budget, checked_size
from pam_cosim.compiler.constants import Constants
from pam_cosim.compiler.declared_type import DEPTH, DeclaredType, declared_type
from pam_cosim.compiler.evaluation import Calls
from pam_cosim.compiler.instance import NOTHING, Bound, Class, Instance, Mod, Scope
from pam_cosim.compiler.lookup import Lookup
from pam_cosim.compiler.modification import ATTRIBUTES, bind, merge
from pam_cosim.compiler.names_of_references import AbsentComponent
from pam_cosim.compiler.redeclaration import (
    body_redeclarations,
    check_component_redeclaration,
    followed,
    redeclared_class,
)
from pam_cosim.compiler.source import SourceText
from pam_cosim.compiler.syntax import (
    ClassDefinition,
    ComponentDeclaration,
    Expression,
    Whole,
)
from pam_cosim.errors import ModelError

_INHERITED_PREFIXES = frozenset(
    ("constant", "parameter", "protected", "final", "flow", "input", "output")
)


_Key: TypeAlias = tuple[ClassDefinition, Scope | None, Mod | None, Mod | None]


class Instantiator:
    """Builds instances; one for each compile."""

    def __init__(self, lookup: Lookup, calls: Calls) -> None:
        self.lookup = lookup
        self.calls = calls
        self.budget = Budget()
        self.constants = Constants(self)
        lookup.package_of = self.package
        self._packages: dict[_Key, Instance] = {}
        self._functions: dict[_Key, Instance] = {}

    def is_structural(self, instance: Instance) -> bool:
        """Whether the structure of the model follows from the value of a Real parameter."""
        return instance in self.constants.structural

    # ---- whole classes ------------------------------------------------------------------------------------

    def model(self, of: Class) -> Instance:
        """The instance of a top-level model, all parts expanded."""
        root = Instance("", None, None, None, kind=of.definition.kind, definition=of, expanded=True)
        self.populate(root, of, NOTHING)
        self._expand_children(root)
        return root

    def package(self, of: Class) -> Instance:
        """A package as a holder of constants, which are expanded on demand."""
        key = of.definition, of.outer, of.over, of.under
        if key not in self._packages:
            name = of.definition.qualified_name
            instance = Instance(name, None, None, None, kind="package", expanded=True)
            self._packages[key] = instance  # before it is whole: its bases may be looked up in it
            self.populate(instance, of, NOTHING)
        return self._packages[key]

    def function(self, of: Class) -> Instance:
        """A function as a holder of its inputs, outputs, local variables and statements."""
        key = of.definition, of.outer, of.over, of.under
        if key not in self._functions:
            name = of.definition.qualified_name
            instance = Instance(
                name, None, None, None, kind="function", definition=of, expanded=True
            )
            self.populate(instance, of, NOTHING)
            self._functions[key] = instance
        return self._functions[key]

    def record(self, of: Class, name: str, modification: Mod) -> Instance:
        """The value that a record constructor makes."""
        prefixes = frozenset(("constant",))
        instance = Instance(
            name, None, None, None, modification, prefixes, kind="record", expanded=True
        )
        self.populate(instance, of, modification)
        self._expand_children(instance)
        return instance

    # ---- classes into instances ---------------------------------------------------------------------------

    def populate(self, instance: Instance, of: Class, modification: Mod, depth: int = 0) -> Scope:
        """Add to an instance what a class declares and inherits.

        Raises:
            ModelError: unknown base classes, modifications of what does not exist, endless inheritance.
        """
        definition = of.definition
        if depth > DEPTH:
            raise definition.source.error(
                f"class '{definition.name}' inherits from itself", definition.at
            )
        instance.ancestors.append(of)
        modification = merge(modification, of.over)
        if definition.alias is not None:
            return self._populate_short(instance, of, modification, depth)
        if definition.literals is not None:
            raise definition.source.error(
                f"'{definition.name}' is an enumeration, not a model", definition.at
            )
        modification = merge(modification, of.under)
        scope = Scope(definition, instance, of.outer)
        self._register_classes(instance, scope, modification)
        body = body_redeclarations(scope)
        bases = self.lookup.bases(of)
        if len(bases) < len(definition.extends):
            self._report_missing_base(of)
        for extends, base in zip(definition.extends, bases, strict=True):
            clause_modification = bind(extends.modification, scope, extends.at)
            inner = self.populate(
                instance, base, merge(modification, merge(body, clause_modification)), depth + 1
            )
            scope.components |= inner.components
            scope.classes |= inner.classes
            self._check_names(clause_modification, instance, base.definition.name)
        self._check_names(body, instance, definition.name)
        for declaration in definition.components.values():
            scope.components.add(declaration.name)
            if declaration.name not in instance.children:
                instance.children[declaration.name] = self._child(
                    instance, declaration, scope, modification
                )
        # a class that is inherited twice states its equations once
        present = [section for section, _ in instance.sections]
        instance.sections += [
            (section, scope) for section in definition.sections if section not in present
        ]
        return scope

    def _populate_short(
        self, instance: Instance, of: Class, modification: Mod, depth: int
    ) -> Scope:
        definition = of.definition
        assert definition.alias is not None
        holder = of.outer.definition if of.outer is not None else definition
        base = self.lookup.require(of.outer, definition.alias.type, holder)
        place = of.outer or self.lookup.static_scope(definition)
        alias_modification = bind(definition.alias.modification, place, definition.alias.at)
        scope = self.populate(
            instance, base, merge(modification, merge(alias_modification, of.under)), depth + 1
        )
        self._check_names(alias_modification, instance, base.definition.name)
        return scope

    def _register_classes(self, instance: Instance, scope: Scope, modification: Mod) -> None:
        declared = scope.definition.classes
        for name in declared:
            scope.classes.add(name)
            if declared.is_waiting(name) and name not in modification.entries:
                if name not in instance.classes:
                    instance.classes.later(name, partial(_class_in, scope, name))
                continue
            nested = declared[name]
            under = (
                None if nested.constraint is None else bind(nested.constraint.modification, scope)
            )
            entry = modification.entries.get(name)
            if name in instance.classes:
                continue
            if entry is not None and entry.redeclaration is not None:
                instance.classes[name] = redeclared_class(
                    self.lookup, nested, entry, entry.redeclaration, scope, under
                )
            else:
                instance.classes[name] = Class(nested, scope, entry, under)

    def _report_missing_base(self, of: Class) -> None:
        definition = of.definition
        for extends in definition.extends:
            if extends.type.text == "ExternalObject":
                raise definition.source.error("external objects are not supported", definition.at)
            if self.lookup.base(of, extends) is None:
                raise self.lookup.missing(extends.type, definition, "base class")

    def _check_names(self, modification: Mod, instance: Instance, where: str) -> None:
        for name, entry in modification.entries.items():
            if (
                name not in instance.children
                and name not in instance.classes
                and entry.source is not None
            ):
                raise entry.source.error(
                    f"there is no '{name}' in {where} to be modified", entry.at
                )

    # ---- components ---------------------------------------------------------------------------------------

    def _child(
        self, parent: Instance, declaration: ComponentDeclaration, scope: Scope, outer: Mod
    ) -> Instance:
        entry = outer.entries.get(declaration.name)
        declared_modification = bind(declaration.modification, scope, declaration.at)
        constraint = None
        if declaration.constraint is not None:
            constraint = bind(declaration.constraint.modification, scope)
        original, home = declaration, scope
        if entry is not None and entry.redeclaration is not None:
            new, place = entry.redeclaration.declaration, entry.redeclaration.scope
            check_component_redeclaration(self.lookup, declaration, new, scope, place)
            assert isinstance(new, ComponentDeclaration)
            inherited = constraint if constraint is not None else declared_modification
            entry = merge(replace(entry, redeclaration=None), bind(new.modification, place, new.at))
            declared_modification, scope = inherited, place
            declaration = replace(
                new,
                prefixes=(original.prefixes - {"replaceable"}) | new.prefixes,
                dimensions=new.dimensions or original.dimensions,
                condition=original.condition,
                description=new.description or original.description,
            )
            modification = merge(entry, declared_modification)
        else:
            declared_modification.final = "final" in declaration.prefixes
            modification = merge(merge(entry, declared_modification), constraint)
        prefixes = declaration.prefixes | (parent.prefixes & _INHERITED_PREFIXES)
        if modification.final and modification.value is not None:
            prefixes |= {"final"}
        name = f"{parent.name}.{declaration.name}" if parent.name else declaration.name
        return Instance(name, parent, scope, declaration, modification, prefixes, home=home)

    def expand(self, instance: Instance) -> Instance:
        """Fill in what an instance consists of, if that has not been done; returns what it stands for."""
        if not instance.expanded:
            instance.expanded = True
            self._bounded_expand(instance)
        return instance.resolved()

    def _bounded_expand(self, instance: Instance) -> None:
        try:
            self.budget.enter("components stand")
            self.budget.instance()
            self._expand(instance)
        except ModelError as error:
            if (
                error.file is not None
                or isinstance(error, AbsentComponent)
                or instance.declaration is None
            ):
                raise
            message = f"component '{instance.name[:100]}': {error.message}"
            raise instance_source(instance).error(message, instance.declaration.at) from None
        finally:
            self.budget.depth -= 1

    def _expand(self, instance: Instance) -> None:
        declaration, scope = instance.declaration, instance.scope
        assert declaration is not None and scope is not None
        if declaration.condition is not None:
            instance.present = self.constants.condition(
                declaration.condition, instance.home or scope
            )
            if not instance.present:
                return
        if "outer" in instance.prefixes and "inner" not in instance.prefixes:
            assert instance.parent is not None
            if instance.parent.parent is not None:
                instance.target = self._find_inner(instance)
                return
            instance.prefixes |= {"inner"}  # the model itself is the top, where one is added
        type_ = declared_type(self.lookup, declaration.type, scope, instance.modification)
        instance.prefixes |= type_.prefixes
        home = instance.home or scope
        written = tuple((size, home) for size in declaration.dimensions)
        dimensions = written + type_.dimensions
        if dimensions:
            sizes = [
                self._size(size, place, instance, i) for i, (size, place) in enumerate(dimensions)
            ]
            self._expand_array(instance, sizes, ())
        else:
            self._expand_scalar(instance, type_)

    def _expand_array(
        self, instance: Instance, sizes: Sequence[int], index: tuple[int, ...]
    ) -> None:
        instance.elements = []
        checked_size(sizes[0])
        base = instance.name.rpartition("[")[0] if index else instance.name
        declaration, scope = instance.declaration, instance.scope
        assert declaration is not None and scope is not None
        for number in range(1, sizes[0] + 1):
            place = (*index, number)
            name = f"{base}[{','.join(map(str, place))}]"
            modification = instance.modification.element(number - 1)
            prefixes = instance.prefixes
            self.budget.instance()
            element = Instance(
                name, instance.parent, scope, declaration, modification, prefixes, expanded=True
            )
            if len(sizes) > 1:
                self._expand_array(element, sizes[1:], place)
            else:
                element.modification = modification.of_one()
                type_ = declared_type(self.lookup, declaration.type, scope, element.modification)
                self._expand_scalar(element, type_)
            instance.elements.append(element)

    def _expand_scalar(self, instance: Instance, type_: DeclaredType) -> None:
        modification = type_.modification
        instance.type = type_.type
        if type_.primitive:
            instance.primitive, instance.kind = type_.primitive, "type"
            instance.binding = modification.value
            for name, entry in modification.entries.items():
                if name not in ATTRIBUTES:
                    source = entry.source or instance_source(instance)
                    raise source.error(f"{type_.primitive} has no attribute '{name}'", entry.at)
                if entry.value is not None:
                    instance.attributes[name] = entry.value
            return
        assert type_.type is not None
        definition = type_.type.definition
        instance.kind = definition.kind
        if definition.partial and definition.kind in ("model", "block", "class"):
            declaration = instance.declaration
            assert declaration is not None
            raise instance_source(instance).error(
                f"'{instance.name}' has the partial class {definition.qualified_name}: redeclare it",
                declaration.at,
            )
        self.populate(instance, type_.type, modification)
        self._check_names(modification, instance, definition.qualified_name)
        if modification.value is not None:
            self._take_apart(instance, modification.value)
        self._expand_children(instance)

    def _take_apart(self, instance: Instance, value: Bound) -> None:
        """Give each member of a record its part of the record's binding."""
        if instance.kind != "record":
            raise value.source.error(
                f"'{instance.name}' is no variable: it cannot have a value", value.expression.at
            )
        for name, child in instance.children.items():
            if child.modification.value is None or not self._from_outside(instance, name):
                child.modification = replace(
                    child.modification, value=value.member(name), each=False
                )

    def _from_outside(self, instance: Instance, name: str) -> bool:
        entry = instance.modification.entries.get(name)
        return entry is not None and entry.value is not None

    def _expand_children(self, instance: Instance) -> None:
        for child in list(instance.children.values()):
            self.expand(child)

    def _find_inner(self, instance: Instance) -> Instance:
        assert instance.parent is not None and instance.parent.parent is not None
        holder, name = instance.parent.parent, instance.local_name
        while True:
            candidate = holder.children.get(name)
            is_top = holder.parent is None
            if candidate is not None and (
                "inner" in candidate.prefixes or is_top and "outer" in candidate.prefixes
            ):
                return self.expand(candidate)
            if holder.parent is None:
                return self._added_inner(instance, holder)
            holder = holder.parent

    def _added_inner(self, outer: Instance, top: Instance) -> Instance:
        """What nothing declares ``inner`` is added to the top of the model with its default values, MLS 5.4."""
        declaration, scope, name = outer.declaration, outer.scope, outer.local_name
        assert declaration is not None and scope is not None
        of = self.lookup.find(scope, declaration.type.names, declaration.type.absolute)
        definition = None if of is None else followed(self.lookup, of).definition
        if (
            definition is None
            or definition.partial
            or definition.kind not in ("model", "block", "class")
        ):
            raise instance_source(outer).error(
                f"'outer {declaration.type.text} {name}' finds no 'inner {declaration.type.text} {name}' above it",
                declaration.at,
            )
        if name in top.children:
            raise instance_source(outer).error(
                f"'outer {declaration.type.text} {name}' finds a '{name}' above it that is not inner: "
                f"declare it 'inner {declaration.type.text} {name}'",
                declaration.at,
            )
        top.children[name] = Instance(
            name, top, scope, declaration, NOTHING, frozenset({"inner"}), home=scope
        )
        return self.expand(top.children[name])

    def _size(self, size: Expression, place: Scope, instance: Instance, dimension: int) -> int:
        if not isinstance(size, Whole):
            return self.constants.integer(size, place)
        value = instance.modification.value
        if value is None:
            raise instance_source(instance).error(
                f"'{instance.name}' has an unknown size and no value to take it from", size.at
            )
        array = self.constants.bound(value)
        for _ in range(dimension):
            array = array[0] if isinstance(array, list) and array else array
        if not isinstance(array, list):
            raise value.source.error(
                f"'{instance.name}' needs an array as its value", value.expression.at
            )
        return len(array)


def _class_in(scope: Scope, name: str) -> Class:
    nested = scope.definition.classes[name]
    under = None if nested.constraint is None else bind(nested.constraint.modification, scope)
    return Class(nested, scope, None, under)


def instance_source(instance: Instance) -> SourceText:
    """The text that declares an instance."""
    if instance.scope is None:
        raise ModelError(f"'{instance.name}' has no declaration")
    return instance.scope.definition.source
