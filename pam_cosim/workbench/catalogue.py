"""Effects of the catalogue as a page shows them: with their equations and their fingerprint."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path

from pam_cosim.catalogue import (
    Composition,
    EffectClass,
    benches,
    compose,
    compose_on,
    effect_classes,
    origins,
    qualified,
)
from pam_cosim.catalogue.effect_sheet import equations, fingerprint, paragraphs, source
from pam_cosim.compiler import ClassTree, read_library, read_structure
from pam_cosim.compiler.names import last
from pam_cosim.files import identity
from pam_cosim.model.references import is_fmu, sources_of
from pam_cosim.study.fitted_model import FittedModel, compose_fitted
from pam_cosim.workbench.protocol import Json, selected


class Catalogue:
    """The library of a model, read once for as long as no file of the user changes.

    Args:
        files: further Modelica files.
    """

    def __init__(self, files: Sequence[Path]) -> None:
        self.files = tuple(files)
        self._trees: dict[tuple[object, ...], ClassTree] = {}
        self._shown: dict[tuple[object, ...], list[Json]] = {}

    def sources(self, model: str) -> tuple[Path, ...]:
        """The Modelica files that a model needs."""
        return sources_of(self.files, model)

    def _key(self, model: str) -> tuple[object, ...]:
        return tuple((str(file), identity(file)) for file in self.sources(model))

    def tree(self, model: str) -> ClassTree:
        """The library and the files of a model."""
        key = self._key(model)
        if key not in self._trees:
            self._trees = {key: read_library(files=self.sources(model))}
        return self._trees[key]

    def benches(self, model: str) -> tuple[str, ...]:
        """Names of the models to choose from."""
        return tuple(last(bench) for bench in benches(self.tree(model)))

    def composed(self, model: str, effects: Sequence[str], name: str | None = None) -> Composition:
        """A model with effects.

        Raises:
            InputError: an effect that there is not, or that finds no place in the model.
        """
        return compose(self.tree(model), model, effects, name, files=self.sources(model))

    def written(self, fitted: FittedModel, name: str, parameters: Collection[str]) -> str:
        """The Modelica text of a model with effects and values; see ``compose_fitted``."""
        sources = self.sources(fitted.model)
        return compose_fitted(self.tree(fitted.model), fitted, name, parameters, files=sources).text

    def shown(self, model: str, on: Collection[str]) -> list[Json]:
        """Every effect of the model's library, and whether it finds a place in it; none for an FMU."""
        if is_fmu(model):
            return []
        key = (model, *self._key(model))
        if key not in self._shown:
            tree = self.tree(model)
            structure = read_structure(qualified(tree, model), files=self.sources(model))
            self._shown[key] = [
                shown_effect(tree, e, compose_on(tree, structure, (e.name,)) is not None)
                for e in effect_classes(tree, origins(structure.parts))
            ]
        return [e | {"on": e["name"] in on} for e in self._shown[key]]


def shown_effect(tree: ClassTree, effect: EffectClass, fits: bool) -> Json:
    """An effect with the equations of its class, and fingerprint and source of its documentation."""
    texts = paragraphs(effect)
    return selected(
        effect,
        "name family balance description",
        equation="\n".join(equations(tree, effect)),
        fingerprint=fingerprint(texts),
        source=source(texts),
        fits=fits,
    )
