"""The model of a data set some of whose inputs were not measured themselves, as a file in the cache."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from pam_cosim.cache import cached_folder, digest
from pam_cosim.catalogue import qualified, with_input_maps
from pam_cosim.compiler import read_library, read_structure
from pam_cosim.model.input_map import InputMap
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import sources_of
from pam_cosim.study.fitted_model import with_base


def mapped_model(
    model: str, interface: Interface, maps: Sequence[InputMap], files: Sequence[Path] = ()
) -> str:
    """The file of the class that extends a model and binds its inputs; its text is self-contained.

    Args:
        model: a bench, a Modelica class or a ``.mo`` file; ``interface`` of it.
        maps: of its inputs.
        files: the user's files.

    Raises:
        ModelError: the model cannot be found.
        InputError: the cache cannot be written.
    """
    sources = sources_of(files, model)
    tree = read_library(files=sources)
    base = read_structure(qualified(tree, model), files=sources).model
    composition = with_input_maps(tree, base, interface, maps)
    text, file = with_base(composition, model).encode(), f"{composition.name}.mo"
    return str(cached_folder("maps", digest(text), lambda: {file: text}) / file)
