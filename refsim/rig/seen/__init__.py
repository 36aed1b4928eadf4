"""Forms of effects that the catalogue lacks and that were looked at while the diagnosis was made or improved.

One module a family; `none_of_these` has those in no family; `further` has those of a second author.
"""

from rig.seen import (
    creep,
    dead_volume,
    dry_friction,
    elasticity,
    end_shape,
    friction_heat,
    further,
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
    "further",
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
