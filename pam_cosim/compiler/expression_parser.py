"""The expression part of the Modelica grammar (Modelica 3.6, appendix A.2.7)."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Container
from typing import NoReturn

from pam_cosim.compiler.budget import LARGEST_INTEGER, LIMITS
from pam_cosim.compiler.lexer import Tokens
from pam_cosim.compiler.source import SourceText
from pam_cosim.compiler.syntax import (
    Array,
    Binary,
    Call,
    Conditional,
    Expression,
    FunctionArgument,
    Group,
    Iterator,
    Last,
    Literal,
    Matrix,
    Range,
    Reference,
    TypeName,
    Unary,
    Whole,
)
from pam_cosim.wording import printable

_ESCAPE = re.compile(r"\\(.)", re.DOTALL)
_ESCAPED = {"n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "f": "\f", "v": "\v"}
_DIGITS = 19  # of an Integer of 64 bits
_RELATIONS = frozenset(("<", "<=", ">", ">=", "==", "<>"))
_ADDITIONS = frozenset(("+", "-", ".+", ".-"))
_PRODUCTS = frozenset(("*", "/", ".*", "./"))


class ExpressionParser:
    """A cursor over tokens, and the grammar of expressions."""

    def __init__(self, source: SourceText, tokens: Tokens, start: int = 0) -> None:
        self.source = source
        self.tokens = tokens
        self.index = start
        self.depth = 0

    # ---- cursor -------------------------------------------------------------------------------------------

    @property
    def kind(self) -> str:
        """Kind of the current token."""
        return self.tokens.kinds[self.index]

    @property
    def text(self) -> str:
        """Text of the current token."""
        return self.tokens.texts[self.index]

    @property
    def offset(self) -> int:
        """Place of the current token."""
        return self.tokens.offsets[self.index]

    def peek(self) -> str:
        """Kind of the next token."""
        return self.tokens.kinds[min(self.index + 1, len(self.tokens.kinds) - 1)]

    def advance(self) -> str:
        """Text of the current token; step to the next."""
        text = self.tokens.texts[self.index]
        self.index += 1
        return text

    def accept(self, kind: str) -> bool:
        """Step over the token if it is of this kind."""
        if self.tokens.kinds[self.index] == kind:
            self.index += 1
            return True
        return False

    def expect(self, kind: str) -> str:
        """Step over a token that must be of this kind, and return its text."""
        if self.tokens.kinds[self.index] != kind:
            self.fail(f"expected {'a name' if kind == 'name' else repr(kind)}, found '{self.text}'")
        return self.advance()

    def fail(self, message: str) -> NoReturn:
        """Raise a syntax error at the current token."""
        raise self.source.error(message, self.offset)

    # ---- names, strings, subscripts -----------------------------------------------------------------------

    def type_name(self) -> TypeName:
        """A dotted class name."""
        at = self.offset
        absolute = self.accept(".")
        names = [self.expect("name")]
        while self.kind == "." and self.peek() == "name":
            self.index += 1
            names.append(self.advance())
        return TypeName(at, tuple(names), absolute)

    def string(self) -> str:
        """A string literal without quotes, escapes resolved."""
        return unquote(self.advance())

    def string_comment(self) -> str:
        """A description string, possibly joined with ``+``, or nothing; what commands a terminal is blank in it."""
        if self.kind != "string":
            return ""
        text = self.string()
        while self.kind == "+" and self.peek() == "string":
            self.index += 1
            text += self.string()
        return printable(text)

    def subscripts(self) -> tuple[Expression, ...]:
        """``[i, :, end]`` or nothing."""
        if not self.accept("["):
            return ()
        subscripts = [self.subscript()]
        while self.accept(","):
            subscripts.append(self.subscript())
        self.expect("]")
        return tuple(subscripts)

    def subscript(self) -> Expression:
        """One subscript."""
        if self.kind == ":":
            at = self.offset
            self.index += 1
            return Whole(at)
        return self.expression()

    # ---- expressions --------------------------------------------------------------------------------------

    def expression(self) -> Expression:
        """Any expression."""
        self.deeper()
        expression = self._expression()
        self.depth -= 1
        return expression

    def deeper(self, levels: int = 1) -> None:
        """Counts levels in the text; the caller takes them back at their end. After an error nothing is parsed."""
        self.depth += levels
        if self.depth > LIMITS.nesting:
            self.fail(
                f"expressions, modifications or classes stand more than {LIMITS.nesting} deep within one another"
            )

    def _expression(self) -> Expression:
        if self.kind == "if":
            return self.conditional()
        at = self.offset
        first = self.disjunction()
        if self.kind != ":":
            return first
        self.index += 1
        second = self.disjunction()
        if not self.accept(":"):
            return Range(at, first, None, second)
        return Range(at, first, second, self.disjunction())

    def conditional(self) -> Expression:
        """``if ... then ... else ...``."""
        at = self.offset
        branches = []
        self.expect("if")
        while True:
            condition = self.expression()
            self.expect("then")
            branches.append((condition, self.expression()))
            if not self.accept("elseif"):
                break
        self.expect("else")
        return Conditional(at, tuple(branches), self.expression())

    def disjunction(self) -> Expression:
        """``a or b``."""
        return self._from_left(("or",), self.conjunction, self.conjunction())

    def conjunction(self) -> Expression:
        """``a and b``."""
        return self._from_left(("and",), self.negation, self.negation())

    def _from_left(
        self, operators: Container[str], operand: Callable[[], Expression], left: Expression
    ) -> Expression:
        """Operators of one rank, of which the first is applied first, after the operand ``left``."""
        while self.kind in operators:
            at, operator = self.offset, self.advance()
            left = Binary(at, operator, left, operand())
        return left

    def negation(self) -> Expression:
        """``not a``."""
        at = self.offset
        if self.accept("not"):
            return Unary(at, "not", self.relation())
        return self.relation()

    def relation(self) -> Expression:
        """``a < b``."""
        left = self.arithmetic()
        if self.kind in _RELATIONS:
            at = self.offset
            operator = self.advance()
            return Binary(at, operator, left, self.arithmetic())
        return left

    def arithmetic(self) -> Expression:
        """Sums; a leading sign belongs to the first term."""
        at = self.offset
        if self.kind in _ADDITIONS:
            operator = self.advance()
            left: Expression = Unary(at, operator.lstrip("."), self.term())
        else:
            left = self.term()
        return self._from_left(_ADDITIONS, self.term, left)

    def term(self) -> Expression:
        """Products."""
        return self._from_left(_PRODUCTS, self.factor, self.factor())

    def factor(self) -> Expression:
        """Powers."""
        left = self.primary()
        if self.kind in ("^", ".^"):
            at = self.offset
            operator = self.advance()
            return Binary(at, operator, left, self.primary())
        return left

    def primary(self) -> Expression:
        """Literals, references, calls, arrays and parentheses."""
        kind, at = self.kind, self.offset
        if kind == "number":
            text = self.advance()
            return Literal(at, self.number(text))
        if kind == "name" or kind == ".":
            return self.reference_or_call()
        if kind == "string":
            return Literal(at, self.string())
        if kind in ("true", "false"):
            return Literal(at, self.advance() == "true")
        if kind in ("der", "initial", "pure"):
            self.index += 1
            return self.call(Reference(at, ((kind, ()),)))
        if kind == "(":
            return self.parenthesis()
        if kind == "{":
            return self.array()
        if kind == "end":
            self.index += 1
            return Last(at)
        if kind == "[":
            return self.matrix()
        self.fail(f"expected an expression, found '{self.text}'")

    def number(self, text: str) -> int | float:
        """The value of a number's text; fails at the token before the current one."""
        value = int(text) if text.isdigit() and len(text) <= _DIGITS else float(text)
        if abs(value) > LARGEST_INTEGER and text.isdigit() or not math.isfinite(value):
            self.index -= 1
            self.fail(
                "the number is too large"
                if math.isfinite(value)
                else "the number is larger than a Real can be"
            )
        return value

    def reference(self) -> Reference:
        """``a.b[i].c``."""
        at = self.offset
        absolute = self.accept(".")
        parts = [(self.expect("name"), self.subscripts())]
        while self.accept("."):
            parts.append((self.expect("name"), self.subscripts()))
        return Reference(at, tuple(parts), absolute)

    def reference_or_call(self) -> Expression:
        """A reference, or a call of the function it names."""
        reference = self.reference()
        return self.call(reference) if self.kind == "(" else reference

    def call(self, function: Reference) -> Call:
        """``(arguments, name = value)``."""
        self.expect("(")
        arguments: list[Expression] = []
        named: list[tuple[str, Expression]] = []
        iterators: tuple[Iterator, ...] = ()
        while self.kind != ")":
            if self.kind == "name" and self.peek() == "=":
                name = self.advance()
                self.index += 1
                named.append((name, self.argument_of_call()))
            else:
                arguments.append(self.argument_of_call())
                if self.accept("for"):
                    iterators = self.iterators()
            if not self.accept(","):
                break
        self.expect(")")
        return Call(function.at, function, tuple(arguments), tuple(named), iterators)

    def argument_of_call(self) -> Expression:
        """An expression, or a function with some of its arguments."""
        at = self.offset
        if not self.accept("function"):
            return self.expression()
        return FunctionArgument(at, self.call(self.reference()))

    def iterators(self) -> tuple[Iterator, ...]:
        """``i in r, j in s``, after ``for``."""
        iterators = []
        while True:
            name = self.expect("name")
            given = self.accept("in")
            iterators.append(Iterator(name, self.expression() if given else Whole(self.offset)))
            if not self.accept(","):
                return tuple(iterators)

    def parenthesis(self) -> Expression:
        """``(a)``, or ``(a, , b)`` as the target of several results."""
        at = self.offset
        self.expect("(")
        items: list[Expression | None] = [None if self.kind == "," else self.expression()]
        while self.accept(","):
            items.append(None if self.kind in (",", ")") else self.expression())
        self.expect(")")
        if len(items) == 1 and items[0] is not None:
            return items[0]
        return Group(at, tuple(items))

    def array(self) -> Expression:
        """``{a, b}`` or ``{e for i in r}``."""
        at = self.offset
        self.expect("{")
        items = [self.expression()]
        iterators: tuple[Iterator, ...] = ()
        if self.accept("for"):
            iterators = self.iterators()
        while self.accept(","):
            items.append(self.expression())
        self.expect("}")
        return Array(at, tuple(items), iterators)

    def matrix(self) -> Expression:
        """``[a, b; c, d]``."""
        at = self.offset
        self.expect("[")
        rows = [self.row()]
        while self.accept(";"):
            rows.append(self.row())
        self.expect("]")
        return Matrix(at, tuple(rows))

    def row(self) -> tuple[Expression, ...]:
        """One row of a matrix."""
        items = [self.expression()]
        while self.accept(","):
            items.append(self.expression())
        return tuple(items)


def unquote(token: str) -> str:
    """The value of a string token."""
    return _ESCAPE.sub(lambda escape: _ESCAPED.get(escape[1], escape[1]), token[1:-1])
