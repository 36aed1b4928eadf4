"""The class tree of the library and the user's files, read without instantiating anything."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache, partial
from pathlib import Path
from typing import TypeAlias

from pam_cosim.compiler import names
from pam_cosim.compiler.budget import bounded
from pam_cosim.compiler.class_info import BaseInfo, ClassInfo, ComponentInfo, ReplaceableInfo
from pam_cosim.compiler.declared_type import PRIMITIVES
from pam_cosim.compiler.instance import Class
from pam_cosim.compiler.lazy import LazyDict
from pam_cosim.compiler.library import Library, Signature, files_of, signature, signature_of
from pam_cosim.compiler.lookup import Lookup
from pam_cosim.compiler.printing import argument_text, expression_text, modification_text
from pam_cosim.compiler.syntax import (
    Argument,
    Array,
    Binary,
    ClassDefinition,
    ComponentDeclaration,
    Constraint,
    Expression,
    Extends,
    Literal,
    Modification,
    TypeName,
    Unary,
)
from pam_cosim.errors import ModelError
from pam_cosim.resources import modelica_root

VENDOR = "__PamCosim"
"""The vendor annotation of a class (Modelica 3.6, section 18.1)."""

_GRAPHICAL = frozenset(("Icon", "Diagram"))
Constant: TypeAlias = "float | int | str | bool | tuple[Constant, ...]"


class ClassTree:
    """All classes by full name, parents before their children, in order of files."""

    def __init__(self, library: Library) -> None:
        self._library = library
        self._lookup = Lookup(library)
        self._definitions = {node.qualified_name: node for node in library.walk()}
        self.classes: LazyDict[ClassInfo] = LazyDict()  # all are seldom needed
        for name, node in self._definitions.items():
            self.classes.later(name, partial(self._info, node))

    # ---- questions ----------------------------------------------------------------------------------------

    def resolve(self, scope: str, name: str) -> str | None:
        """The full name of the class that ``name`` means in the text of class ``scope`` (empty: the root)."""
        absolute = name.startswith(".")
        place = self._lookup.static_scope(self._definitions[scope]) if scope else None
        resolved = self._lookup.find(place, tuple(names.parts(name.lstrip("."))), absolute)
        return None if resolved is None else resolved.definition.qualified_name

    def bases(self, name: str) -> list[str]:
        """Full names of all classes that a class inherits from, nearest first; a class only once."""
        inherited: dict[str, None] = {}
        waiting = [self._class(name)]
        while waiting:
            of = waiting.pop(0)
            for base in self._lookup.bases(of):
                if base.definition.qualified_name not in inherited:
                    inherited[base.definition.qualified_name] = None
                    waiting.append(base)
        return list(inherited)

    def is_subtype(self, name: str, base: str) -> bool:
        """Whether a class is ``base`` or inherits from it."""
        return name == base or base in self.bases(name)

    def subtypes(self, base: str) -> list[str]:
        """All classes of packages that inherit from ``base``, partial ones included, local ones of models not."""
        of_packages = [name for name, node in self._definitions.items() if _is_of_package(node)]
        return [name for name in of_packages if name != base and base in self.bases(name)]

    def models_in(self, file: Path) -> list[str]:
        """Full names of the classes of a file that can be models, in its order; none inside another model."""
        kinds = ("model", "block", "class")
        nodes = [n for n in self._definitions.values() if str(n.source.file) == str(file)]
        return [
            node.qualified_name
            for node in nodes
            if node.kind in kinds and (node.parent is None or node.parent.kind not in kinds)
        ]

    def components(self, name: str) -> list[ComponentInfo]:
        """Components with inherited ones, redeclared as they are, in the order in which the compiler has them."""
        components: dict[str, ComponentInfo] = {}
        for part in reversed([name, *self._in_order(name)]):
            for component in self.classes[part].components:
                components.setdefault(component.name, component)
            components |= self._redeclared(part, components)
        return list(components.values())

    def replaceables(self, name: str) -> list[ReplaceableInfo]:
        """Replaceable classes with inherited ones."""
        replaceables: dict[str, ReplaceableInfo] = {}
        for part in reversed([name, *self._in_order(name)]):
            for replaceable in self.classes[part].replaceables:
                replaceables.setdefault(replaceable.name, replaceable)
        return list(replaceables.values())

    def constant(self, name: str, constant: str) -> Constant | None:
        """The literal value of a constant (or parameter) of a class, modifications of ``extends`` included.

        An array in braces is a tuple. None if it has no value, or one that is no literal.
        """
        return self._constant(self._class(name), constant)

    # ---- reading ------------------------------------------------------------------------------------------

    def _class(self, name: str) -> Class:
        if name not in self._definitions:
            raise ModelError(f"there is no class '{name}'")
        return self._lookup.of(self._definitions[name])

    def _redeclared(
        self, name: str, inherited: Mapping[str, ComponentInfo]
    ) -> dict[str, ComponentInfo]:
        """Components that a class inherits and redeclares, in ``extends`` or in its body."""
        node = self._definitions[name]
        arguments = [a for clause in node.extends for a in clause.modification.arguments]
        redeclarations = [*(a.redeclaration for a in arguments), *node.redeclared]
        new = [
            c for c in redeclarations if isinstance(c, ComponentDeclaration) and c.name in inherited
        ]
        return {c.name: self._in_place_of(inherited[c.name], self._component(node, c)) for c in new}

    @staticmethod
    def _in_place_of(old: ComponentInfo, new: ComponentInfo) -> ComponentInfo:
        """A redeclared component: whatever it does not modify remains (Modelica 3.6, section 7.3)."""
        return replace(
            new,
            prefixes=new.prefixes - {"redeclare"} | old.prefixes - {"replaceable"},
            description=new.description or old.description,
            position=new.position or old.position,
        )

    def _in_order(self, name: str) -> list[str]:
        """All bases such that, read backwards, a base comes before what extends it."""
        ordered: list[str] = []
        for base in reversed(self._lookup.bases(self._class(name))):
            base_name = base.definition.qualified_name
            ordered += (
                [base_name, *self._in_order(base_name)] if base_name in self._definitions else []
            )
        return ordered

    def _constant(self, of: Class, constant: str) -> Constant | None:
        definition = of.definition
        component = definition.components.get(constant)
        if component is not None:
            return _literal(component.modification.value)
        extends = [definition.alias] if definition.alias is not None else definition.extends
        for clause, base in zip(extends, self._lookup.bases(of), strict=False):
            argument = clause.modification.argument(constant)
            value = _literal(argument.modification.value) if argument is not None else None
            value = self._constant(base, constant) if value is None else value
            if value is not None:
                return value
        return None

    def _info(self, node: ClassDefinition) -> ClassInfo:
        line, _ = node.source.position(node.at)
        extends = [node.alias] if node.alias is not None else node.extends
        replaceable = [c for c in node.classes.values() if "replaceable" in c.prefixes]
        annotations = [a for a in node.annotation.arguments if a.name not in _GRAPHICAL]
        return ClassInfo(
            name=node.qualified_name,
            kind=node.kind,
            partial=node.partial,
            description=node.description,
            extends=tuple(self._base(node, clause) for clause in extends),
            components=tuple(
                self._component(node, component) for component in node.components.values()
            ),
            replaceables=tuple(self._replaceable(node, nested) for nested in replaceable),
            prefixes=node.alias_prefixes,
            annotations={annotation.name: argument_text(annotation) for annotation in annotations},
            documentation=_documentation(node),
            file=node.source.file,
            line=line,
        )

    def _base(self, node: ClassDefinition, clause: Extends) -> BaseInfo:
        place = node if node.alias is None else node.parent
        name = self._resolved(place, clause.type)
        return BaseInfo(
            name, _modifications(clause.modification), modification_text(clause.modification)
        )

    def _component(self, node: ClassDefinition, component: ComponentDeclaration) -> ComponentInfo:
        line, _ = node.source.position(component.at)
        value = component.modification.value
        type_ = self._resolved(node, component.type)
        return ComponentInfo(
            name=component.name,
            type=type_,
            prefixes=component.prefixes | self._alias_prefixes(type_),
            modifications=_modifications(component.modification),
            value="" if value is None else expression_text(value),
            text=modification_text(component.modification),
            dimensions=tuple(map(expression_text, component.dimensions)),
            condition="" if component.condition is None else expression_text(component.condition),
            description=component.description,
            constraint=self._constraint(node, component.constraint, type_)
            if "replaceable" in component.prefixes
            else "",
            owner=node.qualified_name,
            line=line,
            position=_position(component.annotation),
            own_annotation=_own_annotation(component.annotation),
        )

    def _alias_prefixes(self, type_: str) -> frozenset[str]:
        """Prefixes that the short classes behind a type add to its variables (Modelica 3.6, section 4.5.1)."""
        node = self._definitions.get(type_)
        if node is None or node.alias is None:
            return frozenset()
        return node.alias_prefixes | self._alias_prefixes(
            self._resolved(node.parent, node.alias.type)
        )

    def _replaceable(self, node: ClassDefinition, nested: ClassDefinition) -> ReplaceableInfo:
        default = nested.qualified_name
        if nested.alias is not None:
            default = self._resolved(node, nested.alias.type)
        constraint = self._constraint(node, nested.constraint, default)
        return ReplaceableInfo(
            nested.name, nested.kind, default, constraint, nested.description, node.qualified_name
        )

    def _constraint(
        self, node: ClassDefinition, constraint: Constraint | None, default: str
    ) -> str:
        return default if constraint is None else self._resolved(node, constraint.type)

    def _resolved(self, place: ClassDefinition | None, name: TypeName) -> str:
        scope = self._lookup.static_scope(place) if place is not None else None
        resolved = self._lookup.find(scope, name.names, name.absolute)
        if resolved is not None:
            return resolved.definition.qualified_name
        return name.text if name.text not in PRIMITIVES else name.names[-1]


def _is_of_package(node: ClassDefinition) -> bool:
    return node.parent is None or node.parent.kind == "package"


def _documentation(node: ClassDefinition) -> str:
    """The text of ``Documentation(info=...)``; empty where there is none."""
    documentation = node.annotation.argument("Documentation")
    info = documentation.modification.argument("info") if documentation is not None else None
    value = info.modification.value if info is not None else None
    if isinstance(value, Literal) and isinstance(value.value, str):
        return value.value
    return ""


def _literal(value: Expression | None) -> Constant | None:
    """The value of a literal, of texts joined with ``+``, or of an array of them."""
    if isinstance(value, Literal):
        return value.value
    if isinstance(value, Binary) and value.operator == "+":
        first, second = _literal(value.left), _literal(value.right)
        return first + second if isinstance(first, str) and isinstance(second, str) else None
    if not isinstance(value, Array) or value.iterators:
        return None
    items = [_literal(item) for item in value.items]
    return None if None in items else tuple(item for item in items if item is not None)


def _position(annotation: Modification) -> tuple[float, float] | None:
    """The middle of ``Placement(transformation(origin, extent))`` (Modelica 3.6, section 18.6.4)."""
    placement = annotation.argument("Placement")
    transformation = (
        None if placement is None else placement.modification.argument("transformation")
    )
    if transformation is None:
        return None
    extent, origin = (transformation.modification.argument(name) for name in ("extent", "origin"))
    corners = _numbers(None if extent is None else extent.modification.value)
    offset = _numbers(None if origin is None else origin.modification.value) or [0.0, 0.0]
    if len(corners) != 4 or len(offset) != 2:
        return None
    return (corners[0] + corners[2]) / 2 + offset[0], (corners[1] + corners[3]) / 2 + offset[1]


def _own_annotation(annotation: Modification) -> dict[str, str | tuple[float, ...]]:
    """The text or the numbers of each entry of the annotation ``VENDOR``."""
    vendor = annotation.argument(VENDOR)
    entries = () if vendor is None else vendor.modification.arguments
    values = {entry.name: entry.modification.value for entry in entries}
    texts = {name: _literal(value) for name, value in values.items()}
    return {
        name: text if isinstance(text, str) else tuple(_numbers(values[name]))
        for name, text in texts.items()
    }


def _numbers(value: Expression | None) -> list[float]:
    """The numbers in an array of arrays, in their order."""
    if isinstance(value, Array):
        return [number for item in value.items for number in _numbers(item)]
    if isinstance(value, Unary) and isinstance(value.operand, Literal) and value.operator == "-":
        return [-number for number in _numbers(value.operand)]
    if isinstance(value, Literal) and isinstance(value.value, int | float):
        return [float(value.value)]
    return []


def _modifications(modification: Modification, prefix: str = "") -> dict[str, str]:
    texts: dict[str, str] = {}
    for argument in modification.arguments:
        name = prefix + argument.name
        texts |= _entries(argument, name)
    return texts


def _entries(argument: Argument, name: str) -> dict[str, str]:
    if argument.redeclaration is not None:
        return {name: argument_text(argument)}
    texts = _modifications(argument.modification, f"{name}.")
    if argument.modification.value is not None:
        texts[name] = expression_text(argument.modification.value)
    return texts


def read_library(root: Path | None = None, files: Sequence[Path] = ()) -> ClassTree:
    """The class tree of the library directory ``root`` (by default the project's own) and of the user's files.

    Where no file has changed it is the same tree: what was found out about its classes is known already.

    Raises:
        ModelError: a syntax error, or a class of the user's that extends what does not exist, with its place.
    """
    base, named = modelica_root() if root is None else root, tuple(Path(file) for file in files)
    try:
        user_files = [part for file in named for part in files_of(file.absolute())]
        return _tree(base, named, (*signature_of(base), *signature(user_files)))
    except OSError:
        return _read(base, named)


@lru_cache(maxsize=8)
def _tree(root: Path, files: tuple[Path, ...], of: Signature) -> ClassTree:
    return _read(root, files)


@bounded
def _read(root: Path, files: tuple[Path, ...]) -> ClassTree:
    library = Library(root, files)
    lookup = Lookup(library)
    for definition in (node for classes in library.user_classes.values() for node in classes):
        for clause in definition.extends:
            if lookup.base(lookup.of(definition), clause) is None:
                raise lookup.missing(clause.type, definition, "base class")
    return ClassTree(library)
