"""Forms of effects that the catalogue, modelica/PneumaticMuscle/Effects, has as well: the same law, written again.

One module a family.
"""

from rig.catalogue import (
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
