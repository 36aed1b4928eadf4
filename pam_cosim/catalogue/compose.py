"""A model with effects added, as the Modelica text that a person would write.

Where an effect belongs follows from the types alone. If it extends the constraining class of a replaceable class of
the model, it is redeclared there, unless it extends a class that is both an effect and has terminals: a class that is
parallel to a component never replaces one. If it has the same terminals as a component of the model, that is,
both extend a class that declares all its connectors, it is connected in parallel, connector by connector, and the
parameters that the terminals declare are taken over. What an effect declares ``outer`` the model must declare
``inner``: an effect that depends on what a bench does not say finds no place there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType

from pam_cosim.catalogue.effects import EffectClass, effect_classes, unknown_terms
from pam_cosim.catalogue.place import is_connector, is_effect, origins, qualified, surrounds
from pam_cosim.compiler import ClassTree, Part, Slot, Structure, names, read_structure
from pam_cosim.compiler.printing import string_text
from pam_cosim.errors import InputError
from pam_cosim.model.references import is_ratio, parameter_of


@dataclass(frozen=True)
class Composition:
    """A composed model.

    Attributes:
        name: of the class.
        text: Modelica source of the class.
        parameters: for each effect, the full names of its parameters that are to be fitted.
        base: full name of the class that it extends.
        typical: ends of the range in which 95 % of all rigs have a parameter, by its full name; not known of all.
    """

    name: str
    text: str
    parameters: dict[str, tuple[str, ...]]
    base: str
    typical: Mapping[str, tuple[float, float]] = field(default_factory=dict)


@dataclass(frozen=True)
class _Component:
    """A component that is added, with the bindings that its place gives it, and values by path inside it."""

    name: str
    type: str
    description: str
    bindings: tuple[str, ...]
    values: list[tuple[str, str]] = field(default_factory=list)

    @property
    def text(self) -> str:
        modifiers = ", ".join([*self.bindings, *_nested(self.values)])
        return f"{self.type} {self.name}{f'({modifiers})' if modifiers else ''} {string_text(self.description)}"


class _Draft:
    """What has been decided of a composed model so far."""

    def __init__(self, structure: Structure, tree: ClassTree) -> None:
        self.structure, self.tree = structure, tree
        parts = {p.path for p in structure.parts if not names.parent(p.path)}
        self.names = parts | {c.name for c in tree.components(structure.model)}
        self.modifications: list[tuple[str, str]] = []
        self.components: list[_Component] = []
        self.connections: list[str] = []
        self.parameters: dict[str, tuple[str, ...]] = {}
        self.filled: set[tuple[str, str]] = set()

    def place(self, effect: EffectClass) -> bool:
        """Puts an effect where it belongs; False where it belongs nowhere."""
        if not self._surrounded(effect):
            return False
        slots = [] if self._is_parallel(effect) else self._slots(effect)
        if slots:
            for slot in slots:
                self._redeclare(effect, slot)
            return True
        hosts = self._hosts(effect)
        for host, terminals in hosts:
            self._connect(effect, host, terminals)
        return bool(hosts)

    def state(self, parameter: str, value: float) -> None:
        """Gives a parameter, by its full name, a value [its unit]."""
        component = next((c for c in self.components if c.name == names.parts(parameter)[0]), None)
        if component is None:
            self.modifications.append(_modification(parameter, value))
        else:
            component.values.append(_modification(".".join(names.parts(parameter)[1:]), value))

    def _surrounded(self, effect: EffectClass) -> bool:
        """Whether the model declares what the effect takes from its surroundings."""
        outer = [
            (c.name, c.type)
            for c in self.tree.components(effect.qualified_name)
            if "outer" in c.prefixes
        ]
        return surrounds(self.tree, self.structure.model, outer)

    def _is_parallel(self, effect: EffectClass) -> bool:
        bases = [b for b in self.tree.bases(effect.qualified_name) if self._is_effect(b)]
        return any(self._connectors(b) for b in bases)

    def _is_effect(self, name: str) -> bool:
        return is_effect([name, *self.tree.bases(name)])

    def _slots(self, effect: EffectClass) -> list[Slot]:
        bases = self.tree.bases(effect.qualified_name)
        return [
            slot
            for slot in self.structure.slots
            if slot.constraint in bases
            and (slot.path, slot.name) not in self.filled
            and not self._is_effect(slot.current)
        ]

    def _redeclare(self, effect: EffectClass, slot: Slot) -> None:
        self.filled.add((slot.path, slot.name))
        self.modifications.append(
            (slot.path, f"redeclare model {slot.name} = {effect.qualified_name}")
        )
        users = [
            p
            for p in self.structure.parts
            if names.parent(p.path) == slot.path and slot.name in map(names.last, p.bases)
        ]
        paths = [f"{p.path}.{name}" for p in users for name in effect.parameters]
        self.parameters[effect.name] = (*self.parameters.get(effect.name, ()), *paths)

    def _hosts(self, effect: EffectClass) -> list[tuple[Part, str]]:
        bases = self.tree.bases(effect.qualified_name)
        needed = self._connectors(effect.qualified_name)
        hosts = []
        for part in self.structure.parts:
            if not part.path or names.parent(part.path) or is_effect(part.bases):
                continue
            shared = [
                b for b in bases if b in part.bases and needed and needed <= self._connectors(b)
            ]
            if shared:
                hosts.append((part, shared[0]))
        return hosts

    def _connect(self, effect: EffectClass, host: Part, terminals: str) -> None:
        instance = self.parameters.get(effect.name)
        name = self._free_name(effect.component_name)
        shared = [c for c in self.tree.components(terminals) if "parameter" in c.prefixes]
        bindings = [f"{c.name}={host.path}.{c.name}" for c in shared]
        if instance:  # one effect on several hosts has one set of parameters
            bindings += [f"{names.last(full)}={full}" for full in instance]
        else:
            self.parameters[effect.name] = tuple(f"{name}.{p}" for p in effect.parameters)
        self.components.append(
            _Component(name, effect.qualified_name, effect.description, tuple(bindings))
        )
        for connector in sorted(self._connectors(terminals)):
            self.connections.append(f"connect({name}.{connector}, {host.path}.{connector})")

    def _connectors(self, name: str) -> set[str]:
        return {c.name for c in self.tree.components(name) if is_connector(self.tree, c.type)}

    def _free_name(self, wanted: str) -> str:
        name, number = wanted, 1
        while name in self.names:
            number += 1
            name = f"{wanted}{number}"
        self.names.add(name)
        return name


def _modification(parameter: str, value: float) -> tuple[str, str]:
    """Where a value is stated, and how."""
    return names.parent(parameter), f"{names.last(parameter)}={value!r}"


def compose(
    tree: ClassTree,
    model: str,
    effects: Sequence[str],
    name: str | None = None,
    *,
    files: Sequence[Path] = (),
    values: Mapping[str, float] = MappingProxyType({}),
    annotation: str = "",
) -> Composition | None:
    """The model with the named effects, in that order; None where one of them finds no place in it.

    Args:
        tree: the library and the user's files.
        model: full name of a class, a bench's name, or a ``.mo`` file.
        effects: names of effect classes, with or without their packages.
        name: of the new class; default: made from the names.
        files: the user's files.
        values: of parameters of the composed model, by full name [their units].
        annotation: of the class, as Modelica text.

    Raises:
        InputError: an unknown effect.
        ModelError: the model cannot be found or put together.
    """
    return compose_on(
        tree, read_structure(qualified(tree, model), files=files), effects, name, values, annotation
    )


def compose_on(
    tree: ClassTree,
    structure: Structure,
    effects: Sequence[str],
    name: str | None = None,
    values: Mapping[str, float] = MappingProxyType({}),
    annotation: str = "",
) -> Composition | None:
    """As :func:`compose`, on a model whose structure is known already; who tries many effects reads it once.

    A ratio of a parameter to what is stated of it (``references.ratio_to_stated``) changes nothing in the model: it is
    the data that are in question.
    """
    draft = _Draft(structure, tree)
    ratios = [name for name in effects if is_ratio(name)]
    draft.parameters |= {name: (name,) for name in ratios}
    wanted = [name for name in effects if not is_ratio(name)]
    classes = _effects_of(tree, structure, wanted)
    if classes is None or not all(draft.place(effect) for effect in classes):
        return None
    for parameter, value in values.items():
        draft.state(parameter, value)
    base = names.unquoted(names.last(structure.model))
    made = "With" * bool(wanted) + "And".join(
        names.unquoted(names.last(wanted_name)) for wanted_name in wanted
    )
    chosen = names.identifier(name or base + (made or "Alone"))
    text = _text(chosen, structure, draft, classes, ratios, annotation)
    return Composition(
        chosen, text, draft.parameters, structure.model, _typical(classes, draft.parameters)
    )


def _typical(
    classes: Sequence[EffectClass], parameters: Mapping[str, Sequence[str]]
) -> dict[str, tuple[float, float]]:
    """Typical ranges of the parameters of effects by their full names."""
    ranges = [
        (full, effect.typical.get(names.last(full)))
        for effect in classes
        for full in parameters[effect.name]
    ]
    return {full: interval for full, interval in ranges if interval is not None}


def _effects_of(
    tree: ClassTree, structure: Structure, wanted: Sequence[str]
) -> list[EffectClass] | None:
    """The classes of effects by name; None where one of them is of another library than the model.

    Raises:
        InputError: there is no such effect.
    """
    libraries_of_model, available = (
        origins(structure.parts),
        [*effect_classes(tree), *unknown_terms(tree)],
    )
    by_name = {e.name: e for e in available if e.library in libraries_of_model} | {
        e.qualified_name: e for e in available
    }
    for wanted_name in wanted:
        if wanted_name not in by_name and wanted_name not in {e.name for e in available}:
            raise InputError(f"there is no effect '{wanted_name}'; 'pam-cosim effects' lists them")
    return (
        [by_name[wanted_name] for wanted_name in wanted]
        if all(wanted_name in by_name for wanted_name in wanted)
        else None
    )


def _nested(modifications: Sequence[tuple[str, str]]) -> list[str]:
    """Modifications of the model, each component once: Modelica forbids to modify one twice (3.6, section 7.2.5)."""
    direct_texts = [text for path, text in modifications if not path]
    inner: dict[str, list[tuple[str, str]]] = {}
    for path, text in modifications:
        if path:
            head, *rest = names.parts(path)
            inner.setdefault(head, []).append((".".join(rest), text))
    return direct_texts + [f"{name}({', '.join(_nested(parts))})" for name, parts in inner.items()]


def _text(
    name: str,
    structure: Structure,
    draft: _Draft,
    effects: Sequence[EffectClass],
    ratios: Sequence[str],
    annotation: str = "",
) -> str:
    base = structure.model
    sentences = [
        *(e.description for e in effects),
        *(f"{parameter_of(r)} is not as stated" for r in ratios),
    ]
    says = f"{names.last(base)}, and: {'; '.join(sentences)}" if sentences else names.last(base)
    lines = [f"model {name} {string_text(says)}"]
    if draft.modifications:
        changes = ",\n    ".join(_nested(draft.modifications))
        lines.append(f"  extends {base}(\n    {changes});")
    else:
        lines.append(f"  extends {base};")
    lines += [f"  {component.text};" for component in draft.components]
    if draft.connections:
        lines.append("equation")
        lines += [f"  {connection};" for connection in draft.connections]
    annotations = [draft.tree.classes[base].annotations.get("experiment", ""), annotation]
    if any(annotations):
        lines.append(f"  annotation ({', '.join(filter(None, annotations))});")
    return "\n".join([*lines, f"end {name};", ""])
