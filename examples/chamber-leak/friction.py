"""Friction of an O-ring from strokes out and back at constant pressure."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from examples.raw_data import write_table

MIDDLE = (8.0, 30.0)  # mm
SMOOTH = 15  # samples of 10 ms
MOVING = 1.0  # mm/s
HEAD = [
    "pressure out, back [bar]",
    "speed out, back [mm/s]",
    "force out, back [N]",
    "area [mm2]",
    "friction [N]",
]
SOURCE = """Means over the middle of the stroke (8 to 30 mm), out and back: measured by E. Zillen, TU Delft (github.com/
EvaZillen/3D-printed-pneumatic-actuator, CC0-1.0, commit 6e0bcb4, friction_O-ring_*.csv)."""


@dataclass(frozen=True)
class Stroke:
    """Means of the strokes out and back at one pressure: pressure [bar], speed [mm/s], force [N]."""

    p_out: float
    p_back: float
    v_out: float
    v_back: float
    f_out: float
    f_back: float

    @property
    def pressure(self) -> float:
        """Mean pressure [bar]."""
        return (self.p_out + self.p_back) / 2

    @property
    def area(self) -> float:
        """Mean force by mean pressure [mm2]."""
        return 10 * (self.f_out + self.f_back) / (self.p_out + self.p_back)

    @property
    def friction(self) -> float:
        """Half the difference of the forces, less that of the pressures [N]."""
        return (self.f_out - self.f_back) / 2 - self.area / 10 * (self.p_out - self.p_back) / 2

    def row(self) -> list[str]:
        """A line of the report."""
        return [
            f"{self.p_out:.3f}, {self.p_back:.3f}", f"{self.v_out:.1f}, {self.v_back:.1f}",
            f"{self.f_out:.1f}, {self.f_back:.1f}", f"{self.area:.0f}", f"{self.friction:.2f}",
        ]  # fmt: skip


NAMES = ("p_out [bar]", "p_back [bar]", "v_out [mm/s]", "v_back [mm/s]", "F_out [N]", "F_back [N]")


def write_strokes(raw: Path, path: Path) -> None:
    """The means of all recordings."""
    strokes = [_means(file) for file in sorted(raw.glob("friction_O-ring_*bar.csv"))]
    columns = list(zip(*strokes, strict=True))
    write_table(path, dict(zip(NAMES, columns, strict=True)), SOURCE)


def _means(file: Path) -> tuple[float, ...]:
    data = np.genfromtxt(file)
    time, x, p, force = data[:, 0] / 1e3, data[:, 4], data[:, 5], data[:, 6]
    v = np.gradient(np.convolve(x, np.ones(SMOOTH) / SMOOTH, "same"), time)
    middle = (x > MIDDLE[0]) & (x < MIDDLE[1])
    out, back = middle & (v > MOVING), middle & (v < -MOVING)
    means = [float(y[part].mean()) for y in (p, v, force) for part in (out, back)]
    return tuple(means)


def read_strokes(path: Path) -> list[Stroke]:
    """What ``write_strokes`` wrote."""
    table = np.genfromtxt(path, delimiter=",", comments="#", skip_header=SOURCE.count("\n") + 2)
    return [Stroke(*map(float, line)) for line in table]


def line(strokes: list[Stroke]) -> tuple[float, float]:
    """Slope [N/bar] and value at no pressure [N] of the friction."""
    slope, base = np.polyfit([s.pressure for s in strokes], [s.friction for s in strokes], 1)
    return float(slope), float(base)
