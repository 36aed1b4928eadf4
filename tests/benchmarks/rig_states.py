"""States of the rig in which a form of an effect is asked what it gives."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.integrate import solve_ivp

from tests.reference.effects.base import Effect, Now, Rest
from tests.reference.flow import T_ATM

REST = Rest(0.0, 1e-4, T_ATM, (0.0, 0.0))


def now_at(
    x: float = 0.0, v: float = 0.0, p_gauge: float = 0.0, temperature: float = T_ATM, u: float = 0.0,
    flow: float = 0.0, heat: float = 0.0,
) -> Now:  # fmt: skip
    return Now(x, v, p_gauge, temperature, (u, 0.0), flow, heat)


def held(effect: Effect, now: Now, seconds: float, start: Sequence[float] | None = None) -> np.ndarray:
    """Own states after so long in the same state of the rig."""
    y = effect.initial(REST) if start is None else start
    return solve_ivp(lambda t, q: effect.rates(q, now), (0.0, seconds), y, method="LSODA", rtol=1e-9, atol=1e-12).y[
        :, -1
    ]
