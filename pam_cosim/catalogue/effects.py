"""The catalogue of effects: every class of the library and the user's files that extends the base class of effects."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path

from pam_cosim.catalogue.place import EFFECT, is_effect, libraries
from pam_cosim.compiler import ClassTree, Part, names
from pam_cosim.compiler.class_info import ComponentInfo
from pam_cosim.errors import ModelError
from pam_cosim.wording import Printed

_TYPICAL = "typical"
_AT_BOUNDS = ("at_min", "at_max")
_LIMITS = ("above", "below")
UNKNOWN = "unknown"  # the family of unknown inputs, which are no hypotheses


@dataclass(frozen=True)
class EffectClass(Printed):
    """One effect, as its Modelica class declares it.

    Attributes:
        name: the class's own name; ``qualified_name`` with its packages.
        family, balance: as constants of the class.
        description: one line.
        documentation: HTML.
        parameters: its own public parameters that have both a minimum and a maximum: those that a diagnosis fits.
        component_name: name that its instance takes.
        file: where it is written.
        general: it contains the other forms of its family as special cases, and is tried where these leave structure.
        library: the package whose effect it is.
        absent: values of its parameters at which it vanishes; empty where there are none.
        typical: ends of the range in which 95 % of all rigs have a parameter, of those whose class states it.
        simpler: effect of the same library that is left at the minimum and at the maximum of a parameter; "": none is
            left, None: the law stays as it is. Only parameters with such a bound.
        limits: ("above", signal) of a parameter that lies above every value that the signal shows; or "below".
    """

    name: str
    qualified_name: str
    family: str
    balance: str
    description: str
    documentation: str
    parameters: tuple[str, ...]
    component_name: str
    file: Path
    general: bool = False
    library: str = ""
    absent: Mapping[str, float] = field(default_factory=dict)
    typical: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    simpler: Mapping[str, tuple[str | None, str | None]] = field(default_factory=dict)
    limits: Mapping[str, tuple[str, str]] = field(default_factory=dict)

    def __str__(self) -> str:
        return f"{self.name} ({self.family}, {self.balance} balance): {self.description}"


def effect_classes(tree: ClassTree, of: Collection[str] | None = None) -> list[EffectClass]:
    """Every effect that is not partial, by library, family and name; those of the libraries ``of`` alone if given.

    Raises:
        ModelError: an effect lacks its family or balance, or two of a library have the same name.
    """
    return [e for e in _declared(tree) if e.family != UNKNOWN and (of is None or e.library in of)]


def unknown_terms(tree: ClassTree, of: Collection[str] | None = None) -> list[EffectClass]:
    """Every unknown input: a class that attaches as an effect does, of the family "unknown".

    Raises:
        ModelError: as for ``effect_classes``.
    """
    return [e for e in _declared(tree) if e.family == UNKNOWN and (of is None or e.library in of)]


@lru_cache(maxsize=8)
def _declared(tree: ClassTree) -> tuple[EffectClass, ...]:
    return tuple(effect for library in libraries(tree) for effect in _of_library(tree, library))


def _of_library(tree: ClassTree, library: str) -> list[EffectClass]:
    declared: dict[str, EffectClass] = {}
    for name in tree.subtypes(f"{library}.{EFFECT}"):
        if tree.classes[name].partial:
            continue
        effect = _effect(tree, name, library)
        if effect.name in declared:
            raise ModelError(f"there are two effects named {effect.name}", effect.file)
        declared[effect.name] = effect
    for effect in declared.values():
        _check_simpler(tree, effect, declared.keys())
    return sorted(declared.values(), key=lambda e: (e.family, e.name))


def effects_in(parts: Sequence[Part]) -> list[tuple[str, str]]:
    """Name and class of every component that is an effect."""
    return [(part.path, part.type) for part in parts if is_effect(part.bases)]


def _is_open(component: ComponentInfo) -> bool:
    """Whether it is a parameter that can be set, with bounds."""
    prefixes = component.prefixes
    can_be_set = "parameter" in prefixes and not prefixes & {"protected", "final"}
    return can_be_set and {"min", "max"} <= component.modifications.keys()


def _effect(tree: ClassTree, name: str, library: str) -> EffectClass:
    info = tree.classes[name]
    short = names.last(name)
    sayings = {}
    for saying in ("family", "balance"):
        value = tree.constant(name, saying)
        if not isinstance(value, str) or not value:
            raise ModelError(
                f'effect {short} must state its {saying}: extends ...({saying}="...")',
                info.file,
                info.line,
            )
        sayings[saying] = value
    declared = [c for c in tree.components(name) if is_effect([c.owner, *tree.bases(c.owner)])]
    open_parameters = [c for c in declared if _is_open(c)]
    absent = _absent(str(tree.constant(name, "absent") or ""), info.file, info.line)
    simpler = {c.name: _simpler(c, absent, info.file) for c in open_parameters}
    return EffectClass(
        name=short,
        qualified_name=name,
        family=sayings["family"],
        balance=sayings["balance"],
        description=info.description,
        documentation=info.documentation,
        parameters=tuple(c.name for c in open_parameters),
        component_name=component_name(short, info.annotations.get("defaultComponentName", "")),
        file=Path(info.file),
        general=bool(tree.constant(name, "general")),
        library=library,
        absent=absent,
        typical={
            c.name: _typical(c, info.file) for c in open_parameters if _TYPICAL in c.own_annotation
        },
        simpler={name: bounds for name, bounds in simpler.items() if bounds != (None, None)},
        limits={
            c.name: (side, _text_entry(c, side, "a signal", info.file))
            for c in open_parameters
            for side in _LIMITS
            if side in c.own_annotation
        },
    )


def _simpler(
    parameter: ComponentInfo, absent: Mapping[str, float], file: Path | str
) -> tuple[str | None, str | None]:
    """What is left at the ends of a parameter: as annotated, or nothing where the effect is absent by it alone."""
    alone = {str(value) for value in absent.values() if absent.keys() == {parameter.name}}

    def left(at_bound: str) -> str | None:
        if at_bound in parameter.own_annotation:
            return _text_entry(parameter, at_bound, "an effect", file)
        bound = parameter.modifications[at_bound.removeprefix("at_")]
        return "" if _as_number(bound) in alone else None

    at_min, at_max = map(left, _AT_BOUNDS)
    return at_min, at_max


def _as_number(text: str) -> str:
    """A number in one spelling; what is no number as it is written."""
    try:
        return str(float(text))
    except ValueError:
        return text


def _text_entry(parameter: ComponentInfo, entry: str, kind: str, file: Path | str) -> str:
    """A text in the annotation of a parameter such as ``__PamCosim(at_max="LinearBladder")``."""
    text = parameter.own_annotation[entry]
    if not isinstance(text, str):
        raise ModelError(
            f"{entry} of {parameter.name} must be the name of {kind} in quotes",
            file,
            parameter.line,
        )
    return text


def _check_simpler(tree: ClassTree, effect: EffectClass, effect_names: Collection[str]) -> None:
    """Raises ModelError where a parameter names a simpler effect that the library has not."""
    for parameter in tree.components(effect.qualified_name):
        for bound, simpler_effect in zip(
            _AT_BOUNDS, effect.simpler.get(parameter.name, ()), strict=False
        ):
            if simpler_effect and simpler_effect not in effect_names:
                says = f"{bound} of {parameter.name} names {simpler_effect}, which is no effect of {effect.library}"
                raise ModelError(says, effect.file, parameter.line)


def _typical(parameter: ComponentInfo, file: Path | str) -> tuple[float, float]:
    """The typical range of a parameter, from its annotation such as ``__PamCosim(typical={0.95, 1.05})``."""
    numbers = parameter.own_annotation[_TYPICAL]
    if isinstance(numbers, str) or len(numbers) != 2 or not numbers[0] < numbers[1]:
        form = "two numbers in braces, the smaller one first"
        raise ModelError(f"{_TYPICAL} of {parameter.name} must be {form}", file, parameter.line)
    return numbers[0], numbers[1]


def _absent(text: str, file: Path | str, line: int) -> dict[str, float]:
    """Values by name, from a text such as "k=0, tau=1e-4"."""
    values = {}
    for part in filter(None, (part.strip() for part in text.split(","))):
        name, _, value = part.partition("=")
        try:
            values[name.strip()] = float(value)
        except ValueError:
            raise ModelError(
                f"absent needs parameters with numbers, such as k=0, not {part!r}", file, line
            ) from None
    return values


def component_name(short: str, annotation: str) -> str:
    """The name that an instance of a class takes: by its annotation ``defaultComponentName``, or its own."""
    stated = annotation.partition("=")[2].strip().strip('"')
    return stated or short[0].lower() + short[1:]
