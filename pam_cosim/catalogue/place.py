"""Where a library keeps what the catalogue needs: the conventions that make a Modelica package a library.

A library is a package without a parent that has the partial class ``Interfaces.Effect``, which all its effects extend.
Its models of rigs are in its package ``Benches``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from pam_cosim.compiler import ClassTree, Part, names
from pam_cosim.compiler.class_info import ComponentInfo

EFFECT = "Interfaces.Effect"
BENCHES = "Benches"


def libraries(tree: ClassTree) -> list[str]:
    """Names of the libraries, the project's own first."""
    suffix = f".{EFFECT}"
    return [name.removesuffix(suffix) for name in tree.classes if _is_effect_base(name)]


def library_of(name: str) -> str:
    """The package without a parent that a class belongs to."""
    return names.parts(name)[0]


def origins(parts: Iterable[Part]) -> set[str]:
    """The packages that a model is made from: its catalogue is that of the libraries among them."""
    return {library_of(base) for part in parts for base in part.bases}


def is_effect(bases: Iterable[str]) -> bool:
    """Whether a class is an effect, by the full names of all classes that it consists of."""
    return any(map(_is_effect_base, bases))


def _is_effect_base(name: str) -> bool:
    return ".".join(names.parts(name)[1:]) == EFFECT


def benches(tree: ClassTree) -> list[str]:
    """Full names of the benches."""
    homes = [f"{library}.{BENCHES}" for library in libraries(tree)]
    inside = [name for name in tree.classes if names.parent(name) in homes]
    return [
        name
        for name in inside
        if tree.classes[name].kind == "model" and not tree.classes[name].partial
    ]


def qualified(tree: ClassTree, model: str) -> str:
    """The full name of a class of a library: of a bench by its short name, of others from the library on.

    ``Isotonic`` and ``Examples.ButylIsotonic`` will do, and a name that a package inherits; anything else as it is.
    """
    candidates = (tree.resolve("", name) for name in possible_names(model, libraries(tree)))
    return next(filter(None, candidates), model)


def possible_names(model: str, packages: Sequence[str]) -> list[str]:
    """What a name may stand for, the likeliest first."""
    return [
        *(f"{p}.{BENCHES}.{model}" for p in packages),
        model,
        *(f"{p}.{model}" for p in packages),
    ]


def is_connector(tree: ClassTree, name: str) -> bool:
    """Whether a class is a connector of potentials and flows; a signal such as RealInput is none."""
    return (
        name in tree.classes
        and tree.classes[name].kind == "connector"
        and not is_signal(tree, name)
    )


def is_signal(tree: ClassTree, name: str) -> bool:
    """Whether a class is the connector of an input or an output, as RealInput of Modelica.Blocks is."""
    info = tree.classes.get(name)
    return (
        info is not None
        and info.kind == "connector"
        and not info.prefixes.isdisjoint(("input", "output"))
    )


def surrounds(tree: ClassTree, model: str, outer_components: Iterable[tuple[str, str]]) -> bool:
    """Whether a model declares ``inner`` what is looked for by name and type (Modelica 3.6, section 5.4)."""
    inner = {c.name: c.type for c in tree.components(model) if "inner" in c.prefixes}
    return all(
        name in inner and tree.is_subtype(inner[name], type_) for name, type_ in outer_components
    )


def unit_of(tree: ClassTree, component: ComponentInfo) -> str:
    """The unit of a component, by its declaration or its type; "" for a plain number."""
    modifications, kind = component.modifications, component.type
    while "unit" not in modifications:
        if kind not in tree.classes or not tree.classes[kind].extends:
            return ""
        base = tree.classes[kind].extends[0]
        modifications, kind = base.modifications, base.name
    return modifications["unit"].strip('"')
