"""Published formulas, rig by rig, fitted to the same rows by SciPy."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

from benchmarks.real_rigs.folders import Array
from benchmarks.real_rigs.rows import Course

AIR, HOT, KAPPA, AMBIENT = 287.05, 298.0, 1.4, 101.325  # J/(kg K), K, 1, kPa
LEAST_LOAD, IDLE = 0.1, 31.4  # of a fan, and its speed [rad/s] at the start: as its bench has them


@dataclass(frozen=True)
class Formula:
    """A function of a course and coefficients, with their starts and bounds."""

    title: str
    value: Callable[[Course, Array], Array]
    start: Sequence[float]
    low: Sequence[float]
    high: Sequence[float]


def fitted(formula: Formula, courses: Sequence[Course]) -> Array:
    """The coefficients of least squares."""

    def error(c: Array) -> Array:
        parts = [(formula.value(k, c) - k.measured)[~np.isnan(k.measured)] for k in courses]
        return np.nan_to_num(np.concatenate(parts), nan=1e6, posinf=1e6, neginf=-1e6)

    bounds = (np.asarray(formula.low, float), np.asarray(formula.high, float))
    best = least_squares(
        error, formula.start, bounds=bounds, x_scale=np.maximum(np.abs(formula.start), 1e-6)
    )
    return np.asarray(best.x)


def _first(course: Course) -> float:
    return float(course.measured[np.flatnonzero(~np.isnan(course.measured))[0]])


def hose(course: Course, c: Array) -> Array:
    """Exponential in the time since the command, with a dead time: Sojoodi Farimani and Misra 2018, equation 1."""
    filling = course.inputs[0, 0] > 0.5
    tau, dead = (c[0], c[1]) if filling else (c[2], c[3])
    target = course.inputs[0, 2] if filling else 0.0
    begun = np.maximum(course.time - dead, 0)
    return np.asarray(target + (_first(course) - target) * np.exp(-begun / tau))


def robot(course: Course, c: Array) -> Array:
    """First-order filling and venting behind dead times; the sensor has a zero."""
    t, p = course.time, np.empty(len(course.time))
    u_in = np.interp(t - c[2], t, course.inputs[:, 0])
    u_out = np.interp(t - c[3], t, course.inputs[:, 1])
    zero = p[0] = _first(course)
    for i in range(1, len(t)):
        rate = (
            u_in[i] * (course.inputs[i, 2] - p[i - 1]) / c[0] + u_out[i] * (zero - p[i - 1]) / c[1]
        )
        p[i] = p[i - 1] + rate * (t[i] - t[i - 1])
    return p


def decay(course: Course, c: Array) -> Array:
    """An exponential: a leak in proportion to the pressure."""
    return np.asarray(c[0] * np.exp(-course.time / c[1]))


def orifice(course: Course, c: Array) -> Array:
    """Polytropic discharge or filling of 16.18 L through 2.71 mm: Saint-Venant and Wantzel; C_d and n."""
    volume, area = 16.18e-3, np.pi / 4 * 2.71e-3**2
    p_0 = 1e3 * (_first(course) + AMBIENT)
    outside = 1e5

    def flow(p_a: float, t_a: float, p_b: float) -> float:
        ratio = max(p_b / p_a, (2 / (KAPPA + 1)) ** (KAPPA / (KAPPA - 1)))
        psi = (
            2
            * KAPPA
            / (KAPPA - 1)
            * max(ratio ** (2 / KAPPA) - ratio ** ((KAPPA + 1) / KAPPA), 0.0)
        )
        return float(c[0] * area * p_a * np.sqrt(psi / (AIR * t_a)))

    def rate(_: float, y: Array) -> list[float]:
        p = max(float(y[0]), 100.0)
        hot = HOT * (p / p_0) ** ((c[1] - 1) / c[1])
        m = -flow(p, hot, outside) if p > outside else flow(outside, HOT, p)
        return [c[1] * AIR * (hot if m < 0 else HOT) * m / volume]

    t = course.time
    done = solve_ivp(rate, (t[0], t[-1]), [p_0], t_eval=t, max_step=1.0, rtol=1e-6)
    if len(done.t) < len(t):
        return np.full(len(t), np.nan)
    return np.asarray(done.y[0] / 1e3 - AMBIENT)


def fan(course: Course, c: Array, load: int) -> Array:
    """I der(w) = tau L^3 - K w^2 from idling: model A2 of Gamella and others 2025; tau/I and K/I."""
    u = course.inputs[:, load]
    pull = c[0] * np.where(u > 0, np.maximum(u, LEAST_LOAD), 0.0) ** 3
    w = np.full(len(u), IDLE)
    for i in range(1, len(u)):
        w[i] = _driven(w[i - 1], pull[i - 1], c[1], course.time[i] - course.time[i - 1])
    return w


def _driven(w: float, pull: float, drag: float, seconds: float) -> float:
    """The speed after a time of constant torque, exactly."""
    end, rate = np.sqrt(pull / drag), np.sqrt(pull * drag) * seconds
    if end == 0:
        return float(w / (1 + drag * w * seconds))
    return float(end * (w + end * np.tanh(rate)) / (end + w * np.tanh(rate)))


def sarosi(rest: float) -> Callable[[Course, Array], Array]:
    """F = (c1 p + c2) exp(c3 k) + c4 k p + c5 p + c6: Sarosi 2012; p [bar], k contraction [0.1]."""

    def value(course: Course, c: Array) -> Array:
        p, k = course.inputs[:, 0] / 100, 10 * course.inputs[:, 1] / rest
        return np.asarray((c[0] * p + c[1]) * np.exp(c[2] * k) + c[3] * k * p + c[4] * p + c[5])

    return value


def hildebrandt(rest: float, branches: bool = False) -> Callable[[Course, Array], Array]:
    """F = p (c1 + c2 k + c3 k^2) - (c4 k^2 + c5 k + c6 + c7 k^(2/3)): Hildebrandt and others 2005, and dry friction."""

    def value(course: Course, c: Array) -> Array:
        p, k = course.inputs[:, 0] / 100, 10 * course.inputs[:, 1] / rest
        pull = p * (c[0] + c[1] * k + c[2] * k**2) - (
            c[3] * k**2 + c[4] * k + c[5] + c[6] * k ** (2 / 3)
        )
        if branches:
            pull = pull - c[7] * np.tanh(np.gradient(p, course.time) / 0.05)
        return np.asarray(pull)

    return value


TWINS = {"tunnel-in": "tunnel-out", "tunnel-out": "tunnel-in"}


def of_twin(course: Course) -> Course:
    """The course of the other one of two equal fans, as if it were one of this fan's."""
    swapped = course.inputs[:, [1, 0, *range(2, course.inputs.shape[1])]]
    return Course(course.name, course.time, swapped, course.measured, course.score_from)


_NONE = [np.inf] * 8
_SAROSI = ((-4.0, 290.0, -0.33, -9.0, 290.0, -280.0), _NONE[:6])
_HILDEBRANDT = ((250.0, -20.0, 1.0, 0.1, 0.1, 50.0, 10.0, 1.0), _NONE)


def formulas(rig: str) -> list[Formula]:
    """The formulas of a rig; the better one counts."""
    if rig.startswith("hose"):
        return [
            Formula(
                "time constants and dead times",
                hose,
                (0.1, 0.02, 0.1, 0.02),
                (1e-3, 0, 1e-3, 0),
                (9, 1, 9, 1),
            )
        ]
    if rig == "robot":
        return [
            Formula(
                "time constants",
                robot,
                (0.05, 0.05, 0.02, 0.02),
                (1e-3, 1e-3, 0, 0),
                (9, 9, 0.1, 0.1),
            )
        ]
    if "leak" in rig:
        return [Formula("exponential", decay, (600.0, 100.0), (1, 1e-2), (2000, 1e7))]
    if rig.startswith("tunnel"):
        load = 0 if rig == "tunnel-in" else 1
        return [
            Formula("model A2", lambda k, c: fan(k, c, load), (150.0, 1.5e-3), (1, 1e-5), (1e4, 1))
        ]
    if rig == "vessel":
        return [Formula("polytropic orifice", orifice, (0.8, 1.2), (0.3, 1.0), (1.2, 1.4))]
    rest = {"map-20": 296.0, "map-398": 398.0}.get(rig, 274.0)
    dynamic = rig.startswith("muscle")
    start = _HILDEBRANDT[0][: 8 if dynamic else 7]
    free = [np.inf] * len(start)
    listed = [
        Formula("Hildebrandt 2005", hildebrandt(rest, dynamic), start, [-f for f in free], free)
    ]
    if not dynamic:
        listed.append(Formula("Sarosi 2012", sarosi(rest), _SAROSI[0], [-np.inf] * 6, _SAROSI[1]))
    return listed


def predictions(
    formula: Formula, c: Array, courses: Mapping[str, Sequence[Course]]
) -> dict[str, dict[str, Array]]:
    """All courses by role."""
    return {role: {k.name: formula.value(k, c) for k in own} for role, own in courses.items()}
