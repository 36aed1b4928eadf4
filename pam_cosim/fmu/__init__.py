"""Ode -> .fmu, and back: the interface of any FMU."""

from pam_cosim.fmu.build import build_fmu, cached_fmu
from pam_cosim.fmu.compile import PLATFORMS, CompilerError
from pam_cosim.fmu.library import build_model, build_source, description_of, source_ode
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
