"""Changes of data, made by a seeded generator: of bytes, and of JSON documents."""

from __future__ import annotations

import copy
import random
from collections.abc import Iterator
from typing import Any

VALUES: tuple[Any, ...] = (
    "", "x", "10**10**10", "\x1b[31m", "m" * 100, "../..", "__import__('os').system('touch MADE')", "<script>", "nan",
    "%s%n", [], {}, None, True, -1, 0, 1e308, float("nan"), float("inf"), 10**400, ["a"], {"array": "array_0"},
    {"array": "array_99"}, {"array": ["a"]}, "kg^99.m^99", "a99", "$(touch MADE)", "'", '"',
)  # fmt: skip
Place = tuple[Any, ...]


def places(document: Any, place: Place = ()) -> Iterator[Place]:
    """Where something stands in a document, by its keys."""
    if place:
        yield place
    inner = (
        document.items()
        if isinstance(document, dict)
        else enumerate(document)
        if isinstance(document, list)
        else ()
    )
    for key, value in inner:
        yield from places(value, (*place, key))


def changed(document: Any, place: Place, value: Any) -> Any:
    """A copy with another value in a place."""
    made = copy.deepcopy(document)
    holder = made
    for key in place[:-1]:
        holder = holder[key]
    holder[place[-1]] = value
    return made


def without(document: Any, place: Place) -> Any:
    """A copy that lacks what stands in a place."""
    made = copy.deepcopy(document)
    holder = made
    for key in place[:-1]:
        holder = holder[key]
    del holder[place[-1]]
    return made


def mutated_document(document: Any, chance: random.Random) -> Any:
    """A copy with something else, or nothing, in one place."""
    place = chance.choice(list(places(document)))
    return (
        without(document, place)
        if chance.random() < 0.2
        else changed(document, place, chance.choice(VALUES))
    )


def mutated_bytes(content: bytes, chance: random.Random) -> bytes:
    """A copy with some bytes changed, cut or doubled; the ends, where formats keep their tables, more often."""
    made = bytearray(content)
    for _ in range(chance.choice((1, 1, 2, 8))):
        size = len(made)
        at = chance.choice(
            (
                chance.randrange(size),
                chance.randrange(max(0, size - 400), size),
                chance.randrange(60) % size,
            )
        )
        match chance.randrange(6):
            case 0:
                del made[at : at + chance.choice((1, 7, size // 3))]
            case 1:
                made[at:at] = made[at : at + chance.choice((1, 40))]
            case _:
                made[at] = chance.randrange(256)
        made = made or bytearray(b"\0")
    return bytes(made)
