"""A parameter that a fit may move."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, log

from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import InputError
from pam_cosim.interface import Interface, Variable
from pam_cosim.measurement import DataSet


@dataclass(frozen=True)
class Free:
    """A bounded parameter and the coordinate z in which it is searched.

    z is ln(value) where the bounds are positive and far apart, otherwise value/scale: a step of 1e-3 in z is a
    small but visible change of the parameter.

    Attributes:
        name: the parameter of the model.
        low, high: bounds [unit].
        start: first guess [unit].
        unit: SI unit.
        nominal: typical size [unit]; None: the distance of the bounds.
    """

    name: str
    low: float
    high: float
    start: float
    unit: str = ""
    nominal: float | None = None

    @property
    def logarithmic(self) -> bool:
        """Whether it is searched by order of magnitude."""
        return self.low > 0 and self.high / self.low >= CRITERIA.fit.log_ratio

    @property
    def _scale(self) -> float:
        return self.nominal or (self.high - self.low)

    def to_z(self, value: float) -> float:
        """Value to search coordinate."""
        return log(value) if self.logarithmic else value / self._scale

    def to_value(self, z: float) -> float:
        """Search coordinate to value, never beyond the bounds."""
        value = exp(z) if self.logarithmic else z * self._scale
        return min(max(value, self.low), self.high)

    def slope(self, z: float) -> float:
        """Derivative of the value with respect to the search coordinate."""
        return self.to_value(z) if self.logarithmic else self._scale


def base_parameters(data: DataSet, interface: Interface) -> tuple[Free, ...]:
    """The free parameters that the data set declares, as parameters of the model with ``interface``.

    Raises:
        InputError: the model has no such parameter.
    """
    free = []
    for p in data.fit.values():
        variable = interface.parameters.get(p.name)
        if variable is None:
            raise InputError(f"{interface.model} has no parameter '{p.name}' to fit", data.folder / "experiment.toml")
        low, high = p.min, p.max
        free.append(Free(p.name, low, high, _start(p.start, variable, low, high), variable.unit))
    return tuple(free)


def _start(stated: float | None, variable: Variable, low: float, high: float) -> float:
    start = stated if stated is not None else variable.start
    return (low + high) / 2 if start is None else min(max(start, low), high)
