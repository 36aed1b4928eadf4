"""Random members of families of effects: not forms of a list, but laws drawn from the places where a cause can act.

``draw`` gives one member of a family; ``PLACES`` lists the places of each.
"""

from rig.family_members.draw import FAMILIES, PLACES, draw

__all__ = ["FAMILIES", "PLACES", "draw"]
