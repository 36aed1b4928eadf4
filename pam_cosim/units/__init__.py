"""Units: texts read, numbers converted, quantities written, all on one registry."""

from pam_cosim.units.algebra import product, quotient
from pam_cosim.units.base import BaseUnit, base_unit, same_unit
from pam_cosim.units.conversion import LARGEST, convert, examples, parse_quantity, seconds
from pam_cosim.units.display import format_quantity, readable_factor, readable_unit
from pam_cosim.units.grammar import (
    UnitError,
    is_dimensionless,
    pressure_reference,
    registry_errors,
)
from pam_cosim.units.quantities import quantity, with_unit

__all__ = [
    "LARGEST",
    "BaseUnit",
    "UnitError",
    "base_unit",
    "convert",
    "examples",
    "format_quantity",
    "is_dimensionless",
    "parse_quantity",
    "pressure_reference",
    "product",
    "quantity",
    "quotient",
    "readable_factor",
    "readable_unit",
    "registry_errors",
    "same_unit",
    "seconds",
    "with_unit",
]
