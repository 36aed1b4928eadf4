"""The equation and statement part of the Modelica grammar (Modelica 3.6, appendix A.2.6)."""

from __future__ import annotations

from dataclasses import replace

from pam_cosim.compiler.expression_parser import ExpressionParser
from pam_cosim.compiler.syntax import (
    Assignment,
    Call,
    Connect,
    Equality,
    Equation,
    Expression,
    For,
    If,
    Leave,
    Procedure,
    Reference,
    Unsupported,
    While,
)

_STOPS = frozenset(("end", "else", "elseif", "elsewhen", "end of file"))


class EquationParser(ExpressionParser):
    """Equations and statements differ only in ``=`` and ``:=``."""

    def equations(self, section: str, stop: int) -> tuple[Equation, ...]:
        """All equations or statements up to token number ``stop``."""
        equations = []
        while self.index < stop:
            equations.append(self.equation(section))
            self.expect(";")
        return tuple(equations)

    def block(self, section: str) -> tuple[Equation, ...]:
        """The equations up to ``end``, ``else`` and the like."""
        equations = []
        while self.kind not in _STOPS:
            equations.append(self.equation(section))
            self.expect(";")
        return tuple(equations)

    def equation(self, section: str) -> Equation:
        """One equation or statement, without its semicolon."""
        at = self.offset
        self.deeper()
        if self.kind == "if":
            equation: Equation = self.if_equation(section)
        elif self.kind == "for":
            equation = self.for_equation(section)
        elif self.kind == "while":
            equation = self.while_loop(section)
        elif self.kind == "when":
            equation = self.skip_block()
        elif self.kind in ("return", "break"):
            equation = Leave(at, self.advance())
        elif self.kind == "connect":
            equation = self.connect()
        else:
            equation = self.simple(section)
        self.depth -= 1
        self.string_comment()
        if self.accept("annotation"):
            start = self.offset
            self.skip_parentheses()
            if isinstance(equation, Connect):
                return replace(equation, annotation=(start, self.offset))
        return equation

    def simple(self, section: str) -> Equation:
        """An equality, an assignment or a call that stands alone."""
        at = self.offset
        left: Expression
        if self.kind == "assert":
            self.index += 1
            left = self.call(Reference(at, (("assert", ()),)))
        else:
            left = self.expression()
        if section == "algorithm":
            if self.accept(":="):
                return Assignment(at, left, self.expression())
        elif self.accept("="):
            return Equality(at, left, self.expression())
        if isinstance(left, Call):
            return Procedure(at, left)
        wanted = ":=" if section == "algorithm" else "="
        self.fail(f"expected '{wanted}' in {section} section, found '{self.text}'")

    def connect(self) -> Connect:
        """``connect(a, b)``."""
        at = self.offset
        self.expect("connect")
        self.expect("(")
        left = self.reference()
        self.expect(",")
        right = self.reference()
        self.expect(")")
        return Connect(at, left, right)

    def if_equation(self, section: str) -> If:
        """``if ... end if``."""
        at = self.offset
        self.expect("if")
        branches: list[tuple[Expression | None, tuple[Equation, ...]]] = []
        while True:
            condition = self.expression()
            self.expect("then")
            branches.append((condition, self.block(section)))
            if not self.accept("elseif"):
                break
        if self.accept("else"):
            branches.append((None, self.block(section)))
        self.expect("end")
        self.expect("if")
        return If(at, tuple(branches))

    def for_equation(self, section: str) -> For:
        """``for ... end for``."""
        at = self.offset
        self.expect("for")
        iterators = self.iterators()
        self.expect("loop")
        body = self.block(section)
        self.expect("end")
        self.expect("for")
        return For(at, iterators, body)

    def while_loop(self, section: str) -> While:
        """``while ... end while``."""
        at = self.offset
        self.expect("while")
        condition = self.expression()
        self.expect("loop")
        body = self.block(section)
        self.expect("end")
        self.expect("while")
        return While(at, condition, body)

    def skip_block(self) -> Unsupported:
        """``when``: refused when a model uses it, not when the file is read."""
        at, what = self.offset, self.kind
        while not (self.kind == "end" and self.peek() == what):
            if self.kind == "end of file":
                self.fail(f"'end {what}' is missing")
            self.index += 1
        self.index += 2
        return Unsupported(at, what)

    def skip_parentheses(self) -> None:
        """Step over ``( ... )``."""
        depth = 0
        while True:
            if self.kind == "(":
                depth += 1
            elif self.kind == ")":
                depth -= 1
            elif self.kind == "end of file":
                self.fail("')' is missing")
            self.index += 1
            if depth == 0:
                return
