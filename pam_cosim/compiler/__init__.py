"""The compiler: Modelica source to an explicit ODE, and the class tree of the library."""

from pam_cosim.compiler.compile import compile_model
from pam_cosim.compiler.hashing import flat_hash
from pam_cosim.compiler.ode import Ode

__all__ = ["Ode", "compile_model", "flat_hash"]
