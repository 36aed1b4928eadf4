"""Forms of effects that nobody who works on the diagnosis has looked at. Empty between two scores.

What belongs here: for every family one or two forms that neither the catalogue nor `rig.seen` has, and some effects in
no family, one module a family as there. They are written from physics and the literature, which the docstrings cite,
without sight of the code of the diagnosis, of its results on other forms, and of the classes in
`modelica/PneumaticMuscle/Effects`.

How a score is prepared:

1. Whoever writes the forms does not work on the diagnosis; whoever works on the diagnosis does not read this package
   nor its lines of the table nor its tests until the score is published.
2. Each form gets a test by its limits and conservation laws (`tests/benchmarks/test_blind_forms.py`), never by what a
   diagnosis makes of it, and a line in `refsim/blind_cases/blind.py` for the set `score` alone.
3. `SEEDS["score"]` in `refsim/blind_cases/cases.py` gets a new value. The criteria of the diagnosis are fixed
   from then on, and the commit of both is noted with the score.
4. `python -m benchmarks.hidden_effects.score --set score` runs once, to the end. Its report is published as it is.
5. Once anyone looks at single cases, these forms are not blind any more: the modules move to `rig.seen`, the lines of
   `blind.py` to `table.py` and the set `tuning`, and this package is empty again.
"""

from rig.blind import (
    creep,
    dead_volume,
    dry_friction,
    elasticity,
    end_shape,
    friction_heat,
    gas_energy,
    leak,
    moving_mass,
    none_of_these,
    pressure_offset,
    rate_friction,
    supply_line,
    thermocouple_lag,
    valve_area,
    valve_dynamics,
    wall_heat,
)

__all__ = [
    "creep",
    "dead_volume",
    "dry_friction",
    "elasticity",
    "end_shape",
    "friction_heat",
    "gas_energy",
    "leak",
    "moving_mass",
    "none_of_these",
    "pressure_offset",
    "rate_friction",
    "supply_line",
    "thermocouple_lag",
    "valve_area",
    "valve_dynamics",
    "wall_heat",
]
