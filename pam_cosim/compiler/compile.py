"""A Modelica class to an explicit ODE."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from pam_cosim.compiler.assembly import Assembly
from pam_cosim.compiler.budget import bounded
from pam_cosim.compiler.builtins import BUILTINS
from pam_cosim.compiler.evaluation import Calls
from pam_cosim.compiler.flattening import flatten
from pam_cosim.compiler.functions import call
from pam_cosim.compiler.instance import Class, Instance
from pam_cosim.compiler.instantiation import Instantiator
from pam_cosim.compiler.library import Library
from pam_cosim.compiler.lookup import Lookup
from pam_cosim.compiler.ode import Ode
from pam_cosim.compiler.syntax import ClassDefinition
from pam_cosim.errors import ModelError
from pam_cosim.model.references import is_modelica
from pam_cosim.resources import modelica_root
from pam_cosim.wording import shown

_NOT_MODELS = frozenset(("package", "function", "record", "type", "connector"))


@bounded
def compile_model(model: str, *, files: Sequence[Path] = (), root: Path | None = None) -> Ode:
    """Compile a model.

    Args:
        model: full name of a class of the library or of one of ``files``, or the path of a ``.mo`` file, of
            which the last class is taken.
        files: the user's ``.mo`` files; their classes may extend those of the library.
        root: directory that holds the library's packages; by default the project's own.

    Raises:
        ModelError: the model cannot be found, read, or brought into the form of an explicit ODE.
    """
    instantiator, top = instantiate(model, files=files, root=root)
    flat = flatten(instantiator, top)
    try:
        return Assembly(flat, instantiator).ode()
    except ModelError as error:
        if error.file is None:
            definition = top.ancestors[0].definition
            message = f"{definition.qualified_name}: {error.message}"
            raise definition.source.error(message, definition.at) from None
        raise


@bounded
def instantiate(
    model: str, *, files: Sequence[Path] = (), root: Path | None = None
) -> tuple[Instantiator, Instance]:
    """The components of a model; arguments and errors as for :func:`compile_model`."""
    library, lookup = _read(model, files, root)
    instantiator = Instantiator(lookup, Calls(BUILTINS, call))
    return instantiator, instantiator.model(_find(model, library, lookup))


@bounded
def found_class(model: str, *, files: Sequence[Path] = ()) -> tuple[ClassDefinition, Library]:
    """The class of a model, and where it was found; arguments and errors as for :func:`compile_model`."""
    library, lookup = _read(model, files, None)
    return _find(model, library, lookup).definition, library


def _read(model: str, files: Sequence[Path], root: Path | None) -> tuple[Library, Lookup]:
    model_file = [Path(model)] if is_modelica(model) and Path(model) not in files else []
    library = Library(modelica_root() if root is None else root, [*files, *model_file])
    return library, Lookup(library)


def _find(model: str, library: Library, lookup: Lookup) -> Class:
    if is_modelica(model):
        classes = library.user_classes[Path(model)]
        models = [node for node in classes if node.kind in ("model", "block", "class")]
        if not models:
            raise ModelError("the file holds no model", model)
        return lookup.of(models[-1])
    of = lookup.qualified(model)
    if of is None:
        raise ModelError(f"there is no model {shown(model)}{library.similar(model, 'model')}")
    definition = of.definition
    if definition.kind in _NOT_MODELS:
        raise definition.source.error(
            f"'{model}' is a {definition.kind}, not a model", definition.at
        )
    if definition.partial:
        raise definition.source.error(
            f"'{model}' is partial: compile a model that extends it", definition.at
        )
    return of
