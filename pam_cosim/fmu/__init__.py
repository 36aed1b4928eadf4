"""Ode -> .fmu, and back: the interface of any FMU.

What builds an FMU is loaded when it is requested: a run of an FMU needs no compiler.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pam_cosim.fmu.build import build_fmu, cached_fmu
    from pam_cosim.fmu.compile import CompilerError
    from pam_cosim.fmu.library import build_model, build_source, description_of, source_ode
    from pam_cosim.fmu.platforms import PLATFORMS
    from pam_cosim.fmu.read import read_interface

__all__ = [
    "PLATFORMS",
    "CompilerError",
    "build_fmu",
    "build_model",
    "build_source",
    "cached_fmu",
    "description_of",
    "read_interface",
    "source_ode",
]

if not TYPE_CHECKING:
    _ROOMS = ("read", "platforms", "compile", "build", "library")

    def __getattr__(name: str) -> object:
        if name in __all__:
            for room in _ROOMS:
                module = import_module(f"{__name__}.{room}")
                if hasattr(module, name):
                    return getattr(module, name)
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
