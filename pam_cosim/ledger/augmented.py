"""Augmented models: the model at hand with an unknown input in each of its balances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from pam_cosim.catalogue import (
    Composition,
    EffectClass,
    compose_on,
    origins,
    qualified,
    unknown_terms,
)
from pam_cosim.compiler import ClassTree, Ode, Structure, read_structure
from pam_cosim.fmu import source_ode

TERM = "missing"
"""Name of the term in every class of an unknown input."""

_CLASS = "Augmented"


@dataclass(frozen=True)
class UnknownInput:
    """An unknown input of a compiled model.

    Attributes:
        parameter: the parameter of the model that is moved over time.
        balance: as its class declares.
        unit: of the term.
        meaning: the parameter's description, with the sign convention.
        variables: names that the partial class with the open equation declares: arguments of a law for the term.
    """

    parameter: str
    balance: str
    unit: str
    meaning: str
    variables: tuple[str, ...] = ()


@dataclass(frozen=True)
class AugmentedModel:
    """A model with unknown inputs.

    Attributes:
        ode: the compiled model.
        unknown_inputs: at most one for each balance.
        replaced: a law of the model was replaced to make place for an unknown input.
    """

    ode: Ode
    unknown_inputs: tuple[UnknownInput, ...]
    replaced: bool


def augmented_models(
    tree: ClassTree, model: str, effects: Sequence[str] = (), *, files: Sequence[Path] = ()
) -> list[AugmentedModel]:
    """The model with every unknown input that replaces no law; then again for each that replaces one.

    Args:
        tree: the library and the user's files.
        model: full name of a class, a bench's name, or a ``.mo`` file.
        effects: names of effects that the model has too.
        files: the user's files.

    Raises:
        InputError: an unknown effect, or one that finds no place.
        ModelError: the model cannot be compiled.
    """
    structure = read_structure(qualified(tree, model), files=files)
    place = partial(_placed, tree, structure, effects)
    placed_terms = [(t, place([t])) for t in unknown_terms(tree, origins(structure.parts))]
    placed = [(t, composition) for t, composition in placed_terms if composition is not None]
    parallel_terms = [t for t, composition in placed if _is_parallel(t, composition)]
    models = [_augmented(tree, place(parallel_terms), parallel_terms, False, files)]
    for term, _ in placed:
        if term not in parallel_terms:
            terms = [*(t for t in parallel_terms if t.balance != term.balance), term]
            models.append(_augmented(tree, place(terms), terms, True, files))
    return models


def _placed(
    tree: ClassTree, structure: Structure, effects: Sequence[str], terms: Sequence[EffectClass]
) -> Composition | None:
    return compose_on(tree, structure, [*effects, *(t.name for t in terms)], _CLASS)


def _is_parallel(term: EffectClass, composition: Composition) -> bool:
    return all(p.startswith(term.component_name) for p in composition.parameters[term.name])


def _augmented(
    tree: ClassTree,
    composition: Composition | None,
    terms: Sequence[EffectClass],
    replaced: bool,
    files: Sequence[Path],
) -> AugmentedModel:
    assert composition is not None
    ode = source_ode(composition.name, composition.text, files)
    unknown_inputs = []
    for term in terms:
        name = composition.parameters[term.name][0]
        variable = ode.interface.parameters[name]
        base = next(c.owner for c in tree.components(term.qualified_name) if c.name == TERM)
        term_parameters = [c.name for c in tree.classes[base].components if c.name != TERM]
        unknown_inputs.append(
            UnknownInput(
                name, term.balance, variable.unit, variable.description, tuple(term_parameters)
            )
        )
    return AugmentedModel(ode, tuple(unknown_inputs), replaced)
