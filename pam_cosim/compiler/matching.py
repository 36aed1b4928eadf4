"""Matching of equations and variables in a bipartite graph."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from typing import TypeVar

V = TypeVar("V", bound=Hashable)


class Matching(dict[V, int]):
    """The equation that each variable is assigned to.

    Attributes:
        seen_equations, seen_variables: what the last search has reached, in order.
    """

    def __init__(self) -> None:
        super().__init__()
        self.seen_equations: list[int] = []
        self.seen_variables: list[V] = []

    def add(self, start: int, candidates: Callable[[int], Sequence[V]]) -> bool:
        """Assign a variable to one more equation, reassigning others along an augmenting path.

        Returns:
            Whether there is such a path; if not, nothing has changed.
        """
        seen: set[V] = set()
        self.seen_equations, self.seen_variables = [], []
        path: list[tuple[int, Iterable[V]]] = []
        chosen: list[V] = []
        entering: int | None = start
        while entering is not None or path:
            if entering is not None:
                self.seen_equations.append(entering)
                options = candidates(entering)
                free = next((name for name in options if name not in self), None)
                if free is not None:
                    self._reassign([equation for equation, _ in path] + [entering], [*chosen, free])
                    return True
                path.append((entering, iter(options)))
                entering = None
            name = next((name for name in path[-1][1] if name not in seen), None)
            if name is None:
                path.pop()
                if chosen:
                    chosen.pop()
                continue
            seen.add(name)
            self.seen_variables.append(name)
            chosen.append(name)
            entering = self[name]
        return False

    def _reassign(self, equations: Sequence[int], names: Sequence[V]) -> None:
        for equation, name in zip(equations, names, strict=True):
            self[name] = equation
