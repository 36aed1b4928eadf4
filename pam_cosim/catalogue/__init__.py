"""The catalogue: class tree to effects. Which effects and benches there are, where they fit, composed models.

``place`` states what makes a Modelica package a library; ``effects`` reads the annotations of its effects;
``compose`` puts them where their types say that they belong;
``bench_parts`` finds what a bench can be composed of, and ``composed_bench`` composes it;
``input_maps`` gives a model maps of its inputs;
``domain`` reads the sentences of results, and how recordings are named, in the field of the library. No effect and no
library has a name here.
"""

from pam_cosim.catalogue.bench_parts import BenchPart, rig_parts
from pam_cosim.catalogue.compose import Composition, compose, compose_on
from pam_cosim.catalogue.composed_bench import ComposedBench, compose_bench
from pam_cosim.catalogue.domain import domain_of, known_domain, vocabulary_of
from pam_cosim.catalogue.effects import EffectClass, effect_classes, effects_in, unknown_terms
from pam_cosim.catalogue.input_maps import with_input_maps
from pam_cosim.catalogue.model import full_name
from pam_cosim.catalogue.place import EFFECT, benches, library_of, origins, qualified

__all__ = [
    "EFFECT",
    "Composition",
    "EffectClass",
    "ComposedBench",
    "BenchPart",
    "benches",
    "compose",
    "compose_on",
    "domain_of",
    "effect_classes",
    "effects_in",
    "full_name",
    "known_domain",
    "library_of",
    "origins",
    "compose_bench",
    "qualified",
    "rig_parts",
    "unknown_terms",
    "vocabulary_of",
    "with_input_maps",
]
