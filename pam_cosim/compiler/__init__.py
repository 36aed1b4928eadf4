"""The compiler: Modelica source to an explicit ODE, and the class tree of the library."""

from pam_cosim.compiler.catalogue import ClassTree, read_library
from pam_cosim.compiler.compile import compile_model
from pam_cosim.compiler.compose import Composition, compose, qualified
from pam_cosim.compiler.effects import EffectClass, effect_classes
from pam_cosim.compiler.hashing import flat_hash
from pam_cosim.compiler.ode import Ode
from pam_cosim.compiler.structure import Structure, read_structure

__all__ = [
    "ClassTree",
    "Composition",
    "EffectClass",
    "Ode",
    "Structure",
    "compile_model",
    "compose",
    "effect_classes",
    "flat_hash",
    "qualified",
    "read_library",
    "read_structure",
]
