"""Modelica text to a syntax tree: recursive descent over the grammar of Modelica 3.6, appendix A.2."""

from __future__ import annotations

from pam_cosim.compiler.budget import LIMITS, bounded
from pam_cosim.compiler.equation_parser import EquationParser
from pam_cosim.compiler.lexer import is_flat, tokenise
from pam_cosim.compiler.source import SourceText
from pam_cosim.compiler.syntax import (
    EMPTY,
    Argument,
    ClassDefinition,
    ComponentDeclaration,
    Constraint,
    Expression,
    Extends,
    Import,
    Modification,
    Reference,
    Section,
    TypeName,
)
from pam_cosim.errors import ModelError

_CLASS_KINDS = frozenset(
    ("class", "model", "block", "connector", "record", "type", "package", "function", "operator")
)
_CLASS_PREFIXES = frozenset(("partial", "encapsulated", "expandable", "pure", "impure", "final"))
_ELEMENT_PREFIXES = frozenset(("redeclare", "final", "inner", "outer", "replaceable"))
_COMPONENT_PREFIXES = frozenset(
    ("flow", "stream", "discrete", "parameter", "constant", "input", "output")
)
_SECTION_STARTS = frozenset(("equation", "algorithm", "public", "protected", "external"))
_BLOCK_ENDS = frozenset(("if", "for", "when", "while"))


@bounded
def parse_source(source: SourceText) -> tuple[tuple[str, ...], list[ClassDefinition]]:
    """The classes of a stored definition and the package named by ``within``.

    Raises:
        ModelError: a syntax error, with line and column.
    """
    if len(source.text) > LIMITS.file:
        raise ModelError(f"the file has more than {LIMITS.file} letters", source.file)
    return Parser(source, tokenise(source)).stored_definition()


class Parser(EquationParser):
    """The declaration part of the grammar."""

    def stored_definition(self) -> tuple[tuple[str, ...], list[ClassDefinition]]:
        """``within P; class ... end; ...``."""
        within: tuple[str, ...] = ()
        if self.accept("within"):
            if self.kind == "name":
                within = self.type_name().names
            self.expect(";")
        classes: dict[str, ClassDefinition] = {}
        while self.kind != "end of file":
            node = self.class_definition(None, self.class_prefixes())
            if node.name in classes:
                raise self.source.error(f"'{node.name}' is declared twice", node.at)
            classes[node.name] = node
            self.expect(";")
        definitions = list(classes.values())
        if is_flat(self.source) and definitions:  # its package is no part of the names in it
            definitions[:1] = definitions[0].classes.values()
            for node in definitions:
                node.parent = None
        return within, definitions

    def class_prefixes(self) -> frozenset[str]:
        """Words before the kind of a class."""
        words = []
        while self.kind in _CLASS_PREFIXES:
            words.append(self.advance())
        return frozenset(words)

    # ---- classes ------------------------------------------------------------------------------------------

    def class_definition(
        self, parent: ClassDefinition | None, prefixes: frozenset[str]
    ) -> ClassDefinition:
        """A long or short class, from its kind on."""
        if self.kind not in _CLASS_KINDS:
            self.fail(f"expected a class definition, found '{self.text}'")
        kind = self.advance()
        self.deeper()
        if kind == "operator" and self.kind in ("function", "record"):
            kind = self.advance()
        inherits = self.accept("extends")
        at = self.offset
        name = self.expect("name")
        node = ClassDefinition(name, kind, at, self.source, parent, prefixes)
        if inherits:
            base = Extends(at, TypeName(at, (name,)), self.class_modification(), inherited=True)
            node.extends.append(base)
        if not inherits and self.accept("="):
            self.short_class(node)
        else:
            node.description = self.string_comment()
            self.composition(node)
            self.end_of_class(node)
        self.depth -= 1
        return node

    def end_of_class(self, node: ClassDefinition) -> None:
        """``end Name``."""
        self.expect("end")
        if self.text != node.name:
            self.fail(f"expected 'end {node.name}', found 'end {self.text}'")
        self.advance()

    def short_class(self, node: ClassDefinition) -> None:
        """``= Base(modification)`` or ``= enumeration(...)``."""
        if self.kind == "enumeration":
            self.advance()
            self.expect("(")
            literals = []
            self.accept(":")
            while self.kind == "name":
                literals.append((self.advance(), self.string_comment()))
                self.annotation_clause()
                if not self.accept(","):
                    break
            self.expect(")")
            node.literals = tuple(literals)
        elif self.kind == "der":
            self.advance()
            self.call(Reference(self.offset, (("der", ()),)))
            node.external = True
        else:
            words = []
            while self.kind in ("input", "output", "flow", "stream"):
                words.append(self.advance())
            node.alias_prefixes = frozenset(words)
            at = self.offset
            base = self.type_name()
            node.alias_dimensions = self.subscripts()
            node.alias = Extends(at, base, self.class_modification())
        if self.accept("constrainedby"):
            node.constraint = self.constraint()
        node.description = self.string_comment()
        node.annotation = self.annotation_clause()

    def composition(self, node: ClassDefinition) -> None:
        """Elements, sections and the annotation, up to ``end``."""
        visibility = "public"
        while True:
            if self.kind in ("public", "protected"):
                visibility = self.advance()
            elif self.kind == "end":
                return
            elif self.kind in ("equation", "algorithm") or (
                self.kind == "initial" and self.peek() in ("equation", "algorithm")
            ):
                self.defer_section(node)
            elif self.kind == "external":
                node.external = True
                while self.kind not in (";", "end of file"):
                    self.advance()
                self.expect(";")
            elif self.kind == "annotation":
                node.annotation = self.annotation_clause()
                self.expect(";")
            else:
                self.element(node, visibility)
                self.expect(";")

    def defer_section(self, node: ClassDefinition) -> None:
        """Skips a section, which is parsed when its equations are first used."""
        initial = self.accept("initial")
        kind = self.advance()
        start = self.index
        previous = ";"
        while True:
            token = self.kind
            if token == "end of file":
                self.fail(f"'end {node.name}' is missing")
            if token == "end" and self.peek() == "name" or token in _SECTION_STARTS:
                break
            if token == "annotation" and previous == ";":
                break
            if token == "initial" and self.peek() in ("equation", "algorithm"):
                break
            if token == "end" and self.peek() in _BLOCK_ENDS:
                self.index += 1
            previous = self.kind
            self.index += 1
        stop = self.index
        source, tokens = self.source, self.tokens

        def parse() -> Section:
            return Section(kind, initial, Parser(source, tokens, start).equations(kind, stop))

        node.deferred.append(parse)

    # ---- elements -----------------------------------------------------------------------------------------

    def element(self, node: ClassDefinition, visibility: str) -> None:
        """An import, extends, class or component clause."""
        if self.accept("import"):
            node.imports += self.import_clause()
            return
        if self.kind == "extends":
            at = self.offset
            self.advance()
            node.extends.append(Extends(at, self.type_name(), self.class_modification()))
            self.annotation_clause()
            return
        prefixes = {visibility} if visibility == "protected" else set()
        while self.kind in _ELEMENT_PREFIXES:
            prefixes.add(self.advance())
        if self.kind in _CLASS_KINDS or self.kind in _CLASS_PREFIXES:
            self.nested_class(node, frozenset(prefixes))
        else:
            for component in self.component_clause(frozenset(prefixes)):
                if component.name in node.components or component.name in node.classes:
                    raise self.source.error(f"'{component.name}' is declared twice", component.at)
                if "redeclare" in component.prefixes:
                    node.redeclared.append(component)
                else:
                    node.components[component.name] = component

    def nested_class(self, node: ClassDefinition, prefixes: frozenset[str]) -> None:
        """A class inside a class."""
        nested = self.class_definition(node, prefixes | self.class_prefixes())
        self.trailing_constraint(nested)
        if nested.name in node.classes or nested.name in node.components:
            raise self.source.error(f"'{nested.name}' is declared twice", nested.at)
        if "redeclare" in prefixes:
            node.redeclared.append(nested)
        else:
            node.classes[nested.name] = nested

    def trailing_constraint(self, nested: ClassDefinition) -> None:
        """``constrainedby`` after the class, where the grammar has it for replaceable elements."""
        if self.accept("constrainedby"):
            nested.constraint = self.constraint()
            nested.description = self.string_comment() or nested.description
            annotation = self.annotation_clause()
            nested.annotation = annotation if annotation.arguments else nested.annotation

    def constraint(self) -> Constraint:
        """What follows ``constrainedby``."""
        return Constraint(self.type_name(), self.class_modification())

    def import_clause(self) -> list[Import]:
        """What follows ``import``: ``C = A.B``, ``A.B``, ``A.*`` or ``A.{B, C}``."""
        if self.kind == "name" and self.peek() == "=":
            alias = self.advance()
            self.advance()
            clauses = [Import(alias, self.type_name())]
        else:
            at = self.offset
            self.accept(".")
            names, aliases = [self.expect("name")], list[str]()
            while not aliases and self.kind in (".", ".*"):
                if self.advance() == ".*":
                    aliases = ["*"]
                elif self.accept("{"):
                    aliases.append(self.expect("name"))
                    while self.accept(","):
                        aliases.append(self.expect("name"))
                    self.expect("}")
                else:
                    names.append(self.expect("name"))
            full = [TypeName(at, (*names, a) if a != "*" else tuple(names)) for a in aliases]
            aliases = aliases or names[-1:]
            full = full or [TypeName(at, tuple(names))]
            clauses = [Import(alias, name) for alias, name in zip(aliases, full, strict=True)]
        self.string_comment()
        self.annotation_clause()
        return clauses

    def component_clause(self, prefixes: frozenset[str]) -> list[ComponentDeclaration]:
        """``prefixes Type a, b(...) ...``."""
        words = set(prefixes)
        while self.kind in _COMPONENT_PREFIXES:
            words.add(self.advance())
        type_name = self.type_name()
        shared = self.subscripts()
        components = [self.component(type_name, frozenset(words), shared)]
        while self.accept(","):
            components.append(self.component(type_name, frozenset(words), shared))
        if self.accept("constrainedby"):
            constraint = self.constraint()
            description, annotation = self.string_comment(), self.annotation_clause()
            for component in components:
                component.constraint = constraint
                component.description = component.description or description
                component.annotation = annotation if annotation.arguments else component.annotation
        return components

    def component(
        self, type_name: TypeName, prefixes: frozenset[str], shared: tuple[Expression, ...]
    ) -> ComponentDeclaration:
        """One declared name with all that belongs to it."""
        at = self.offset
        name = self.expect("name")
        dimensions = self.subscripts()
        node = ComponentDeclaration(name, at, type_name, prefixes, dimensions + shared)
        node.modification = self.modification()
        if self.accept("if"):
            node.condition = self.expression()
        node.description = self.string_comment()
        node.annotation = self.annotation_clause()
        node.span = (type_name.at, self.tokens.offsets[self.index])
        return node

    # ---- modifications ------------------------------------------------------------------------------------

    def modification(self) -> Modification:
        """``(arguments) = value``, each part optional."""
        arguments = self.class_modification().arguments if self.kind == "(" else ()
        value = None
        if self.kind in ("=", ":="):
            self.advance()
            value = self.expression()
        return Modification(arguments, value) if arguments or value is not None else EMPTY

    def class_modification(self) -> Modification:
        """``(argument, ...)`` or nothing."""
        if not self.accept("("):
            return EMPTY
        arguments: list[Argument] = []
        self.deeper()
        while self.kind != ")":
            arguments.append(self.argument())
            if not self.accept(","):
                break
        self.depth -= 1
        self.expect(")")
        return Modification(tuple(arguments))

    def argument(self) -> Argument:
        """One modification or redeclaration."""
        words = set()
        while self.kind in ("each", "final", "redeclare", "replaceable"):
            words.add(self.advance())
        each, final = "each" in words, "final" in words
        if words & {"redeclare", "replaceable"}:
            return self.redeclaration(frozenset(words), each, final)
        at = self.offset
        names = [self.expect("name")]
        while self.accept("."):
            names.append(self.expect("name"))
        self.deeper(len(names))
        if self.kind == "[":
            self.fail("a modification cannot have subscripts: modify the whole array")
        modification = self.modification()
        self.depth -= len(names)
        self.string_comment()
        # a.b = c is written out as a(b = c)
        for name in reversed(names[1:]):
            modification = Modification((Argument(name, at, modification, each, final),))
        return Argument(names[0], at, modification, each, final)

    def redeclaration(self, words: frozenset[str], each: bool, final: bool) -> Argument:
        """What follows ``redeclare``."""
        node: ComponentDeclaration | ClassDefinition
        if self.kind in _CLASS_KINDS or self.kind in _CLASS_PREFIXES:
            node = self.class_definition(None, words | self.class_prefixes())
            self.trailing_constraint(node)
            if node.alias is None:
                raise self.source.error(
                    "write a redeclaration as 'redeclare model Name = Class'", node.at
                )
        else:
            more = set(words)
            while self.kind in _COMPONENT_PREFIXES:
                more.add(self.advance())
            type_name = self.type_name()
            node = self.component(type_name, frozenset(more), self.subscripts())
            if self.accept("constrainedby"):
                node.constraint = self.constraint()
        return Argument(node.name, node.at, EMPTY, each, final, node)

    def annotation_clause(self) -> Modification:
        """``annotation(...)`` or nothing."""
        if not self.accept("annotation"):
            return EMPTY
        return self.class_modification()
