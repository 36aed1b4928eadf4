"""Inputs and outputs of benches, from the class tree: of the existing benches, and of those that parts can make."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from pam_cosim.catalogue.bench_parts import (
    BenchPart,
    chosen,
    connectors,
    free_inputs,
    measured_outputs,
    rig_parts,
)
from pam_cosim.catalogue.place import benches, unit_of
from pam_cosim.compiler import ClassTree
from pam_cosim.compiler.class_info import ComponentInfo
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Variable

_LAST = 1000


@dataclass(frozen=True)
class Ports:
    """Inputs and outputs of a bench.

    Attributes:
        name: full name of its class; of parts, the names of both.
        inputs, outputs: by name; of parts, everything that an instrument could read.
        parts: pneumatics and mechanics that it would be put together from; empty: it is there.
        rank: the lower, the more usual: zero for a bench with the usual muscle, then rigs by how many values must be
            stated of their parts, then other benches.
    """

    name: str
    inputs: dict[str, Variable]
    outputs: dict[str, Variable]
    parts: tuple[str, ...] = ()
    rank: int = 0


@lru_cache(maxsize=8)
def ports(tree: ClassTree) -> tuple[Ports, ...]:
    """Those of every bench, then those of every rig of one muscle that can be put together."""
    parts = rig_parts(tree)
    usual = _kinds_of_muscle(tree, parts)
    ready = (
        Ports(
            name,
            _variables(tree, free_inputs(tree, name)),
            _variables(tree, measured_outputs(tree, name)),
            (),
            _foreign(tree, name, usual),
        )
        for name in benches(tree)
    )
    readings = {part.library: _readings(tree, parts, part.library) for part in parts}
    feeds = [part for part in parts if part.role == "pneumatics"]
    holds = [part for part in parts if part.role == "mechanics"]
    single = [part for part in holds if len(connectors(tree, part.qualified_name)) == 1]
    rigs = [
        _composed_ports(tree, feed, hold, readings[feed.library])
        for feed in feeds
        for hold in single
        if feed.library == hold.library
    ]
    return (*ready, *rigs)


def _composed_ports(
    tree: ClassTree, feed: BenchPart, hold: BenchPart, readings: dict[str, Variable]
) -> Ports:
    """Those of the bench that would be put together from two parts."""
    names = (feed.qualified_name, hold.qualified_name)
    inputs = [port for name in names for port in free_inputs(tree, name)]
    rank = 1 + len(feed.parameters) + len(hold.parameters)
    return Ports(f"{feed.name} and {hold.name}", _variables(tree, inputs), readings, names, rank)


def _readings(tree: ClassTree, parts: list[BenchPart], library: str) -> dict[str, Variable]:
    instruments = [part for part in parts if (part.role, part.library) == ("instrument", library)]
    return {
        name: v
        for part in instruments
        for name, v in _variables(tree, measured_outputs(tree, part.qualified_name)).items()
    }


def _kinds_of_muscle(tree: ClassTree, parts: list[BenchPart]) -> set[str]:
    """Classes that the usual muscle is made of."""
    try:
        muscle = chosen(parts, "muscle", None)
    except InputError:
        return set()
    return {muscle.qualified_name, *tree.bases(muscle.qualified_name)}


def _foreign(tree: ClassTree, bench: str, usual: set[str]) -> int:
    """Zero where a bench holds the usual muscle, by the class of a component."""
    kinds = {c.type for c in tree.components(bench)}
    return 0 if any(kind in kinds and not tree.classes[kind].partial for kind in usual) else _LAST


def _variables(tree: ClassTree, declared: list[ComponentInfo]) -> dict[str, Variable]:
    return {c.name: Variable(c.name, unit_of(tree, c), c.description) for c in declared}
