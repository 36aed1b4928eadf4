"""The compiler: Modelica source to an explicit ODE, and the class tree of the library.

The way of a model through the files: ``source``, ``lexer``, ``parser`` (with ``expression_parser`` and
``equation_parser``) make the tree of ``syntax``; ``library`` holds all classes, ``scope`` finds them by name;
``instantiation`` makes the tree of components (``instance``) under ``modification``; ``evaluation`` (with
``arithmetic``, ``builtins``, ``functions``, ``assertions``) turns expressions into values, ``symbols`` into CasADi
symbols; ``flattening`` and ``connections`` give residual equations; ``index_reduction`` and ``blocks`` (with
``matching``) solve them; ``delays`` finds the inputs that ``delay`` asks for; ``initialization`` solves at the start,
and ``start`` keeps what it says of parameters; ``compile`` puts the ``Ode`` together.
``catalogue`` and ``structure`` tell what classes and models consist of; ``effects`` and ``compose`` build on them.

Modelica 3.6 without events: ``when``, discrete variables, ``stream`` and ``expandable`` connectors, external
functions, operator records, matrix brackets, nonlinear algebraic loops and the ``delay`` of anything but inputs
are refused with an error. An ``assert`` that does not hold ends a run of the FMU, or warns.
"""

from pam_cosim.compiler.catalogue import ClassTree, read_library
from pam_cosim.compiler.compile import compile_model
from pam_cosim.compiler.compose import Composition, compose, compose_on, qualified
from pam_cosim.compiler.effects import EffectClass, effect_classes, unknown_terms
from pam_cosim.compiler.elementwise import elementwise
from pam_cosim.compiler.hashing import flat_hash
from pam_cosim.compiler.ode import Delay, Ode
from pam_cosim.compiler.sensitivities import smooth_parameters, with_sensitivities
from pam_cosim.compiler.structure import Structure, read_structure

__all__ = [
    "ClassTree",
    "Composition",
    "Delay",
    "EffectClass",
    "Ode",
    "Structure",
    "compile_model",
    "compose",
    "compose_on",
    "effect_classes",
    "elementwise",
    "flat_hash",
    "qualified",
    "read_library",
    "read_structure",
    "smooth_parameters",
    "unknown_terms",
    "with_sensitivities",
]
