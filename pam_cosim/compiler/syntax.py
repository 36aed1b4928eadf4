"""The syntax tree of Modelica: what the parser makes and everything else reads.

Nodes compare by identity and do not print their contents: they refer to each other, and a print would have no end.
``at`` is the character offset in the source of the class that holds the node.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from pam_cosim.compiler.lazy import LazyDict
from pam_cosim.compiler.source import SourceText

# ---- expressions ------------------------------------------------------------------------------------------


@dataclass(eq=False, repr=False, slots=True)
class Expression:
    """Base of all expressions."""

    at: int


@dataclass(eq=False, repr=False, slots=True)
class Literal(Expression):
    """A number (int or float), a string or a Boolean."""

    value: float | int | str | bool


@dataclass(eq=False, repr=False, slots=True)
class Reference(Expression):
    """``a.b[i].c``: names, each with its subscripts."""

    parts: tuple[tuple[str, tuple[Expression, ...]], ...]
    absolute: bool = False

    @property
    def text(self) -> str:
        """The dotted name without subscripts."""
        return ".".join(name for name, _ in self.parts)


@dataclass(eq=False, repr=False, slots=True)
class Unary(Expression):
    """``-a``, ``+a`` or ``not a``."""

    operator: str
    operand: Expression


@dataclass(eq=False, repr=False, slots=True)
class Binary(Expression):
    """Arithmetic, relation or logical operation of two operands."""

    operator: str
    left: Expression
    right: Expression


@dataclass(eq=False, repr=False, slots=True)
class Conditional(Expression):
    """``if c1 then e1 elseif c2 then e2 else e3``."""

    branches: tuple[tuple[Expression, Expression], ...]
    otherwise: Expression


@dataclass(eq=False, repr=False, slots=True)
class Call(Expression):
    """A function call; ``iterators`` for ``f(e for i in r)``."""

    function: Reference
    arguments: tuple[Expression, ...]
    named: tuple[tuple[str, Expression], ...] = ()
    iterators: tuple[Iterator, ...] = ()


@dataclass(eq=False, repr=False, slots=True)
class Array(Expression):
    """``{a, b}`` or ``{e for i in r}``."""

    items: tuple[Expression, ...]
    iterators: tuple[Iterator, ...] = ()


@dataclass(eq=False, repr=False, slots=True)
class Matrix(Expression):
    """``[a, b; c, d]``."""

    rows: tuple[tuple[Expression, ...], ...]


@dataclass(eq=False, repr=False, slots=True)
class FunctionArgument(Expression):
    """``function f(a = 1)`` as the argument of a function."""

    call: Call


@dataclass(eq=False, repr=False, slots=True)
class Range(Expression):
    """``start:stop`` or ``start:step:stop``."""

    start: Expression
    step: Expression | None
    stop: Expression


@dataclass(eq=False, repr=False, slots=True)
class Group(Expression):
    """``(a, b)`` on the left of a call with several results."""

    items: tuple[Expression | None, ...]


@dataclass(eq=False, repr=False, slots=True)
class Whole(Expression):
    """``:`` as a subscript or an unknown size."""


@dataclass(eq=False, repr=False, slots=True)
class Last(Expression):
    """``end`` as a subscript."""


@dataclass(eq=False, repr=False, slots=True)
class Element(Expression):
    """One element of an array-valued expression; made by the compiler when it takes an array binding apart."""

    base: Expression
    index: int


@dataclass(eq=False, repr=False, slots=True)
class Member(Expression):
    """One member of a record-valued expression; made by the compiler when it takes a record binding apart."""

    base: Expression
    name: str


@dataclass(eq=False, repr=False, slots=True)
class Iterator:
    """``i in 1:n``."""

    name: str
    range: Expression


# ---- equations and statements -----------------------------------------------------------------------------


@dataclass(eq=False, repr=False, slots=True)
class Equation:
    """Base of equations and statements."""

    at: int


@dataclass(eq=False, repr=False, slots=True)
class Equality(Equation):
    """``left = right``."""

    left: Expression
    right: Expression


@dataclass(eq=False, repr=False, slots=True)
class Connect(Equation):
    """``connect(a, b)``."""

    left: Reference
    right: Reference
    annotation: tuple[int, int] = (0, 0)  # where its text begins and ends


@dataclass(eq=False, repr=False, slots=True)
class If(Equation):
    """``if ... then ... elseif ... else ... end if``; the last branch has no condition if it is ``else``."""

    branches: tuple[tuple[Expression | None, tuple[Equation, ...]], ...]


@dataclass(eq=False, repr=False, slots=True)
class For(Equation):
    """``for i in 1:n loop ... end for``."""

    iterators: tuple[Iterator, ...]
    body: tuple[Equation, ...]


@dataclass(eq=False, repr=False, slots=True)
class While(Equation):
    """``while c loop ... end while``."""

    condition: Expression
    body: tuple[Equation, ...]


@dataclass(eq=False, repr=False, slots=True)
class Leave(Equation):
    """``break`` out of a loop, or ``return`` from a function."""

    what: str


@dataclass(eq=False, repr=False, slots=True)
class Assignment(Equation):
    """``target := value``; the target may be a ``Group``."""

    target: Expression
    value: Expression


@dataclass(eq=False, repr=False, slots=True)
class Procedure(Equation):
    """A call that stands alone, such as ``assert(...)``."""

    call: Call


@dataclass(eq=False, repr=False, slots=True)
class Unsupported(Equation):
    """Something this compiler refuses when a model uses it (``when``)."""

    what: str


# ---- declarations -----------------------------------------------------------------------------------------


@dataclass(eq=False, repr=False, slots=True)
class Argument:
    """One entry of a modification: ``each final name(arguments) = value`` or a redeclaration of ``name``."""

    name: str
    at: int
    modification: Modification
    each: bool = False
    final: bool = False
    redeclaration: ComponentDeclaration | ClassDefinition | None = None


@dataclass(eq=False, repr=False, slots=True)
class Modification:
    """``(arguments) = value``."""

    arguments: tuple[Argument, ...] = ()
    value: Expression | None = None

    def argument(self, name: str) -> Argument | None:
        """The entry of that name."""
        return next((entry for entry in self.arguments if entry.name == name), None)


EMPTY = Modification()


@dataclass(eq=False, repr=False, slots=True)
class TypeName:
    """The name of a class as written, with its place."""

    at: int
    names: tuple[str, ...]
    absolute: bool = False

    @property
    def text(self) -> str:
        """The dotted name."""
        return ".".join(self.names)


@dataclass(eq=False, repr=False, slots=True)
class Constraint:
    """``constrainedby Type(modification)``."""

    type: TypeName
    modification: Modification


@dataclass(eq=False, repr=False, slots=True)
class ComponentDeclaration:
    """One component: ``parameter Real x[3](unit="m") = 1 if condition "description" annotation(...)``."""

    name: str
    at: int
    type: TypeName
    prefixes: frozenset[str]
    dimensions: tuple[Expression, ...] = ()
    modification: Modification = EMPTY
    condition: Expression | None = None
    description: str = ""
    annotation: Modification = EMPTY
    constraint: Constraint | None = None
    span: tuple[int, int] = (0, 0)

    @property
    def variability(self) -> str:
        """``constant``, ``parameter``, ``discrete`` or nothing."""
        return next(
            (word for word in ("constant", "parameter", "discrete") if word in self.prefixes), ""
        )


@dataclass(eq=False, repr=False, slots=True)
class Extends:
    """``extends Base(modification)``; of ``class extends X`` the class of the same name that is ``inherited``."""

    at: int
    type: TypeName
    modification: Modification = EMPTY
    inherited: bool = False


@dataclass(eq=False, repr=False, slots=True)
class Import:
    """``import A.B;`` (alias ``B``), ``import C = A.B;`` or ``import A.*;`` (alias ``*``)."""

    alias: str
    type: TypeName


@dataclass(eq=False, repr=False)
class ClassDefinition:
    """A class of any kind. A short class (``type P = Real(unit="Pa")``) has ``alias`` instead of a body."""

    name: str
    kind: str
    at: int
    source: SourceText
    parent: ClassDefinition | None = None
    prefixes: frozenset[str] = frozenset()
    description: str = ""
    annotation: Modification = EMPTY
    imports: list[Import] = field(default_factory=list)
    extends: list[Extends] = field(default_factory=list)
    classes: LazyDict[ClassDefinition] = field(default_factory=LazyDict)
    components: dict[str, ComponentDeclaration] = field(default_factory=dict)
    redeclared: list[ComponentDeclaration | ClassDefinition] = field(default_factory=list)
    alias: Extends | None = None
    alias_dimensions: tuple[Expression, ...] = ()
    alias_prefixes: frozenset[str] = frozenset()
    literals: tuple[tuple[str, str], ...] | None = None
    constraint: Constraint | None = None
    external: bool = False
    deferred: list[Callable[[], Section]] = field(default_factory=list)
    _sections: list[Section] | None = None

    @property
    def qualified_name(self) -> str:
        """The full name, from the root package."""
        return self.name if self.parent is None else f"{self.parent.qualified_name}.{self.name}"

    @property
    def partial(self) -> bool:
        """Whether the class is declared ``partial``."""
        return "partial" in self.prefixes

    @property
    def sections(self) -> list[Section]:
        """Equation and algorithm sections, parsed at first use (the class tree never uses them)."""
        if self._sections is None:
            self._sections = [parse() for parse in self.deferred]
        return self._sections


@dataclass(eq=False, repr=False, slots=True)
class Section:
    """An equation or algorithm section."""

    kind: str
    initial: bool
    equations: tuple[Equation, ...]
