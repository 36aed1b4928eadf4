"""The compiler: Modelica source to an explicit ODE, and the class tree of the library."""

from pam_cosim.compiler.catalogue import ClassTree, read_library
from pam_cosim.compiler.compile import compile_model
from pam_cosim.compiler.hashing import flat_hash
from pam_cosim.compiler.ode import Ode
from pam_cosim.compiler.structure import Structure, read_structure

__all__ = ["ClassTree", "Ode", "Structure", "compile_model", "flat_hash", "read_library", "read_structure"]
