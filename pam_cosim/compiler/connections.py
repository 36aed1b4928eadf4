"""Connection sets: equal potentials, flows that sum to zero (Modelica 3.6, chapter 9.2)."""

from __future__ import annotations

from dataclasses import dataclass

from pam_cosim.compiler.evaluation import Environment, Evaluator
from pam_cosim.compiler.instance import Instance, Scope
from pam_cosim.compiler.names_of_references import AbsentComponent
from pam_cosim.compiler.syntax import Connect, Reference
from pam_cosim.errors import ModelError

ConnectorSide = tuple[Instance, bool]
"""A variable of a connector, and whether it is seen as an inside connector (Modelica 3.6, section 9.1.2)."""


@dataclass(eq=False, repr=False)
class ConnectionSet:
    """Variables that are connected; the flag is whether a flow counts into the set (seen from inside)."""

    members: list[ConnectorSide]

    @property
    def is_flow(self) -> bool:
        """Whether the members are flow variables."""
        return "flow" in self.members[0][0].prefixes


class Connections:
    """Collects ``connect`` equations and makes sets of them."""

    def __init__(self, evaluator: Evaluator) -> None:
        self._evaluator = evaluator
        self._parents: dict[ConnectorSide, ConnectorSide] = {}

    def add(self, equation: Connect, scope: Scope, names: Environment) -> None:
        """One ``connect(a, b)``; nothing happens if a condition has switched one of them off.

        Raises:
            ModelError: the two do not fit together.
        """
        sides = []
        for reference in (equation.left, equation.right):
            try:
                sides.append(self._connector(reference, scope, names))
            except AbsentComponent:
                return
        self._join(sides[0], sides[1], scope, equation)

    def _connector(self, reference: Reference, scope: Scope, names: Environment) -> list[Instance]:
        try:
            located = self._evaluator.locate(reference, scope, names)
            return [
                self._present(item)
                for item in (located if isinstance(located, list) else [located])
            ]
        except AbsentComponent:
            raise
        except ModelError as error:
            if error.file is not None:
                raise
            raise scope.definition.source.error(error.message, reference.at) from None

    def _present(self, item: object) -> Instance:
        if not isinstance(item, Instance):
            raise ModelError("connect() joins connectors")
        instance = self._evaluator.instantiator.expand(item)
        if not instance.present:
            raise AbsentComponent(instance.name)
        if instance.elements is None and not instance.primitive and instance.kind != "connector":
            raise ModelError(f"'{instance.name}' is a {instance.kind}, not a connector")
        return instance

    def _join(
        self, left: list[Instance], right: list[Instance], scope: Scope, equation: Connect
    ) -> None:
        source = scope.definition.source
        if len(left) == 1 and left[0].elements is not None:
            left = left[0].elements
        if len(right) == 1 and right[0].elements is not None:
            right = right[0].elements
        if len(left) != len(right):
            raise source.error("connect() of arrays of different sizes", equation.at)
        for a, b in zip(left, right, strict=True):
            if a.elements is not None or b.elements is not None:
                self._join([a], [b], scope, equation)
            elif a.primitive and b.primitive:
                if ("flow" in a.prefixes) != ("flow" in b.prefixes):
                    raise source.error(
                        f"a flow is connected with a potential: '{a.name}', '{b.name}'", equation.at
                    )
                if "stream" in a.prefixes | b.prefixes:
                    raise source.error("stream connectors are not supported", equation.at)
                self._unite((a, _is_inside(a, scope)), (b, _is_inside(b, scope)))
            else:
                self._join_members(a, b, scope, equation)

    def _join_members(self, a: Instance, b: Instance, scope: Scope, equation: Connect) -> None:
        for connector in (a, b):
            if connector.type is not None and "expandable" in connector.type.definition.prefixes:
                raise scope.definition.source.error(
                    f"'{connector.name}' is an expandable connector, which is not supported",
                    equation.at,
                )
        names = list(a.children)
        if set(names) != set(b.children):
            different = sorted(set(names) ^ set(b.children))
            raise scope.definition.source.error(
                f"'{a.name}' and '{b.name}' are connectors of different kinds: they differ in {', '.join(different)}",
                equation.at,
            )
        for name in names:
            self._join(
                [a.children[name].resolved()], [b.children[name].resolved()], scope, equation
            )

    def _root(self, side: ConnectorSide) -> ConnectorSide:
        self._parents.setdefault(side, side)
        while self._parents[side] != side:
            self._parents[side] = self._parents[self._parents[side]]
            side = self._parents[side]
        return side

    def _unite(self, a: ConnectorSide, b: ConnectorSide) -> None:
        root_a, root_b = self._root(a), self._root(b)
        if root_a != root_b:
            self._parents[root_b] = root_a

    def sets(self, root: Instance) -> list[ConnectionSet]:
        """All sets, those of unconnected flow variables (which are zero) included."""
        for node in root.nodes():
            if node.kind == "connector":
                for leaf in node.leaves():
                    if "flow" in leaf.prefixes:
                        self._root((leaf, True))
        groups: dict[ConnectorSide, list[ConnectorSide]] = {}
        for side in list(self._parents):
            groups.setdefault(self._root(side), []).append(side)
        return [ConnectionSet(members) for members in groups.values()]


def _is_inside(variable: Instance, scope: Scope) -> bool:
    """Whether a connector belongs to a component of the connecting class, rather than to that class itself."""
    top: Instance | None = variable
    while top is not None and top.parent is not None and top.parent is not scope.instance:
        top = top.parent
    return top is None or top.parent is None or top.kind != "connector"
