"""The product of a tracking test: how closely a controlled output follows a sine, by its frequency."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.exports import Exported, Table, headed
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed


@dataclass(frozen=True)
class Tracking(Printed, Exported):
    """An output that shall follow mean + amplitude sin(2 pi f t).

    Attributes:
        plant, controller: their names.
        output: that follows.
        unit: of it.
        mean, amplitude: of what is wanted [unit].
        rate: of the controller's samples [Hz].
        frequencies: (k,) [Hz].
        gain: (k,) complex, fundamental of the output by that of what is wanted.
        error: (k,) root mean square over the last period [unit].
        peak: (k,) largest error in it [unit].
        settled: (k,) whether the last two periods are alike to a hundredth of the amplitude.
        phase: (s,) within the last period, 0 to 1.
        courses: (k, s) of the output in it.
        actuation: by input of the plant, (k, s) in it.
    """

    json_keys = (
        "plant controller output unit mean amplitude rate frequencies gain=_gain phase=_phase "
        "error relative_error peak settled"
    )

    plant: str
    controller: str
    output: str
    unit: str
    mean: float
    amplitude: float
    rate: float
    frequencies: Array
    gain: Array
    error: Array
    peak: Array
    settled: Array
    phase: Array
    courses: Array
    actuation: dict[str, Array]

    @property
    def relative_error(self) -> Array:
        """(k,) rms error by the rms of the sine that is wanted: 1 is as bad as not to move."""
        return np.asarray(self.error / (self.amplitude / np.sqrt(2)))

    @property
    def wanted(self) -> Array:
        """(s,) over the last period [unit]."""
        return np.asarray(self.mean + self.amplitude * np.sin(2 * np.pi * self.phase))

    @property
    def _gain(self) -> Array:
        return np.abs(self.gain)

    @property
    def _phase(self) -> Array:
        return np.degrees(np.angle(self.gain))

    def table(self) -> Table:
        """A row for each frequency."""
        errors = [headed("rms error", self.unit), "relative error", headed("peak error", self.unit)]
        degrees = np.degrees(np.angle(self.gain))
        columns = (
            self.frequencies,
            self.error,
            self.relative_error,
            self.peak,
            np.abs(self.gain),
            degrees,
        )
        rows = zip(*columns, self.settled, strict=True)
        return ["frequency [Hz]", *errors, "gain", "phase [deg]", "settled"], rows

    def _rows(self) -> list[list[str]]:
        rows = [["frequency [Hz]", "rms error", "of the sine", "peak", "gain", "phase [deg]", ""]]
        for k, frequency in enumerate(self.frequencies):
            rms, worst = (format_quantity(float(v[k]), self.unit) for v in (self.error, self.peak))
            gain = self.gain[k]
            rows.append(
                [
                    f"{frequency:.3g}",
                    rms,
                    f"{self.relative_error[k]:.1%}",
                    worst,
                    f"{abs(gain):.3f}",
                    f"{np.degrees(np.angle(gain)):.1f}",
                    "" if self.settled[k] else "not settled",
                ]
            )
        return rows

    def _title(self) -> str:
        middle, swing = (format_quantity(v, self.unit) for v in (self.mean, self.amplitude))
        return f"{self.plant}: {self.output} follows {middle} ± {swing} by {self.controller} at {self.rate:g} Hz"

    def __str__(self) -> str:
        rows = self._rows()
        widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
        lines = [
            "  ".join(f"{cell:>{w}}" for cell, w in zip(row, widths, strict=True)).rstrip()
            for row in rows
        ]
        return "\n".join([self._title(), "", *lines])
