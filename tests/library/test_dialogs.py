"""What a graphical tool shows of the library: groups of parameters, choices, where the surroundings belong."""

from __future__ import annotations

from pam_cosim.compiler.library import Library
from pam_cosim.compiler.syntax import Literal, Modification
from pam_cosim.resources import modelica_root

LIBRARY = Library(modelica_root())
CLASSES = list(LIBRARY.walk())


def value(modification: Modification, *path: str) -> object:
    """What stands at a place of an annotation."""
    for name in path:
        argument = modification.argument(name)
        if argument is None:
            return None
        modification = argument.modification
    return modification.value.value if isinstance(modification.value, Literal) else None


def test_every_replaceable_model_offers_what_fits() -> None:
    replaceable = [n for n in CLASSES if "replaceable" in n.prefixes]
    assert len(replaceable) > 30
    silent = [
        n.qualified_name
        for n in replaceable
        if value(n.annotation, "choicesAllMatching") is not True
    ]
    assert silent == []
