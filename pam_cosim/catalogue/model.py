"""The full name of a model, without reading a library where its folders determine the name."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from pam_cosim.catalogue.place import possible_names, qualified
from pam_cosim.compiler import read_library
from pam_cosim.resources import modelica_root

_LONGEST = 200  # letters of a name that a file of the library may have


def full_name(model: str, files: Sequence[Path] = ()) -> str:
    """The name of a model with its packages, as ``qualified`` has it; a file or an unknown name as it is.

    Raises:
        ModelError: the user's files cannot be read.
    """
    if len(model) > _LONGEST or not re.fullmatch(r"\w+(\.\w+)*", model):
        return model
    root = modelica_root()
    packages = [file.parent.name for file in sorted(root.glob("*/package.mo"))]
    for name in possible_names(model, packages):
        if root.joinpath(*name.split(".")).with_suffix(".mo").is_file():
            return name
    return qualified(read_library(files=files), model)
