"""Laws in series where one stood: a class with one input and one output of one quantity that passes a signal on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from pam_cosim.catalogue.place import is_connector
from pam_cosim.compiler import ClassTree, names
from pam_cosim.compiler.class_info import ComponentInfo
from pam_cosim.compiler.printing import string_text


@dataclass(frozen=True)
class Channel:
    """What the laws of a channel have in common.

    Attributes:
        interface: full name of the class that each law extends.
        input, output: names of its signals.
        parameters: names of its parameters, which every law gets.
    """

    interface: str
    input: str
    output: str
    parameters: tuple[str, ...]


@dataclass(frozen=True)
class Law:
    """One law of a channel.

    Attributes:
        type: full name of its class.
        written: its name where the class in series stands.
        name: of its component.
        description: one line.
    """

    type: str
    written: str
    name: str
    description: str


def channel(tree: ClassTree, interface: str) -> Channel | None:
    """The channel that a class is; None unless it has one input and one output of one quantity and no connectors."""
    public = _public(tree, interface)
    inputs, outputs = ([c for c in public if p in c.prefixes] for p in ("input", "output"))
    if len(inputs) != 1 or len(outputs) != 1 or any(is_connector(tree, c.type) for c in public):
        return None
    source, output = inputs[0], outputs[0]
    if (
        not _quantities(tree, source) & _quantities(tree, output)
        or source.dimensions != output.dimensions
    ):
        return None
    parameters = tuple(c.name for c in public if "parameter" in c.prefixes)
    return Channel(interface, source.name, output.name, parameters)


def own_parameters(tree: ClassTree, law: str, of: Channel) -> list[ComponentInfo]:
    """The parameters of a law in addition to those of the channel."""
    return [
        c
        for c in _public(tree, law)
        if "parameter" in c.prefixes and "final" not in c.prefixes and c.name not in of.parameters
    ]


def series_text(tree: ClassTree, name: str, of: Channel, laws: Sequence[Law]) -> list[str]:
    """The lines of a class in which a signal passes one law after the other; their parameters are its own."""
    way = " -> ".join([of.input, *(law.name for law in laws), of.output])
    lines = [f"model {name} {string_text(way)}", f"  extends {of.interface};"]
    components, signal = [], of.input
    for law in laws:
        law_parameters = own_parameters(tree, law.type, of)
        lines += [f"  {_declaration(tree, law.type, c)};" for c in law_parameters]
        bindings = [f"{of.input}={signal}", *(f"{n}={n}" for n in of.parameters)]
        bindings += [f"{c.name}={c.name}" for c in law_parameters]
        components.append(
            f"  {law.written} {law.name}({', '.join(bindings)}) {string_text(law.description)};"
        )
        signal = f"{law.name}.{of.output}"
    return [*lines, *components, "equation", f"  {of.output} = {signal};", f"end {name};"]


def _public(tree: ClassTree, name: str) -> list[ComponentInfo]:
    return [c for c in tree.components(name) if "protected" not in c.prefixes]


def _quantities(tree: ClassTree, signal: ComponentInfo) -> set[str]:
    return {signal.type, *(tree.bases(signal.type) if signal.type in tree.classes else ())}


def modified(tree: ClassTree, law: str, parameter: ComponentInfo) -> dict[str, str]:
    """The modifications of a parameter, with those of the law's ``extends`` clauses; ``value`` is the binding."""
    modifications = {**parameter.modifications, "value": parameter.value}
    for heir in reversed([law, *tree.bases(law)]):
        for clause in tree.classes[heir].extends:
            for path, text in clause.modifications.items():
                first, *inner_path = names.parts(path)
                if first == parameter.name:
                    modifications[".".join(inner_path) or "value"] = text
    return modifications


def _declaration(tree: ClassTree, law: str, parameter: ComponentInfo) -> str:
    modifications = modified(tree, law, parameter)
    value = modifications.pop("value", "")
    attributes = ", ".join(f"{key}={text}" for key, text in modifications.items())
    sizes = f"[{', '.join(parameter.dimensions)}]" if parameter.dimensions else ""
    declared = f"parameter {parameter.type} {parameter.name}{sizes}"
    declared += f"({attributes})" * bool(attributes) + f" = {value}" * bool(value)
    return f"{declared} {string_text(parameter.description)}"
