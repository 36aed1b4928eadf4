"""The models that a ledger is kept with: the model at hand with a hole in each of its balances."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from pam_cosim.catalogue import (
    Composition,
    EffectClass,
    compose,
    compose_on,
    origins,
    qualified,
    unknown_terms,
)
from pam_cosim.compiler import ClassTree, Ode, compile_model, read_structure

TERM = "missing"
"""What every class of a hole calls its term."""

_NAME = "Books"


@dataclass(frozen=True)
class Hole:
    """A term without a law in a compiled model.

    Attributes:
        parameter: the parameter of the model that is moved over time.
        balance: as the class of the term says.
        unit: of the term.
        meaning: the parameter's description: what is positive.
        base: full name of the partial class that declares the term, ``missing``, and leaves its equation open.
        variables: names that class declares: what a law for the term would be a function of.
    """

    parameter: str
    balance: str
    unit: str
    meaning: str
    base: str = ""
    variables: tuple[str, ...] = ()


@dataclass(frozen=True)
class Books:
    """A model with holes.

    Attributes:
        ode: the compiled model.
        holes: its terms without a law, one a balance.
        replaced: a law of the model was replaced to make place for a hole.
    """

    ode: Ode
    holes: tuple[Hole, ...]
    replaced: bool

    def hole(self, balance: str) -> Hole | None:
        """The hole in a balance; None where the model has no place for it."""
        return next((h for h in self.holes if h.balance == balance), None)


def open_books(tree: ClassTree, model: str, effects: Sequence[str] = (), *, files: Sequence[Path] = ()) -> list[Books]:
    """The model with every hole that lies beside its components; then once more for each that replaces a law.

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
    terms = unknown_terms(tree, origins(structure.parts))
    placed = [t for t in terms if compose_on(tree, structure, [*effects, t.name]) is not None]
    beside = [t for t in placed if _lies_beside(tree, model, effects, t, files)]
    found = [_books(tree, model, effects, beside, False, files)]
    for term in placed:
        if term not in beside:
            others = [t for t in beside if t.balance != term.balance]
            found.append(_books(tree, model, effects, [*others, term], True, files))
    return found


def _lies_beside(tree: ClassTree, model: str, effects: Sequence[str], term: EffectClass, files: Sequence[Path]) -> bool:
    composition = compose(tree, model, [*effects, term.name], files=files)
    assert composition is not None
    return all(p.startswith(term.component_name) for p in composition.parameters[term.name])


def _books(
    tree: ClassTree,
    model: str,
    effects: Sequence[str],
    terms: Sequence[EffectClass],
    replaced: bool,
    files: Sequence[Path],
) -> Books:
    composition = compose(tree, model, [*effects, *(t.name for t in terms)], _NAME, files=files)
    assert composition is not None
    ode = _compiled(composition, files)
    holes = []
    for term in terms:
        name = composition.parameters[term.name][0]
        variable = ode.interface.parameters[name]
        base = next(c.owner for c in tree.components(term.qualified_name) if c.name == TERM)
        own = [c.name for c in tree.classes[base].components if c.name != TERM]
        holes.append(Hole(name, term.balance, variable.unit, variable.description, base, tuple(own)))
    return Books(ode, tuple(holes), replaced)


def _compiled(composition: Composition, files: Sequence[Path]) -> Ode:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "composition.mo")
        file.write_text(composition.text, encoding="utf-8")
        return compile_model(composition.name, files=[*files, file])
