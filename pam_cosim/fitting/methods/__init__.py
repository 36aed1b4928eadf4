"""The ways to fit: each module of this folder is one, with a function ``minimise`` and its name in ``METHODS``.

A method gets a ``Problem`` and returns a ``Solution``; it may use ``solve``, the descents from several starts, or go a
way of its own. The first line of its docstring is its help on the command line. Nothing else needs to know of it.
"""

from __future__ import annotations

import importlib
import pkgutil

from pam_cosim.fitting.methods.global_search import GlobalSearch
from pam_cosim.fitting.methods.solution import Method, Solution

_MODULES = {
    module.name.replace("_", "-"): importlib.import_module(f"{__name__}.{module.name}")
    for module in pkgutil.iter_modules(__path__)
}
METHODS: dict[str, Method] = {
    name: m.minimise for name, m in sorted(_MODULES.items()) if hasattr(m, "minimise")
}
"""The methods by name."""


def summary(name: str) -> str:
    """What a method does, in a line."""
    return (METHODS[name].__doc__ or "").strip().partition("\n")[0].rstrip(".")


__all__ = ["METHODS", "GlobalSearch", "Method", "Solution", "summary"]
