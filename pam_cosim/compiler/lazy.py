"""A mapping some of whose values are made when somebody asks for them, such as the classes in files of a package."""

from __future__ import annotations

from collections import UserDict
from collections.abc import Callable, Iterator
from typing import TypeVar

V = TypeVar("V")


class LazyDict(UserDict[str, V]):
    """Keys are known at once; whoever asks for all values has all of them made."""

    def __init__(self) -> None:
        super().__init__()
        self._waiting: dict[str, Callable[[], V]] = {}

    def later(self, name: str, make: Callable[[], V]) -> None:
        """Sets a value that ``make`` gives when it is asked for."""
        self._waiting[name] = make

    def is_waiting(self, name: str) -> bool:
        """Whether the value was not made yet."""
        return name in self._waiting

    def __missing__(self, name: str) -> V:
        if name not in self._waiting:
            raise KeyError(name)
        value = self._waiting[name]()
        self._waiting.pop(name, None)
        self.data[name] = value
        return value

    def __contains__(self, name: object) -> bool:
        return name in self.data or name in self._waiting

    def __iter__(self) -> Iterator[str]:
        return iter([*self.data, *self._waiting])

    def __len__(self) -> int:
        return len(self.data) + len(self._waiting)
