"""Evaluate and integrate an Ode with SciPy."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp

from pam_cosim.compiler import Ode, compile_model

MODELS = Path(__file__).parent / "models"
WRONG = Path(__file__).parent / "wrong"


def compiled(model: str) -> Ode:
    return compile_model(model, root=MODELS)


def defaults(ode: Ode, changed: Mapping[str, float] | None = None) -> np.ndarray:
    values = {name: variable.start for name, variable in ode.interface.parameters.items()}
    assert not changed or set(changed) <= set(values)
    return np.array([*(values | dict(changed or {})).values()], dtype=float)


def initial(
    ode: Ode, changed: Mapping[str, float] | None = None, u: Sequence[float] = ()
) -> dict[str, float]:
    inputs = list(u) or [variable.start or 0.0 for variable in ode.interface.inputs.values()]
    values = (
        ca.Function("initial", [ode.p, ode.u], [ode.initial])(defaults(ode, changed), inputs)
        .full()
        .ravel()
    )
    return {state.name: float(value) for state, value in zip(ode.states, values, strict=True)}


def at(
    ode: Ode,
    x: Mapping[str, float] | None = None,
    u: Sequence[float] = (),
    p: Mapping[str, float] | None = None,
    t: float = 0.0,
    d: Sequence[float] = (),
) -> dict[str, float]:
    """Derivatives (as ``der(name)``), outputs and locals at one point; states as given, else initial."""
    state = initial(ode, p) | dict(x or {})
    arguments = [ode.t, ode.x, ode.u, ode.d, ode.p]
    function = ca.Function("at", arguments, [ode.derivatives, ode.outputs, ode.locals])
    columns = function(t, list(state.values()), list(u), list(d), defaults(ode, p))
    names = [
        [f"der({variable.name})" for variable in ode.states],
        list(ode.interface.outputs),
        list(ode.interface.locals),
    ]
    pairs = [zip(n, v.full().ravel(), strict=True) for n, v in zip(names, columns, strict=True)]
    return {name: float(value) for pair in pairs for name, value in pair} | state


def simulate(
    ode: Ode,
    times: Sequence[float],
    u: Callable[[float], Sequence[float]] = lambda t: (),
    p: Mapping[str, float] | None = None,
) -> dict[str, np.ndarray]:
    """States at the given times; relative tolerance 1e-10."""
    function = ca.Function("f", [ode.t, ode.x, ode.u, ode.p], [ode.derivatives])
    values = defaults(ode, p)
    solution = solve_ivp(
        lambda t, x: function(t, x, list(u(t)), values).full().ravel(),
        (0, times[-1]),
        list(initial(ode, p).values()),
        method="LSODA",
        t_eval=times,
        rtol=1e-10,
        atol=1e-12,
    )
    assert solution.success
    return {state.name: row for state, row in zip(ode.states, solution.y, strict=True)}
