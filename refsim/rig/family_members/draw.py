"""A random member of a family, by name."""

from __future__ import annotations

import numpy as np

from rig.effect import Effect
from rig.family_members import forces, gas, heat, valves
from rig.family_members.chance import Place

PLACES: dict[str, dict[str, Place]] = {
    "elasticity": forces.SPRINGS,
    "dry_friction": forces.DRY,
    "rate_friction": forces.DAMPERS,
    "creep": forces.CREEP,
    "end_shape": forces.ENDS,
    "moving_mass": forces.MASSES,
    "valve_dynamics": valves.DYNAMICS,
    "valve_area": valves.AREAS,
    "supply_line": gas.LINES,
    "dead_volume": gas.DEAD,
    "leak": gas.LEAKS,
    "gas_energy": heat.GASES,
    "wall_heat": heat.WALLS,
    "friction_heat": heat.RUBBED,
    "thermocouple_lag": heat.BEADS,
    "pressure_offset": heat.GAUGES,
}
"""Places where the cause of a family can act, each with a way to draw a member that acts there."""

FAMILIES = tuple(PLACES)


def draw(family: str, number: int) -> tuple[str, Effect]:
    """The member of this number: its place, in turn through the family's places, and the effect.

    The same number gives the same member.
    """
    places = PLACES[family]
    place = list(places)[number % len(places)]
    return place, places[place](np.random.default_rng([FAMILIES.index(family), number]))
