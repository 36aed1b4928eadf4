"""Equations that determine Boolean, Integer and enumeration variables: such a variable stands for an expression."""

from __future__ import annotations

from collections.abc import Sequence

from pam_cosim.compiler.evaluation import Evaluator
from pam_cosim.compiler.instance import Bound, Instance, Scope
from pam_cosim.compiler.syntax import Connect, Equality, Equation, Expression, If, Reference
from pam_cosim.errors import ModelError


class Definitions:
    """The equations ``name = expression`` and the connections of a model's variables that are not Real.

    Args:
        evaluator: finds what a reference names.
        root: the model.
    """

    def __init__(self, evaluator: Evaluator, root: Instance) -> None:
        self._evaluator = evaluator
        self._bounds: dict[Instance, Bound] = {}
        self._connected: dict[Instance, list[Instance]] = {}
        self._used: set[tuple[int, int]] = set()
        for node in list(root.nodes()):
            for section, scope in node.sections:
                if section.kind == "equation" and not section.initial:
                    self._collect(section.equations, scope)

    def of(self, instance: Instance) -> Bound | None:
        """What determines a variable, itself or by what it is connected to; None: nothing."""
        seen, waiting = {instance}, [instance]
        while waiting:
            current = waiting.pop(0)
            bound = self._bounds.get(current) or current.binding
            if bound is not None:
                return bound
            fresh = [other for other in self._connected.get(current, ()) if other not in seen]
            seen.update(fresh)
            waiting += fresh
        return None

    def is_definition(self, equation: Equality, scope: Scope) -> bool:
        """Whether an equation determines such a variable, and is no equation for others."""
        return (id(equation), id(scope)) in self._used

    def _collect(self, equations: Sequence[Equation], scope: Scope) -> None:
        for equation in equations:
            if isinstance(equation, Equality):
                sides = (equation.left, equation.right), (equation.right, equation.left)
                for side, other in sides:
                    if self._define(side, other, scope):
                        self._used.add((id(equation), id(scope)))
                        break
            elif isinstance(equation, Connect):
                ends = [self._located(end, scope) for end in (equation.left, equation.right)]
                self._join(*ends)
            elif isinstance(equation, If):
                self._collect(self._chosen(equation, scope), scope)

    def _chosen(self, equation: If, scope: Scope) -> Sequence[Equation]:
        """The branch of an if-equation that a constant condition chooses; none where it may change."""
        for condition, body in equation.branches:
            try:
                holds = condition is None or self._evaluator.instantiator.constants.evaluate(
                    condition, scope
                )
            except ModelError:
                return ()
            if holds is True:
                return body
            if holds is not False:
                return ()
        return ()

    def _define(self, side: Expression, other: Expression, scope: Scope) -> bool:
        instance = self._located(side, scope) if isinstance(side, Reference) else None
        if not isinstance(instance, Instance) or not _is_discrete(instance):
            return False
        if instance in self._bounds or instance.binding is not None:
            return False
        self._bounds[instance] = Bound(other, scope)
        return True

    def _located(self, reference: Reference, scope: Scope) -> object:
        try:
            target = self._evaluator.locate(reference, scope)
        except ModelError:
            return None
        expand = self._evaluator.instantiator.expand
        return expand(target) if isinstance(target, Instance) else target

    def _join(self, a: object, b: object) -> None:
        if isinstance(a, Instance) and a.elements is not None:
            a = a.elements
        if isinstance(b, Instance) and b.elements is not None:
            b = b.elements
        if isinstance(a, list) and isinstance(b, list):
            for first, second in zip(a, b, strict=False):
                self._join(first, second)
        elif isinstance(a, Instance) and isinstance(b, Instance):
            if a.primitive and b.primitive:
                if _is_discrete(a) and _is_discrete(b):
                    self._connected.setdefault(a, []).append(b)
                    self._connected.setdefault(b, []).append(a)
            else:
                for name in a.children.keys() & b.children.keys():
                    self._join(a.children[name].resolved(), b.children[name].resolved())


def _is_discrete(instance: Instance) -> bool:
    return instance.primitive not in ("", "Real") and not instance.variability
