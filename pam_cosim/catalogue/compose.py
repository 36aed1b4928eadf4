"""A model with effects added, as the Modelica text that a person would write.

Where an effect belongs follows from the types alone. If it extends the constraining class of a replaceable class of
the model, it is redeclared there, unless it extends a class that is both an effect and has terminals: an effect that is
made to be connected in parallel never takes the place of a component. A replaceable class that passes a signal on
(``series.channel``) has place for several effects, one after the other in their order, those that limit the signal
last; other classes have place for one. If it has the same terminals as a component of the model, that is, both extend a
class that declares all its connectors, it is connected in parallel, connector by connector, and the parameters that the
terminals declare are taken over. What an effect declares ``outer`` the model must declare ``inner``: an effect that
depends on what a bench does not say finds no place there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType

from pam_cosim.catalogue.effects import (
    EffectClass,
    component_name,
    effect_classes,
    unknown_terms,
)
from pam_cosim.catalogue.place import is_connector, is_effect, origins, qualified, surrounds
from pam_cosim.catalogue.series import Channel, Law, channel, own_parameters, series_text
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
        limits: ("above", signal) of a parameter that lies above every value that the signal shows; or "below".
    """

    name: str
    text: str
    parameters: dict[str, tuple[str, ...]]
    base: str
    typical: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    limits: Mapping[str, tuple[str, str]] = field(default_factory=dict)


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


class NoPlace(InputError):
    """An effect for which a model has no place, alone or together with the others."""


class _Draft:
    """What has been decided of a composed model so far."""

    def __init__(self, structure: Structure, tree: ClassTree) -> None:
        self.structure, self.tree = structure, tree
        parts = {p.path for p in structure.parts if not names.parent(p.path)}
        self.names = parts | {c.name for c in tree.components(structure.model)}
        self.laws: dict[Slot, list[EffectClass]] = {}
        self.values: list[tuple[str, str]] = []
        self.components: list[_Component] = []
        self.connections: list[str] = []
        self.parameters: dict[str, tuple[str, ...]] = {}

    def place(self, effect: EffectClass) -> None:
        """Puts an effect where it belongs.

        Raises:
            NoPlace: it belongs nowhere, or another effect has taken its place.
        """
        self._check_surroundings(effect)
        slots = [] if self._is_parallel(effect) else self._slots(effect)
        clashes = {slot: self._clash(effect, slot) for slot in slots}
        free = [slot for slot, clash in clashes.items() if not clash]
        for slot in free:
            self._redeclare(effect, slot)
        hosts = [] if slots else self._hosts(effect)
        for host, terminals in hosts:
            self._connect(effect, host, terminals)
        if not free and not hosts:
            raise NoPlace(next(iter(clashes.values()), "") or self._says_no_place(effect))

    def state(self, parameter: str, value: float) -> None:
        """Gives a parameter, by its full name, a value [its unit]."""
        component = next((c for c in self.components if c.name == names.parts(parameter)[0]), None)
        if parameter in self.names:  # of the model itself; a flat one has dots in its names
            self.values.append(("", f"{names.identifier(parameter)}={value!r}"))
        elif component is None:
            self.values.append(_modification(parameter, value))
        else:
            component.values.append(_modification(".".join(names.parts(parameter)[1:]), value))

    def _check_surroundings(self, effect: EffectClass) -> None:
        """Raises NoPlace unless the model declares what the effect takes from its surroundings."""
        outer = [
            (c.name, c.type)
            for c in self.tree.components(effect.qualified_name)
            if "outer" in c.prefixes
        ]
        if not surrounds(self.tree, self.structure.model, outer):
            raise NoPlace(self._says_no_place(effect))

    def _says_no_place(self, effect: EffectClass) -> str:
        benches = f"'pam-cosim effects {effect.name}' lists the benches that have one"
        return f"{self.structure.model} has no place for {effect.name}; {benches}"

    def _is_parallel(self, effect: EffectClass) -> bool:
        bases = [b for b in self.tree.bases(effect.qualified_name) if self._is_effect(b)]
        return any(self._connectors(b) for b in bases)

    def _is_effect(self, name: str) -> bool:
        return is_effect([name, *self.tree.bases(name)])

    def _slots(self, effect: EffectClass) -> list[Slot]:
        bases = self.tree.bases(effect.qualified_name)
        return [slot for slot in self.structure.slots if slot.constraint in bases]

    def _clash(self, effect: EffectClass, slot: Slot) -> str:
        """Why an effect cannot be added to the effects in a slot; empty if it can."""
        way = channel(self.tree, slot.constraint)
        place = f"{slot.path}.{slot.name}".lstrip(".")
        for law in self._kept(slot, way):
            other = names.last(law)
            if way is None:
                return f"{other} and {effect.name} are two laws of one place, {place}: leave out one of them"
            shared = self._parameters(law, way) & self._parameters(effect.qualified_name, way)
            if shared:
                shared_text = f"both have a parameter {min(shared)}"
                return f"{other} and {effect.name} {shared_text} in {place}: leave out one of them"
        return ""

    def _kept(self, slot: Slot, way: Channel | None) -> list[str]:
        """The classes that stand in a slot and are not replaced."""
        stays = self._is_effect(slot.current) or (way is not None and slot.current != slot.default)
        effects = sorted(self.laws.get(slot, ()), key=lambda effect: bool(effect.limits))
        return [slot.current] * stays + [effect.qualified_name for effect in effects]

    def _parameters(self, law: str, way: Channel) -> set[str]:
        return {c.name for c in own_parameters(self.tree, law, way)}

    def _redeclare(self, effect: EffectClass, slot: Slot) -> None:
        self.laws.setdefault(slot, []).append(effect)
        users = [
            p
            for p in self.structure.parts
            if names.parent(p.path) == slot.path and slot.name in map(names.last, p.bases)
        ]
        paths = [f"{p.path}.{name}" for p in users for name in effect.parameters]
        self.parameters[effect.name] = (*self.parameters.get(effect.name, ()), *paths)

    def redeclared(self) -> tuple[list[str], list[tuple[str, str]]]:
        """The text of the classes in which laws stand in series, and where which class is redeclared."""
        lines: list[str] = []
        modifications = []
        series_names: dict[tuple[str, ...], str] = {}
        for slot in self.laws:
            way = channel(self.tree, slot.constraint)
            laws = tuple(self._kept(slot, way))
            if len(laws) > 1 and laws not in series_names:
                assert way is not None, laws
                series_names[laws] = self._free_name(f"{slot.name}InSeries")
                lines += series_text(self.tree, series_names[laws], way, list(map(self._law, laws)))
            name = series_names.get(laws, laws[-1])
            modifications.append((slot.path, f"redeclare model {slot.name} = {name}"))
        return lines, modifications

    def _law(self, name: str) -> Law:
        info, short = self.tree.classes[name], names.last(name)
        stated = info.annotations.get("defaultComponentName", "")
        model = self.structure.model
        inherited = names.parent(name) in (model, *self.tree.bases(model))
        written = short if inherited else name
        return Law(name, written, component_name(short, stated), info.description)

    def _hosts(self, effect: EffectClass) -> list[tuple[Part, str]]:
        bases = self.tree.bases(effect.qualified_name)
        connectors = self._connectors(effect.qualified_name)
        hosts = []
        for part in self.structure.parts:
            if not part.path or names.parent(part.path) or is_effect(part.bases):
                continue
            shared = [
                b
                for b in bases
                if b in part.bases and connectors and connectors <= self._connectors(b)
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

    def _free_name(self, stem: str) -> str:
        name, number = stem, 1
        while name in self.names or self.tree.resolve(self.structure.model, name):
            number += 1
            name = names.identifier(f"{names.unquoted(stem)}{number}")
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
) -> Composition:
    """The model with the named effects, in that order.

    Args:
        tree: the library and the user's files.
        model: full name of a class, a bench's name, or a ``.mo`` file.
        effects: names of effect classes, with or without their packages.
        name: of the new class; default: made from the names.
        files: the user's files.
        values: of parameters of the composed model, by full name [their units].
        annotation: of the class, as Modelica text.

    Raises:
        InputError: an unknown effect; NoPlace: one of them finds no place, or two exclude each other.
        ModelError: the model cannot be found or put together.
    """
    structure = read_structure(qualified(tree, model), files=files)
    return _composed(tree, structure, effects, name, values, annotation)


def compose_on(
    tree: ClassTree,
    structure: Structure,
    effects: Sequence[str],
    name: str | None = None,
    values: Mapping[str, float] = MappingProxyType({}),
    annotation: str = "",
) -> Composition | None:
    """As :func:`compose`, on a model whose structure is known already; None where an effect finds no place.

    A ratio of a parameter to what is stated of it (``references.ratio_to_stated``) changes nothing in the model: it is
    the data that are in question.
    """
    try:
        return _composed(tree, structure, effects, name, values, annotation)
    except NoPlace:
        return None


def _composed(
    tree: ClassTree,
    structure: Structure,
    effects: Sequence[str],
    name: str | None,
    values: Mapping[str, float],
    annotation: str,
) -> Composition:
    draft = _Draft(structure, tree)
    ratios = [name for name in effects if is_ratio(name)]
    draft.parameters |= {name: (name,) for name in ratios}
    effect_names = [name for name in effects if not is_ratio(name)]
    classes = _effects_of(tree, structure, effect_names)
    for effect in classes:
        draft.place(effect)
    for parameter, value in values.items():
        draft.state(parameter, value)
    base = names.unquoted(names.last(structure.model))
    effects_text = "With" * bool(effect_names) + "And".join(
        names.unquoted(names.last(n)) for n in effect_names
    )
    chosen = names.identifier(name or base + (effects_text or "Alone"))
    text = _text(chosen, structure, draft, classes, ratios, annotation)
    parameters_of_effect = {
        full: (effect, names.last(full))
        for effect in classes
        for full in draft.parameters[effect.name]
    }
    return Composition(
        chosen,
        text,
        draft.parameters,
        structure.model,
        {
            full: e.typical[name]
            for full, (e, name) in parameters_of_effect.items()
            if name in e.typical
        },
        {
            full: e.limits[name]
            for full, (e, name) in parameters_of_effect.items()
            if name in e.limits
        },
    )


def _effects_of(
    tree: ClassTree, structure: Structure, effect_names: Sequence[str]
) -> list[EffectClass]:
    """The classes of effects by name.

    Raises:
        InputError: there is no such effect; NoPlace: it is of another library than the model.
    """
    library_origins, classes = (
        origins(structure.parts),
        [*effect_classes(tree), *unknown_terms(tree)],
    )
    classes_by_name = {e.name: e for e in classes if e.library in library_origins} | {
        e.qualified_name: e for e in classes
    }
    for name in effect_names:
        if name not in classes_by_name and name not in {e.name for e in classes}:
            raise InputError(f"there is no effect '{name}'; 'pam-cosim effects' lists them")
        if name not in classes_by_name:
            raise NoPlace(f"{name} is an effect of another library than {structure.model}")
    return [classes_by_name[name] for name in effect_names]


def _nested(modifications: Sequence[tuple[str, str]]) -> list[str]:
    """Modifications of the model, each component once: Modelica forbids to modify one twice (3.6, section 7.2.5)."""
    direct_texts = [text for path, text in modifications if not path]
    inner: dict[str, list[tuple[str, str]]] = {}
    for path, text in modifications:
        if path:
            head, *inner_path = names.parts(path)
            inner.setdefault(head, []).append((".".join(inner_path), text))
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
    classes, redeclared = draft.redeclared()
    modifications = redeclared + draft.values
    if modifications:
        changes = ",\n    ".join(_nested(modifications))
        lines.append(f"  extends {base}(\n    {changes});")
    else:
        lines.append(f"  extends {base};")
    lines += [f"  {line}" for line in classes]
    lines += [f"  {component.text};" for component in draft.components]
    if draft.connections:
        lines.append("equation")
        lines += [f"  {connection};" for connection in draft.connections]
    annotations = [draft.tree.classes[base].annotations.get("experiment", ""), annotation]
    if any(annotations):
        lines.append(f"  annotation ({', '.join(filter(None, annotations))});")
    return "\n".join([*lines, f"end {name};", ""])
