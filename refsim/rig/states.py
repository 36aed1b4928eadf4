"""States of the rig in which a form of an effect is asked what it gives."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.integrate import solve_ivp

from rig.effect import Effect, Now, Rest
from rig.flow import T_ATM
from rig.integrate import Array

REST = Rest(0.0, 1e-4, T_ATM, (0.0, 0.0))


def now_at(
    x: float = 0.0, v: float = 0.0, p_gauge: float = 0.0, temperature: float = T_ATM, u: float = 0.0,
    flow: float = 0.0, heat: float = 0.0,
) -> Now:  # fmt: skip
    """A state of the rig; what is not said is as at rest. Units as in `Now`, u: current of the inlet valve [A]."""
    return Now(x, v, p_gauge, temperature, (u, 0.0), flow, heat)


def held(effect: Effect, now: Now, seconds: float, start: Sequence[float] | None = None) -> Array:
    """Own states after so long in the same state of the rig, shape (states,)."""
    y = effect.initial(REST) if start is None else start
    options = {"method": "LSODA", "rtol": 1e-9, "atol": 1e-12}
    solution = solve_ivp(lambda t, q: effect.rates(q, now), (0.0, seconds), y, **options)
    return np.asarray(solution.y[:, -1], dtype=float)
