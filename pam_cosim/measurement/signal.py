"""A measured signal, as it is stated and as it is used: its unit, and the noise of its instrument."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.units import format_quantity


@dataclass(frozen=True)
class Averaged:
    """Samples that are means of ``samples`` others, which were recorded in steps of ``step`` (0: in none)."""

    samples: int
    step: float = 0.0


@dataclass(frozen=True)
class StatedSignal:
    """What an experimenter states of a measured output, before its noise is complete.

    Attributes:
        name: the output's name.
        unit: the bench's unit of it.
        sigma: standard deviation of the noise of a row [unit], a mean where rows are means; None: not stated.
        fitted: as in ``Signal``.
        step: of means of a record in coarse steps [unit]; 0: none.
        repeatability: standard deviation between runs of the same test [unit]; 0: not stated.
        sigma_of_reading: standard deviation of noise that grows with the reading, a share of it [1].
    """

    name: str
    unit: str = ""
    sigma: float | None = None
    fitted: bool = True
    step: float = 0.0
    repeatability: float = 0.0
    sigma_of_reading: float = 0.0


@dataclass(frozen=True)
class Signal:
    """A measured output of the bench, with its noise (``noise.complete_noise``).

    Attributes:
        name: the output's name.
        unit: the bench's unit of it.
        sigma: standard deviation of the instrument's noise [unit]; where it grows with the reading, its root mean
            square over the samples.
        estimated: ``sigma`` was not stated by the experimenter: it was estimated from the samples, or assumed.
        fitted: parameters are fitted to it and models judged by it; otherwise it is only shown with the model.
        step: of the record [unit], where that is coarse compared with the noise: ``sigma`` holds what it adds. 0: none.
        repeatability: standard deviation between runs of the same test [unit], the noise included: ``sigma`` is this
            where it is larger. 0: unknown.
        repeats: ``repeatability`` was estimated from runs that repeat one another, not stated by the experimenter.
        assumed: the samples show no noise to estimate, so that ``sigma`` is a share of their range.
        stated: ``sigma`` as it was stated [unit], before steps and repeated runs count; None: it was not.
        sigma_of_reading: noise that grows with the reading, a share of it [1]; 0: the noise is the same everywhere.
        sigma_at_zero: the noise where the reading is zero [unit]; counts where ``sigma_of_reading`` does.
    """

    name: str
    unit: str
    sigma: float
    estimated: bool = False
    fitted: bool = True
    step: float = 0.0
    repeatability: float = 0.0
    repeats: bool = False
    assumed: bool = False
    stated: float | None = None
    sigma_of_reading: float = 0.0
    sigma_at_zero: float = 0.0

    def sigma_at(self, reading: Array | float) -> Array | float:
        """Standard deviation of the noise of readings of any shape [unit of the signal].

        One value for each reading if the noise grows with the reading, else one number for all.
        """
        if not self.sigma_of_reading:
            return self.sigma
        return np.asarray(np.hypot(self.sigma_at_zero, self.sigma_of_reading * np.asarray(reading)))

    @property
    def scatter(self) -> str:
        """What ``sigma`` is the standard deviation of, in a word."""
        return "repeatability" if self.repeatability >= self.sigma else "noise"

    @property
    def source(self) -> str:
        """Where ``sigma`` comes from, in words."""
        if self.scatter == "repeatability":
            return "of repeated runs" if self.repeats else "stated repeatability"
        if self.assumed:
            return "assumed"
        source = "estimated from the samples" if self.estimated else "stated"
        if self.sigma_of_reading:
            at_zero = format_quantity(self.sigma_at_zero, self.unit, 3)
            return f"{source}: {at_zero} and {100 * self.sigma_of_reading:.3g} % of the reading, on average"
        return source

    def as_stated(self) -> StatedSignal:
        """What the experimenter stated of it."""
        stated = self.stated
        if stated is None and not self.estimated and self.scatter == "noise":
            stated = self.sigma  # of a signal that was made otherwise than by reading
        repeatability = 0.0 if self.repeats else self.repeatability
        growth = self.sigma_of_reading
        return StatedSignal(
            self.name,
            self.unit,
            stated,
            self.fitted,
            repeatability=repeatability,
            sigma_of_reading=growth,
        )

    @property
    def noise(self) -> float:
        """Standard deviation of the noise before it is rounded to steps [unit], at least a part of a step."""
        least = CRITERIA.noise.least_of_step * self.step
        return sqrt(max(self.sigma**2 - self.step**2 / 12.0, least**2))

    @property
    def is_coarse(self) -> bool:
        """Whether steps, and not the noise, determine the error of readings (Widrow and Kollar 2008)."""
        return bool(self.step) and 2.0 * self.noise < self.step
