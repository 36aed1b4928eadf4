"""Files as invented laboratories have them: a simple muscle of another form than the library's, with noise.

Chou and Hannaford's static force, a pressure of first order behind its set point, a mass with a damper, by Euler's
method; nothing of the model under test.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import scipy.io
from numpy.typing import NDArray

Array = NDArray[np.float64]
LENGTH, AREA, BRAID = 0.24, 3.1e-4, (1.9, 1.2)


def force(p: Array | float, x: Array | float) -> Array | float:
    """Pull [N] at a gauge pressure [Pa] and a contraction [m]."""
    eps = np.asarray(x) / LENGTH
    return np.maximum(np.asarray(p) * AREA * (BRAID[0] * 1.6 * (1 - eps) ** 2 - BRAID[1]), 0.0)


def lag(p_set: Array, dt: float, tau: float = 0.06) -> Array:
    """Pressure of first order behind its set point."""
    p = np.zeros_like(p_set)
    for i in range(1, len(p)):
        p[i] = p[i - 1] + dt * (p_set[i - 1] - p[i - 1]) / tau
    return p


def lift(p: Array, dt: float, mass: float) -> Array:
    """Contraction [m] of the muscle under a hanging mass, which rests on a stop."""
    x, v = np.zeros_like(p), 0.0
    for i in range(1, len(p)):
        v += dt * ((float(force(p[i - 1], x[i - 1])) - mass * 9.81 - 60.0 * v) / mass)
        x[i] = x[i - 1] + dt * v
        if x[i] < 0.0:
            x[i], v = 0.0, 0.0
    return x


def steps(levels: list[float], hold: float, dt: float) -> tuple[Array, Array]:
    """Times and a course that holds each level [Pa], from rest."""
    each = round(hold / dt)
    course = np.repeat(np.array([0.0, *levels]), each)
    return dt * np.arange(len(course)), course


def noisy(values: Array, sigma: float, seed: int, step: float = 0.0) -> Array:
    """With noise, rounded to steps."""
    read = values + np.random.default_rng(seed).normal(0.0, sigma, len(values))
    return np.round(read / step) * step if step else read


def german(folder: Path, levels: list[float], seed: int, mass: float = 2.27) -> Path:
    """A proportional regulator and a hanging load; semicolons, decimal commas, a potentiometer that counts down."""
    time, p_set = steps(levels, 1.0, 0.005)
    p = lag(p_set, 0.005)
    x = lift(p, 0.005, mass)
    rows = zip(
        time,
        p_set / 1e5,
        noisy(p / 1e5, 0.004, seed),
        noisy(212.5 - 1e3 * x, 0.05, seed + 1),
        strict=True,
    )
    text = "Prüfstand 3;;;;\nBediener: Jürgen Müller;;;;\n\nZeit;Solldruck;Druck;Weg;Bemerkung\ns;bar;bar;mm;\n"
    text += "".join(
        f"{t:.3f};{w:.3f};{q:.4f};{z:.3f};ok\n".replace(".", ",") for t, w, q, z in rows
    )
    file = folder / f"Messung {seed:02d}.csv"
    file.write_bytes(text.encode("latin-1"))
    return file


def matlab(folder: Path, length: float, seed: int) -> Path:
    """Isometric: the length is held, the pressure goes up and down; a structure without units."""
    time = 0.01 * np.arange(900)
    p = 4e5 * np.clip(np.sin(np.pi * (time - 1.0) / 8.0), 0.0, None)
    p[time < 1.0] = 0.0
    pull = np.asarray(force(p, LENGTH - length))
    content = {
        "t": time, "Druck": noisy(p / 1e3, 0.4, seed), "Laenge": noisy(np.full(900, 1e3 * length), 0.01, seed + 1),
        "Kraft": noisy(pull, 0.3, seed + 2),
    }  # fmt: skip
    file = folder / f"isometric_{seed}.mat"
    scipy.io.savemat(file, {"messung": content})
    return file


def valves(folder: Path, current: float, seed: int) -> Path:
    """Two valves by their currents and a supply; units in their own row, the clock in milliseconds."""
    time, u_in = steps([current, current, 0.0, 0.0], 1.0, 0.01)
    u_out = np.where(time >= 4.0, 0.3, 0.0)
    p = lag(np.where(time < 1.0, 0.0, np.where(time < 4.0, 1.8e5, 0.0)), 0.01, 0.3 * 0.35 / current)
    x = lift(p, 0.01, 2.27)
    supply = noisy(np.full(len(time), 207.0), 0.3, seed)
    read = [noisy(p / 1e3, 0.3, seed + 1), noisy(1e3 * x, 0.05, seed + 2)]
    columns = [1e3 * time, 1e3 * u_in, 1e3 * u_out, supply, *read]
    text = "t,I_in,I_out,Vordruck,pm,Kontraktion\nms,mA,mA,kPa,kPa,mm\n"
    text += "".join(
        ",".join(f"{value:.4f}" for value in row) + "\n" for row in zip(*columns, strict=True)
    )
    file = folder / f"valves-{seed}.csv"
    file.write_text(text)
    return file


def french(folder: Path, levels: list[float], seed: int, mass: float) -> Path:
    """Imposed pressure and a load that the file's name tells."""
    time, wanted = steps(levels, 1.0, 0.01)
    p = lag(wanted, 0.01)
    x = lift(p, 0.01, mass)
    rows = zip(time, noisy(p / 1e5, 0.003, seed), noisy(1e3 * x, 0.04, seed + 1), strict=True)
    text = "temps (s)\tpression (bar)\tdéplacement (mm)\n"
    text += "".join(f"{t:.2f}\t{q:.4f}\t{z:.3f}\n" for t, q, z in rows)
    file = folder / f"essai{seed:02d}_{mass:g}kg.txt"
    file.write_text(text, encoding="utf-8")
    return file


def several(write: Callable[..., Path], folder: Path, *arguments: tuple[object, ...]) -> list[Path]:
    """A file for each tuple of arguments."""
    folder.mkdir(exist_ok=True)
    return [write(folder, *one) for one in arguments]
