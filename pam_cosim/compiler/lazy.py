"""A mapping some of whose values are computed on demand, such as the classes in files of a package."""

from __future__ import annotations

from collections import UserDict
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

V = TypeVar("V")


@dataclass(frozen=True)
class _Later:
    make: Callable[[], Any]


class LazyDict(UserDict[str, V]):
    """Keys are known at once, in their order; a request for all values computes all of them."""

    def later(self, name: str, make: Callable[[], V]) -> None:
        """Sets a value that ``make`` computes on demand."""
        self.data[name] = _Later(make)  # type: ignore[assignment]

    def is_waiting(self, name: str) -> bool:
        """Whether the value was not made yet."""
        return isinstance(self.data.get(name), _Later)

    def __getitem__(self, name: str) -> V:
        value = self.data[name]
        if isinstance(value, _Later):
            value = self.data[name] = value.make()
        return value
