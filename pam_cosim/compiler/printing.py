"""Syntax trees back to Modelica text."""

from __future__ import annotations

from collections.abc import Sequence

from pam_cosim.compiler.syntax import (
    Argument,
    Array,
    Binary,
    Call,
    ClassDefinition,
    Conditional,
    Element,
    Expression,
    FunctionArgument,
    Group,
    Iterator,
    Last,
    Literal,
    Matrix,
    Member,
    Modification,
    Range,
    Reference,
    Unary,
    Whole,
)

_PRECEDENCE = {"or": 1, "and": 2, "not": 3, "<": 4, "<=": 4, ">": 4, ">=": 4, "==": 4, "<>": 4}
_PRECEDENCE |= {"+": 5, "-": 5, ".+": 5, ".-": 5, "*": 6, "/": 6, ".*": 6, "./": 6, "^": 7, ".^": 7}
_UNARY_SIGN = 5
_PRIMARY = 8


def expression_text(node: Expression) -> str:
    """An expression as Modelica text, with the parentheses that it needs."""
    return _text(node)[0]


def string_text(text: str) -> str:
    """Any text as a string literal of Modelica."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def modification_text(modification: Modification) -> str:
    """``(a=1, b(c=2)) = 3``, as it follows the name of a component."""
    text = (
        f"({', '.join(map(argument_text, modification.arguments))})"
        if modification.arguments
        else ""
    )
    if modification.value is not None:
        text += (
            f" = {expression_text(modification.value)}"
            if text
            else f"={expression_text(modification.value)}"
        )
    return text


def argument_text(argument: Argument) -> str:
    """One entry of a modification."""
    words = "".join(
        f"{word} "
        for word, is_set in (("each", argument.each), ("final", argument.final))
        if is_set
    )
    new = argument.redeclaration
    if new is None:
        return f"{words}{argument.name}{modification_text(argument.modification)}"
    if isinstance(new, ClassDefinition):
        assert new.alias is not None
        target = f"{new.alias.type.text}{modification_text(new.alias.modification)}"
        return f"{words}redeclare {new.kind} {new.name} = {target}"
    return f"{words}redeclare {new.type.text} {new.name}{modification_text(new.modification)}"


def _text(node: Expression) -> tuple[str, int]:
    """Text and precedence."""
    if isinstance(node, Literal):
        return _literal(node), _PRIMARY
    if isinstance(node, Reference):
        dot = "." if node.absolute else ""
        return dot + ".".join(name + _subscripts(subs) for name, subs in node.parts), _PRIMARY
    if isinstance(node, Unary):
        level = _PRECEDENCE["not"] if node.operator == "not" else _UNARY_SIGN
        space = " " if node.operator == "not" else ""
        return f"{node.operator}{space}{_within(node.operand, level + 1)}", level
    if isinstance(node, Binary):
        return _binary(node)
    if isinstance(node, Conditional):
        branches = " else".join(
            f"if {expression_text(c)} then {expression_text(e)}" for c, e in node.branches
        )
        return f"{branches} else {expression_text(node.otherwise)}", 0
    if isinstance(node, Range):
        parts = [node.start, node.stop] if node.step is None else [node.start, node.step, node.stop]
        return ":".join(_within(part, 1) for part in parts), 0
    return _compound(node), _PRIMARY


def _compound(node: Expression) -> str:
    if isinstance(node, Call):
        named = [f"{name}={expression_text(value)}" for name, value in node.named]
        inside = ", ".join([*map(expression_text, node.arguments), *named])
        return f"{node.function.text}({inside}{_iterators(node.iterators)})"
    if isinstance(node, Array):
        return f"{{{', '.join(map(expression_text, node.items))}{_iterators(node.iterators)}}}"
    if isinstance(node, Matrix):
        rows = (", ".join(map(expression_text, row)) for row in node.rows)
        return f"[{'; '.join(rows)}]"
    if isinstance(node, FunctionArgument):
        return f"function {expression_text(node.call)}"
    if isinstance(node, Group):
        return (
            f"({', '.join('' if item is None else expression_text(item) for item in node.items)})"
        )
    if isinstance(node, Element):
        return f"{_within(node.base, _PRIMARY)}[{node.index + 1}]"
    if isinstance(node, Member):
        return f"{_within(node.base, _PRIMARY)}.{node.name}"
    return {Whole: ":", Last: "end"}[type(node)]


def _binary(node: Binary) -> tuple[str, int]:
    level = _PRECEDENCE[node.operator]
    is_power = level == _PRECEDENCE["^"]
    left, right = _within(node.left, level + is_power), _within(node.right, level + 1)
    space = "" if level >= _PRECEDENCE["*"] else " "
    return f"{left}{space}{node.operator}{space}{right}", level


def _within(node: Expression, level: int) -> str:
    text, node_level = _text(node)
    return text if node_level >= level else f"({text})"


def _literal(node: Literal) -> str:
    if isinstance(node.value, bool):
        return "true" if node.value else "false"
    if isinstance(node.value, str):
        return string_text(node.value)
    return repr(node.value)


def _subscripts(subscripts: Sequence[Expression]) -> str:
    return f"[{', '.join(map(expression_text, subscripts))}]" if subscripts else ""


def _iterators(iterators: Sequence[Iterator]) -> str:
    if not iterators:
        return ""
    return " for " + ", ".join(
        f"{iterator.name} in {expression_text(iterator.range)}" for iterator in iterators
    )
