"""Further forms that the catalogue lacks, by a second author, who thought of the physics of rigs alone.

One module a family.
"""

from rig.seen.further import (
    creep,
    dead_volume,
    dry_friction,
    elasticity,
    end_shape,
    friction_heat,
    gas_energy,
    leak,
    moving_mass,
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
    "pressure_offset",
    "rate_friction",
    "supply_line",
    "thermocouple_lag",
    "valve_area",
    "valve_dynamics",
    "wall_heat",
]
