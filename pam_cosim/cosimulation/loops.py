"""Which output follows from which at one time: the order in which to read them, and algebraic loops."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from graphlib import CycleError, TopologicalSorter

from pam_cosim.cosimulation.parts import Component, Connection, CoupledFmu, Port
from pam_cosim.errors import InputError

Graph = dict[Port, set[Port]]


def feedthrough_graph(
    components: Mapping[str, Component], connections: Sequence[Connection]
) -> Graph:
    """To each variable those that it follows from at once; what samples acts later."""
    graph: Graph = {}
    for name, component in components.items():
        if isinstance(component, CoupledFmu) and component.seconds is None:
            for output, inputs in component.feedthrough.items():
                graph[Port(name, output)] = {Port(name, variable) for variable in inputs}
    for connection in connections:
        if components[connection.target.component].seconds is None:
            graph.setdefault(connection.target, set()).add(connection.source)
    return graph


def algebraic_loop(
    components: Mapping[str, Component], connections: Sequence[Connection]
) -> list[Port]:
    """The variables of a loop in which each acts at once on the next, the first one again at the end; empty: none."""
    try:
        TopologicalSorter(feedthrough_graph(components, connections)).prepare()
    except CycleError as error:
        loop: list[Port] = error.args[1]
        return loop
    return []


def torn(
    components: Mapping[str, Component], connections: Sequence[Connection]
) -> tuple[list[Connection], list[Connection]]:
    """Connections without algebraic loops, and those that were taken out for that."""
    kept, out = list(connections), []
    while loop := algebraic_loop(components, kept):
        on_loop = [c for c in kept if c.source in loop and c.target in loop]
        kept.remove(on_loop[-1])
        out.append(on_loop[-1])
    return kept, out


def evaluation_order(
    components: Mapping[str, Component],
    connections: Sequence[Connection],
    cut: Sequence[Connection] = (),
) -> list[str]:
    """Components to read, in an order in which every input is known before what follows from it.

    Only those of which an output follows at once from a connected input are in it, some more than once. There must be
    no algebraic loop but for the connections that are ``cut``.
    """
    connected = {c.target for c in (*connections, *cut)}
    graph = feedthrough_graph(components, connections)
    order: list[str] = []
    for variable in TopologicalSorter(graph).static_order():
        component = components[variable.component]
        output = isinstance(component, CoupledFmu) and variable.variable in component.feedthrough
        if not output or not graph.get(variable, set()) & connected:
            continue
        if not order or order[-1] != variable.component:
            order.append(variable.component)
    return order


def refuse_loop(components: Mapping[str, Component], connections: Sequence[Connection]) -> None:
    """Raises ``InputError`` where there is an algebraic loop; it names the loop and the ways round it."""
    loop = algebraic_loop(components, connections)
    if not loop:
        return
    names = {variable.component for variable in loop}
    silent = [name for name in sorted(names) if not getattr(components[name], "declared", True)]
    text = f"algebraic loop: {' -> '.join(map(str, loop))}: each of these acts at once on the next."
    if silent:
        text += (
            f" {', '.join(silent)} does not declare which inputs its outputs depend on, so each counts as depending on"
            " all; the loop may not be a real one."
        )
    raise InputError(
        f"{text} Solve it at every communication point (loops='iterate', --loops iterate), take one connection a step"
        " late (loops='delay', --loops delay), or put a component with dynamics into the loop, such as a filter"
    )
