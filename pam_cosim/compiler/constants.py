"""What the structure of a model follows from: sizes, conditions of components, Booleans and Integers."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager

from pam_cosim.compiler.evaluation import NO_NAMES, Components, Environment, Evaluator, Value
from pam_cosim.compiler.instance import Instance, Scope
from pam_cosim.compiler.syntax import Expression


class Constants(Evaluator):
    """Evaluates constants and the values that parameters have when a model is compiled.

    Attributes:
        structural: Real parameters that sizes, conditions, Booleans or Integers depend on, which are fixed with the
            structure.
    """

    def __init__(self, instantiator: Components) -> None:
        super().__init__(instantiator)
        self.structural: dict[Instance, None] = {}
        self._is_structure = False

    @contextmanager
    def _structure(self) -> Generator[None]:
        before, self._is_structure = self._is_structure, True
        try:
            yield
        finally:
            self._is_structure = before

    def integer(self, expression: Expression, scope: Scope, names: Environment = NO_NAMES) -> int:
        """A value that must be an integer constant."""
        with self._structure():
            return super().integer(expression, scope, names)

    def condition(self, expression: Expression, scope: Scope) -> bool:
        """A value that must be a Boolean constant."""
        with self._structure():
            return super().condition(expression, scope)

    def value(self, instance: Instance) -> Value:
        """The value of a variable, an array of variables (a list) or a record (the instance)."""
        instance = self.instantiator.expand(instance)
        is_new = instance.primitive == "Real" and instance not in self.structural
        if self._is_structure and is_new and instance.variability == "parameter":
            self.structural[instance] = None
            self._values.pop(instance, None)  # what it depends on is evaluated again
        return super().value(instance)

    def _find_value(self, instance: Instance) -> Value:
        if instance.primitive == "Real" or instance.variability != "parameter":
            return super()._find_value(instance)
        with self._structure():
            return super()._find_value(instance)
