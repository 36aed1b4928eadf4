"""A vertical load rig that is not the library: DY (5)-(16) in length and momentum, integrated by scipy.

Dzahir and Yamamoto (2019) print neither data nor coefficients, so this stands for their rig. It shares no code with
the library: the force is DY (5) in its printed variables, with the angle of the braid; the unknowns are the muscle's
length and the load's momentum; the integrator is LSODA with tolerances of its own; readings carry seeded noise. Its
slenderness, and the way its dry friction turns over, are not the library's either.

Run as ``python examples/dzahir-yamamoto/vertical_rig.py FOLDER``.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import exp, hypot, pi, radians, sin, tan
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]

GRAVITY = 9.80665
LOADS = (5.0, 10.0, 15.0, 20.0, 25.0, 30.0)  # kg, DY Table 3
FREQUENCIES = (0.5, 1.0, 1.5, 2.0)  # Hz, DY Table 3
DURATION, RATE = 6.0, 50.0  # s, Hz
NOISE = 1e-4  # m, standard deviation of the displacement transducer
ACCURACY = (1e-8, 1e-6, 1e-2)  # m, kg.m/s, Pa: of the integration, far below the noise


def algebraic(x: float) -> float:
    """A sign that is rounded over one: x/sqrt(1 + x^2), which comes near to one much later than tanh x does."""
    return x / hypot(1.0, x)


@dataclass(frozen=True)
class Muscle:
    """What the rig's muscle is like; the friction coefficient is gamma_F gamma_f = ab M g f, DY (10)."""

    length: float = 0.3  # m
    diameter: float = 0.02  # m
    angle: float = radians(23)  # of the braid at rest
    irregularity: tuple[float, float] = (3.0, -2e-6)  # c_1, c_2 [1/Pa], DY (6)
    slenderness: tuple[float, float, float] = (0.22, -11.0, 0.97)  # c_3, c_4, c_5, DY (7)
    coulomb: float = 6.0  # N
    ab: float = 0.12  # s2
    rounded_sign: Callable[[float], float] = algebraic
    sign_width: float = 8e-4  # 1/s, rate of strain over which the sign is rounded
    stiffness: float = (
        1e10  # N/m3, of the stretched sleeve, DY (12) with the cube over the whole stretch
    )
    lag: float = 2e-3  # s, of the pressure regulator

    def static_force(self, p: float, eps: float) -> float:
        """DY (5) [N]."""
        c_1, c_2 = self.irregularity
        c_3, c_4, c_5 = self.slenderness
        q = 1 + c_1 * exp(c_2 * p)
        mu = c_3 * exp(c_4 * eps) + c_5
        shape = 3 * (1 - q * eps) ** 2 / tan(self.angle) ** 2 - 1 / sin(self.angle) ** 2
        return mu * pi * self.diameter**2 * p / 4 * shape


@dataclass(frozen=True)
class Measured:
    """One run: times (n,) [s], pressure told to the regulator (n,) [Pa], contraction read (n,) [m]."""

    load: float
    frequency: float
    time: Array
    p: Array
    x: Array


@dataclass(frozen=True)
class Rig:
    """The rig with a muscle; the same every time."""

    muscle: Muscle = field(default_factory=Muscle)
    noise: float = NOISE  # m
    seed: int = 2019

    def wave(self, frequency: float, load: float) -> Array:
        """(n,) [Pa]: twelve sines of random frequency up to the highest and of random phase, DY section 2.

        From 0 to 400 kPa, rising from nothing within the first second so that no step sets the load swinging.
        """
        random = np.random.default_rng([self.seed, round(10 * frequency), round(load)])
        time = np.arange(round(DURATION * RATE) + 1) / RATE
        parts = frequency * np.append(random.uniform(0.15, 1, 11), 1)
        y = np.sin(2 * np.pi * np.outer(time, parts) + random.uniform(0, 2 * np.pi, 12)).sum(axis=1)
        rising = np.sin(np.pi / 2 * np.minimum(time, 1)) ** 2
        return np.asarray(np.round(4e5 * rising * (y - y.min()) / np.ptp(y), -1))

    def run(self, load: float, frequency: float) -> Measured:
        """One run, from rest without pressure."""
        m = self.muscle
        p_told = self.wave(frequency, load)
        time = np.arange(len(p_told)) / RATE
        damping = m.ab * load * GRAVITY * frequency

        def rates(t: float, y: Array) -> list[float]:
            length, momentum, p = y
            speed = momentum / load  # downwards
            eps, eps_dot = 1 - length / m.length, -speed / m.length
            pull = m.static_force(p, eps) + m.stiffness * max(0.0, length - m.length) ** 3
            pull -= m.coulomb * m.rounded_sign(eps_dot / m.sign_width) + damping * eps_dot
            return [speed, load * GRAVITY - pull, (float(np.interp(t, time, p_told)) - p) / m.lag]

        rest = m.length + (load * GRAVITY / m.stiffness) ** (1 / 3)
        solution = solve_ivp(
            rates,
            (0, time[-1]),
            [rest, 0.0, 0.0],
            "LSODA",
            time,
            rtol=1e-7,
            atol=ACCURACY,
            max_step=2 / RATE,
        )
        random = np.random.default_rng([self.seed, 1, round(10 * frequency), round(load)])
        reading = m.length - solution.y[0] + self.noise * random.standard_normal(len(time))
        return Measured(load, frequency, time, p_told, np.asarray(reading))


EXPERIMENT = """title = "{title}"
model = "PneumaticMuscle.Examples.ConstantFrictionLoad"

[signals.x]
sigma = "0.1 mm"

[parameters]
"muscle.D0" = "20 mm"

[fit]
"muscle.braid.c_3" = {{ min = 0, max = 1 }}
"muscle.braid.c_4" = {{ min = -40, max = -2 }}
"muscle.braid.c_5" = {{ min = 0.8, max = 1.2 }}
"muscle.friction.c_c" = {{ min = "0 N", max = "100 N" }}
"muscle.friction.c_v" = {{ min = "0 N.s", max = "2000 N.s" }}
{runs}"""
RUN = """
[[runs]]
file = "{file}"
role = "{role}"
[runs.parameters]
"load.m" = "{load:g} kg"
frequency = "{frequency:g} Hz"
"""


def conditions(
    loads: Sequence[float] = LOADS, frequencies: Sequence[float] = FREQUENCIES
) -> Mapping[tuple[float, float], str]:
    """Role by load and frequency: every other condition is fitted, as on a chessboard; the others only judge."""
    grid = [(i, j) for i in range(len(loads)) for j in range(len(frequencies))]
    return {(loads[i], frequencies[j]): "holdout" if (i + j) % 2 else "fit" for i, j in grid}


def write_data_set(
    folder: Path,
    rig: Rig | None = None,
    loads: Sequence[float] = LOADS,
    frequencies: Sequence[float] = FREQUENCIES,
    title: str = "empirical muscle at six loads and four frequencies",
) -> Path:
    """All conditions as a data set of the base model; by default the 24 of DY Table 3."""
    folder.mkdir(parents=True, exist_ok=True)
    runs = ""
    for (load, frequency), role in conditions(loads, frequencies).items():
        run = (rig or Rig()).run(load, frequency)
        file = f"{load:g}kg-{frequency:g}Hz.csv"
        rows = [
            f"{t:.2f},{p / 1e3:.2f},{x * 1e3:.4f}"
            for t, p, x in zip(run.time, run.p, run.x, strict=True)
        ]
        (folder / file).write_text(
            "\n".join(["time [s],p [kPa],x [mm]", *rows]) + "\n", encoding="utf-8"
        )
        runs += RUN.format(file=file, role=role, load=load, frequency=frequency)
    (folder / "experiment.toml").write_text(
        EXPERIMENT.format(title=title, runs=runs), encoding="utf-8"
    )
    return folder


def main() -> None:
    """Writes the data set into the folder named on the command line."""
    if len(sys.argv) != 2:
        raise SystemExit(
            "name one folder for the data set: python examples/dzahir-yamamoto/vertical_rig.py FOLDER"
        )
    print(write_data_set(Path(sys.argv[1])))


if __name__ == "__main__":
    main()
