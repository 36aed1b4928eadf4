"""Calls of functions that are written in Modelica: their statements are run on values, symbolic or not."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress

from pam_cosim.compiler import arithmetic
from pam_cosim.compiler.assertions import check
from pam_cosim.compiler.budget import checked_size
from pam_cosim.compiler.evaluation import NO_NAMES, Environment, Evaluator, Value
from pam_cosim.compiler.instance import Class, Instance, Scope
from pam_cosim.compiler.syntax import (
    Assignment,
    Call,
    Equation,
    Expression,
    For,
    Group,
    If,
    Leave,
    Procedure,
    Reference,
    Unsupported,
    While,
    Whole,
)
from pam_cosim.errors import ModelError

_DEPTH = 60


class _Left(ModelError):
    """``break`` or ``return``, on its way to the end of the loop or of the function."""


def call(
    evaluator: Evaluator, of: Class, node: Call, scope: Scope, names: Environment
) -> tuple[Value, ...]:
    """All results of a function, in order.

    Raises:
        ModelError: wrong arguments, a partial function, statements that need values known only at run time.
    """
    function = evaluator.instantiator.function(of)
    name = of.definition.qualified_name
    if any(ancestor.definition.external for ancestor in function.ancestors):
        raise ModelError(f"function {name} is external: that is not supported")
    if not function.sections:
        raise ModelError(f"function {name} has no algorithm: redeclare it with one that has")
    inputs = [child for child in function.children.values() if "input" in child.prefixes]
    outputs = [child for child in function.children.values() if "output" in child.prefixes]
    given = _arguments(evaluator, name, inputs, node, scope, names)
    local = _with_defaults(evaluator, name, function, inputs, given)
    if evaluator.depth > _DEPTH:
        raise ModelError(f"function {name} calls itself without end")
    evaluator.depth += 1
    try:
        with suppress(_Left):
            for section, place in function.sections:
                run(evaluator, section.equations, place, local)
    finally:
        evaluator.depth -= 1
    results = tuple(local[child.local_name] for child in outputs)
    for child, result in zip(outputs, results, strict=True):
        if any(value is None for value in arithmetic.flattened(result)):
            raise ModelError(f"function {name} does not assign its output '{child.local_name}'")
    return results


def _arguments(
    evaluator: Evaluator,
    name: str,
    inputs: list[Instance],
    node: Call,
    scope: Scope,
    names: Environment,
) -> dict[str, Value]:
    if len(node.arguments) > len(inputs):
        raise ModelError(
            f"function {name} takes {len(inputs)} arguments, {len(node.arguments)} are given"
        )
    given = {
        child.local_name: evaluator.evaluate(argument, scope, names)
        for child, argument in zip(inputs, node.arguments, strict=False)
    }
    input_names = [child.local_name for child in inputs]
    for argument_name, argument in node.named:
        if argument_name not in input_names:
            raise ModelError(f"function {name} has no input '{argument_name}'")
        if argument_name in given:
            raise ModelError(f"input '{argument_name}' of function {name} is given twice")
        given[argument_name] = evaluator.evaluate(argument, scope, names)
    return given


def _with_defaults(
    evaluator: Evaluator,
    name: str,
    function: Instance,
    inputs: list[Instance],
    given: dict[str, Value],
) -> dict[str, Value]:
    """The variables of a call before its first statement; constants are found through the instance."""
    local: dict[str, Value] = {}
    for child in function.children.values():
        if child.variability == "constant":
            continue
        key, value = child.local_name, child.modification.value
        if key in given:
            local[key] = given[key]
        elif value is not None:
            is_default = (
                value.scope.instance is function
            )  # else it is written where the function is modified
            local[key] = evaluator.bound(value, local if is_default else NO_NAMES)
        elif child in inputs:
            raise ModelError(f"function {name} needs its input '{key}'")
        else:
            local[key] = _empty(evaluator, child, local)
    return local


def _empty(evaluator: Evaluator, child: Instance, local: Environment) -> Value:
    assert child.declaration is not None and child.scope is not None
    result: Value = None
    for size in reversed(child.declaration.dimensions):
        if isinstance(size, Whole):
            raise evaluator.at_declaration(child, f"the size of '{child.local_name}' is not known")
        count = checked_size(evaluator.integer(size, child.scope, local))
        result = evaluator.instantiator.budget.values([_copied(result) for _ in range(count)])
    return result


def _copied(value: Value) -> Value:
    return [_copied(item) for item in value] if isinstance(value, list) else value


def run(
    evaluator: Evaluator, statements: Iterable[Equation], scope: Scope, local: dict[str, Value]
) -> None:
    """Run statements; ``local`` holds the variables and is changed."""
    for statement in statements:
        try:
            _run_one(evaluator, statement, scope, local)
        except _Left:
            raise
        except ModelError as error:
            if error.file is None:
                raise scope.definition.source.error(error.message, statement.at) from None
            raise


def _run_one(
    evaluator: Evaluator, statement: Equation, scope: Scope, local: dict[str, Value]
) -> None:
    if isinstance(statement, Assignment):
        _assign(evaluator, statement, scope, local)
    elif isinstance(statement, If):
        _run_if(evaluator, statement, scope, local)
    elif isinstance(statement, For):
        counters = [iterator.name for iterator in statement.iterators]
        hidden = {name: local[name] for name in counters if name in local}
        for point in evaluator.points(statement.iterators, scope, dict(local)):
            local.update({name: point[name] for name in counters})
            if _breaks(evaluator, statement.body, scope, local):
                break
        for name in counters:
            local.pop(name, None)
        local.update(hidden)
    elif isinstance(statement, While):
        holds: Value = True
        while holds is True:
            holds = evaluator.evaluate(statement.condition, scope, local)
            if holds is True and _breaks(evaluator, statement.body, scope, local):
                return
        if holds is not False:
            raise ModelError("the condition of 'while' is known only when the model runs")
    elif isinstance(statement, Leave):
        raise _Left(statement.what)
    elif isinstance(statement, Procedure):
        if statement.call.function.text == "assert":
            check(evaluator, statement.call, scope, local)
        elif statement.call.function.text != "print":
            evaluator.evaluate(statement.call, scope, local)
    else:
        what = statement.what if isinstance(statement, Unsupported) else "this statement"
        raise ModelError(f"'{what}' is not supported in functions")


def _breaks(
    evaluator: Evaluator, body: Iterable[Equation], scope: Scope, local: dict[str, Value]
) -> bool:
    """Runs the body of a loop: whether it ends the loop."""
    try:
        run(evaluator, body, scope, local)
    except _Left as left:
        if left.message != "break":
            raise
        return True
    return False


def _assign(
    evaluator: Evaluator, statement: Assignment, scope: Scope, local: dict[str, Value]
) -> None:
    if isinstance(statement.target, Group):
        if not isinstance(statement.value, Call):
            raise ModelError("several targets need a function call on the right")
        results = evaluator.results(statement.value, scope, local)
        targets = statement.target.items
        for target, value in zip(
            targets, results if isinstance(results, tuple) else (results,), strict=False
        ):
            if target is not None:
                _store(evaluator, target, value, scope, local)
    else:
        _store(
            evaluator,
            statement.target,
            evaluator.evaluate(statement.value, scope, local),
            scope,
            local,
        )


def _store(
    evaluator: Evaluator, target: Expression, value: Value, scope: Scope, local: dict[str, Value]
) -> None:
    if not isinstance(target, Reference) or len(target.parts) != 1:
        raise ModelError("a variable of the function is needed on the left of ':='")
    name, subscripts = target.parts[0]
    if name not in local:
        raise ModelError(f"'{name}' is not a variable of this function")
    if not subscripts:
        local[name] = _copied(value)
        return
    # copy on write: an array that was handed in, or kept for another branch, must not change
    local[name] = items = evaluator.instantiator.budget.values(_copied(local[name]))
    for subscript in subscripts[:-1]:
        items = items[_index(evaluator, subscript, items, scope, local)]
    if isinstance(subscripts[-1], Whole):
        items[:] = _copied(value)
    else:
        items[_index(evaluator, subscripts[-1], items, scope, local)] = value


def _index(
    evaluator: Evaluator, subscript: Expression, items: Value, scope: Scope, local: Environment
) -> int:
    if not isinstance(items, list):
        raise ModelError("there are more subscripts than dimensions")
    index = evaluator.integer(subscript, scope, {**local, "end": len(items)})
    if not 1 <= index <= len(items):
        raise ModelError(f"subscript {index} is outside 1:{len(items)}")
    return index - 1


def _run_if(evaluator: Evaluator, statement: If, scope: Scope, local: dict[str, Value]) -> None:
    """Branches that depend on symbols are all run; each variable then selects its value."""
    open_branches: list[tuple[Value, dict[str, Value]]] = []
    last, open_still = local, True
    for condition, body in statement.branches:
        value = True if condition is None else evaluator.evaluate(condition, scope, local)
        if value is False:
            continue
        if value is True and not open_branches:
            run(evaluator, body, scope, local)
            return
        branch = dict(local)
        try:
            with evaluator.branch(arithmetic.only(value, open_still)):
                run(evaluator, body, scope, branch)
        except _Left as left:
            text = f"'{left.message}' depends on a condition that is known only when the model runs"
            raise ModelError(text) from None
        if value is True:
            last = branch
            break
        open_branches.append((value, branch))
        open_still = arithmetic.neither(open_still, value)
    for name in list(local):
        candidates = [(value, branch[name]) for value, branch in open_branches]
        if all(candidate is last[name] for _, candidate in candidates):
            local[name] = last[name]
        elif last[name] is None or any(candidate is None for _, candidate in candidates):
            local[name] = None
        else:
            local[name] = arithmetic.select(candidates, last[name])
