"""A parameter that is not known well: its bounds, and what is known of it beforehand."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, log
from typing import Literal

from pam_cosim.model.references import parameter_of

INTERVAL = 1.96  # sd: half width of a 95 % interval of a normal distribution

Transform = Literal["log", "linear"]


@dataclass(frozen=True)
class Prior:
    """What is known of a parameter before the measurement: a normal distribution [unit of the parameter].

    Attributes:
        mean: of the value; the median where the distribution is that of the logarithm.
        sd: of the value, or of its natural logarithm.
        logarithmic: the logarithm of the value is normally distributed.
    """

    mean: float
    sd: float
    logarithmic: bool = False

    @property
    def low(self) -> float:
        """Lower end of the range that holds 95 % of the values."""
        return self._at(-INTERVAL)

    @property
    def high(self) -> float:
        """Upper end of that range."""
        return self._at(INTERVAL)

    def _at(self, deviations: float) -> float:
        if self.logarithmic:
            return self.mean * exp(deviations * self.sd)
        return self.mean + deviations * self.sd

    def surprise(self, value: float) -> float:
        """How far a value is from the mean, in standard deviations; one above zero where that is logarithmic."""
        return (log(value / self.mean) if self.logarithmic else value - self.mean) / self.sd

    def slope(self, value: float) -> float:
        """Derivative of ``surprise`` with respect to the value."""
        return 1 / (self.sd * (value if self.logarithmic else 1.0))

    def __str__(self) -> str:
        if self.logarithmic:
            return f"{self.mean:.4g} within a factor of {exp(self.sd):.2g}"
        return f"{self.mean:.4g} ± {self.sd:.2g}"


@dataclass(frozen=True)
class FreeParameter:
    """A parameter to be fitted, between bounds [unit]; without ``start`` the model's default starts.

    Attributes:
        name: of the parameter; where it is of one run alone, with "@" and the run's name after it.
        transform: how it is searched; None: as the bounds suggest.
        prior: what is known of it beforehand.
        run: the one run that it is of; empty: all.
    """

    name: str
    min: float
    max: float
    start: float | None = None
    unit: str = ""
    transform: Transform | None = None
    prior: Prior | None = None
    run: str = ""

    @property
    def parameter(self) -> str:
        """Its name in the model."""
        return self.name.removesuffix(f"@{self.run}") if self.run else parameter_of(self.name)
