"""A parameter that a fit may move."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import exp, log, sqrt

from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, FreeParameter, Prior, Run, Transform
from pam_cosim.measurement.free_parameter import INTERVAL
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_ratio, parameter_of
from pam_cosim.wording import did_you_mean


@dataclass(frozen=True)
class Free:
    """A bounded parameter and the coordinate z in which it is searched.

    z is ln(value) or value/scale: a step of 1e-3 in z is a small but visible change of the parameter.

    Attributes:
        name: the parameter of the model; where it is of one run alone, with "@" and the run's name after it; or the
            ratio of a parameter to what is stated of it (``references.ratio_to_stated``).
        low, high: bounds [unit].
        start: first guess [unit].
        unit: SI unit.
        nominal: typical size [unit]; None: the distance of the bounds.
        transform: "log" or "linear"; None: "log" where the bounds are positive and far apart.
        prior: what is known of the value beforehand [unit].
        run: the one run that it is of; empty: all.
    """

    name: str
    low: float
    high: float
    start: float
    unit: str = ""
    nominal: float | None = None
    transform: Transform | None = None
    prior: Prior | None = None
    run: str = ""

    @property
    def parameter(self) -> str:
        """Its name in the model."""
        return self.name.removesuffix(f"@{self.run}") if self.run else parameter_of(self.name)

    def starting_at(self, value: float) -> Free:
        """The same with another first guess [unit], as near to it as the bounds allow."""
        return replace(self, start=min(max(value, self.low), self.high))

    def with_typical_range(self, low: float, high: float) -> Free:
        """The same with a prior: 95 % of its distribution, normal as it is searched, lie between these ends [unit]."""
        width = 2 * INTERVAL
        if self.logarithmic:
            return replace(
                self, prior=Prior(sqrt(low * high), log(high / low) / width, logarithmic=True)
            )
        return replace(self, prior=Prior((low + high) / 2, (high - low) / width))

    def size_in(self, run: Run) -> float:
        """By how much the model's parameter moves in a run where this moves by one."""
        return run.parameters[self.parameter] if is_ratio(self.name) else 1.0

    @property
    def logarithmic(self) -> bool:
        """Whether it is searched by order of magnitude."""
        if self.transform is not None:
            return self.transform == "log"
        return self.low > 0 and self.high / self.low >= CRITERIA.fit.log_ratio

    @property
    def _scale(self) -> float:
        return self.nominal or (self.high - self.low)

    def to_z(self, value: float) -> float:
        """Value to search coordinate."""
        return log(value) if self.logarithmic else value / self._scale

    def to_value(self, z: float) -> float:
        """Search coordinate to value, never beyond the bounds."""
        if self.logarithmic:  # no power overflows
            return min(max(exp(min(max(z, log(self.low)), log(self.high))), self.low), self.high)
        return min(max(z * self._scale, self.low), self.high)

    def slope(self, z: float) -> float:
        """Derivative of the value with respect to the search coordinate."""
        return self.to_value(z) if self.logarithmic else self._scale


def model_parameter(name: str, interface: Interface) -> Free:
    """A parameter between the bounds that the model itself declares; or the ratio of one to what is stated of it.

    Raises:
        InputError: the model has no such parameter, or it declares no bounds of it.
    """
    if is_ratio(name):
        low, start, high = CRITERIA.search.stated_ratio
        return Free(name, low, high, start, "1", start - 1)
    v = interface.parameters.get(name)
    if v is None:
        raise InputError(
            f"{interface.model} has no parameter '{name}'; {did_you_mean(name, interface.parameters)}"
        )
    if v.min is None or v.max is None or v.start is None:
        raise InputError(
            f"'{name}' of {interface.model} has no bounds: state them under [fit] of the data set"
        )
    return Free(name, v.min, v.max, v.start, v.unit, v.nominal)


def base_parameters(data: DataSet, interface: Interface) -> tuple[Free, ...]:
    """The free parameters that the data set declares, as parameters of the model with ``interface``.

    Raises:
        InputError: the model has no such parameter.
    """
    return tuple(free_parameter(parameter, data, interface) for parameter in data.fit.values())


def free_parameter(entry: FreeParameter, data: DataSet, interface: Interface) -> Free:
    """One of them; arguments and errors as for ``base_parameters``."""
    variable = interface.parameters.get(entry.parameter)
    if variable is None:
        raise InputError(
            f"{interface.model} has no parameter '{entry.parameter}' to fit",
            data.folder / "experiment.toml",
        )
    ratio = is_ratio(entry.name)
    start = _start(entry.start, variable.start, entry.min, entry.max)
    return Free(
        entry.name,
        entry.min,
        entry.max,
        start,
        "1" if ratio else variable.unit,
        transform=entry.transform,
        prior=entry.prior,
        run=entry.run,
    )


def _start(stated: float | None, default: float | None, low: float, high: float) -> float:
    start = stated if stated is not None else default
    return (low + high) / 2 if start is None else min(max(start, low), high)
