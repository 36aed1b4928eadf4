"""The product of a measurement by sines: gains, distortion, and the linear model about the same point."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pam_cosim.analysis.linear import LinearModel
from pam_cosim.arrays import Array
from pam_cosim.exports import Exported, Table
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed


@dataclass(frozen=True)
class FrequencyResponse(Printed, Exported):
    """How outputs answer to a sine of an input.

    Attributes:
        model: its name.
        input, outputs: names.
        units: of each of them.
        amplitude: of the input [its unit].
        frequencies: (k,) [Hz].
        gain: (k, p) complex, fundamental of the output by that of the input.
        distortion: (k, p) harmonics of the output, root of the sum of squares, by its fundamental.
        shift: (k, p) mean of the output, from that at rest; where there is no ``linear``, the mean itself.
        periods: (k,) done at each frequency.
        settled: (k,) whether the last two periods were alike to a thousandth.
        linear: the linear model from the same input to the same outputs, about the same rest; None: not known.
    """

    json_keys = "model input amplitude units frequencies periods settled outputs=_rows linear"

    model: str
    input: str
    outputs: tuple[str, ...]
    units: dict[str, str]
    amplitude: float
    frequencies: Array
    gain: Array
    distortion: Array
    shift: Array
    periods: Array
    settled: Array
    linear: LinearModel | None = None

    @property
    def linear_gain(self) -> Array:
        """(k, p) complex gain of the linear model at the same frequencies; not a number where there is none."""
        if self.linear is None:
            return np.full(self.gain.shape, np.nan + 0j)
        return self.linear.response(self.frequencies)[:, :, 0]

    @property
    def bandwidth(self) -> dict[str, float]:
        """For each output the frequency [Hz] at which its gain is 3 dB below the static gain of the linear model.

        Where that is not known, below the gain at the lowest frequency. Between measured frequencies by straight lines
        in the logarithms; not a number where it is not crossed.
        """
        return {name: self._bandwidth(i) for i, name in enumerate(self.outputs)}

    def _bandwidth(self, i: int) -> float:
        gain = np.abs(self.gain[:, i])
        static = gain[0] if self.linear is None else abs(float(self.linear.static_gain[i, 0]))
        return _crossing(self.frequencies, gain, static if np.isfinite(static) else float(gain[0]))

    @property
    def _rows(self) -> dict[str, object]:
        """Phases in degrees."""
        linear = None if self.linear is None else self.linear_gain
        return {
            name: {
                "gain": np.abs(self.gain[:, i]),
                "phase": phase(self.gain[:, i]),
                "distortion": self.distortion[:, i],
                "shift": self.shift[:, i],
                "linear_gain": None if linear is None else np.abs(linear[:, i]),
                "linear_phase": None if linear is None else phase(linear[:, i]),
                "bandwidth": self.bandwidth[name],
            }
            for i, name in enumerate(self.outputs)
        }

    def table(self) -> Table:
        """A row for each frequency."""
        parts = ("gain", "phase [deg]", "distortion", "linear gain", "linear phase [deg]")
        heads = [f"{name} {part}" for name in self.outputs for part in parts]
        linear = self.linear_gain
        columns = [self.frequencies]
        for i in range(len(self.outputs)):
            simulated, linearised = self.gain[:, i], linear[:, i]
            columns += [
                np.abs(simulated),
                phase(simulated),
                self.distortion[:, i],
                np.abs(linearised),
                phase(linearised),
            ]
        rows = zip(*columns, self.periods.astype(int), self.settled, strict=True)
        return ["frequency [Hz]", *heads, "periods", "settled"], rows

    def _lines(self) -> tuple[list[str], list[list[str]]]:
        heads = ["frequency [Hz]"]
        for name in self.outputs:
            heads += [f"{name}: gain", "phase [deg]", "distortion", "by linear model"]
        linear, rows = self.linear_gain, []
        phases = [phase(self.gain[:, i]) for i in range(len(self.outputs))]
        for k, frequency in enumerate(self.frequencies):
            row = [f"{frequency:.4g}" + ("" if self.settled[k] else " (not settled)")]
            for i in range(len(self.outputs)):
                ratio = (
                    np.abs(self.gain[k, i]) / np.abs(linear[k, i])
                    if np.abs(linear[k, i]) > 0
                    else np.nan
                )
                row += [
                    f"{np.abs(self.gain[k, i]):.4g}",
                    f"{phases[i][k]:.1f}",
                    f"{self.distortion[k, i]:.2%}",
                ]
                row.append("-" if np.isnan(ratio) else f"{ratio:.4f}")
            rows.append(row)
        return heads, rows

    def _title(self) -> str:
        swing = format_quantity(self.amplitude, self.units[self.input])
        return f"{self.model}: {', '.join(self.outputs)} by {self.input}, which swings by {swing}"

    def __str__(self) -> str:
        heads, rows = self._lines()
        widths = [max(map(len, column)) for column in zip(heads, *rows, strict=True)]
        lines = [
            "  ".join(f"{cell:>{w}}" for cell, w in zip(row, widths, strict=True))
            for row in (heads, *rows)
        ]
        where = [] if self.linear is None else [str(self.linear.point)]
        bands = [
            f"{n}: 3 dB less at {f:.3g} Hz" for n, f in self.bandwidth.items() if np.isfinite(f)
        ]
        return "\n".join([self._title(), *where, "", *lines, *bands])


def phase(gain: Array) -> Array:
    """Phase (k,) of complex gains (k,) over k frequencies [deg], without jumps of 360 degrees."""
    return np.asarray(np.degrees(np.unwrap(np.angle(gain))))


def _crossing(frequencies: Array, gain: Array, static: float) -> float:
    with np.errstate(divide="ignore"):
        below = np.log(gain) - np.log(static / np.sqrt(2))
    after = np.flatnonzero(below < 0)
    if not after.size or after[0] == 0 or not np.isfinite(below[: after[0] + 1]).all():
        return float("nan")
    i = after[0]
    share = below[i - 1] / (below[i - 1] - below[i])
    logs = np.log(frequencies[i - 1 : i + 1])
    return float(np.exp(logs[0] + share * (logs[1] - logs[0])))
