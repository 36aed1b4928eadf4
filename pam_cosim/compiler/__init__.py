"""The compiler: Modelica source to an explicit ODE, and the class tree of a library. It knows no library.

The way of a model through the files: ``source``, ``lexer``, ``parser`` (with ``expression_parser`` and
``equation_parser``) make the tree of ``syntax``; ``library`` holds all classes, ``lookup`` finds them by name;
``instantiation`` makes the tree of components (``instance``) under ``modification``; ``evaluation`` (with
``arithmetic``, ``builtins``, ``functions``, ``assertions``) turns expressions into values, ``symbols`` into CasADi
symbols; ``flattening`` and ``connections`` give residual equations; ``index_reduction`` and ``blocks`` (with
``matching``) solve them; ``delays`` finds the inputs that ``delay`` asks for; ``initialization`` solves at the start,
and ``start`` keeps the parameters that it determines; ``compile`` puts the ``Ode`` together.
``class_tree`` and ``structure`` state what classes and models consist of.

Modelica 3.6 without events: ``when``, discrete variables, ``stream`` and ``expandable`` connectors, external
functions, operator records, matrix brackets, nonlinear algebraic loops and the ``delay`` of anything but inputs
are refused with an error. An ``assert`` that does not hold ends a run of the FMU, or warns.
"""

from pam_cosim.compiler.budget import few_collections
from pam_cosim.compiler.class_tree import ClassTree, read_library
from pam_cosim.compiler.compile import compile_model
from pam_cosim.compiler.elementwise import elementwise
from pam_cosim.compiler.hashing import flat_hash, library_hash
from pam_cosim.compiler.ode import Delay, Ode
from pam_cosim.compiler.part import Part
from pam_cosim.compiler.saved import ode_bytes, read_ode
from pam_cosim.compiler.sensitivities import smooth_parameters, with_sensitivities
from pam_cosim.compiler.structure import Slot, Structure, read_structure

__all__ = [
    "ClassTree",
    "Delay",
    "Ode",
    "Part",
    "Slot",
    "Structure",
    "compile_model",
    "elementwise",
    "few_collections",
    "flat_hash",
    "library_hash",
    "ode_bytes",
    "read_library",
    "read_ode",
    "read_structure",
    "smooth_parameters",
    "with_sensitivities",
]
