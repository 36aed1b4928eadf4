"""The trajectory of a model for model exchange, by a solver of SciPy with the FMU's exact Jacobian."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.arrays import Array
from pam_cosim.simulation.failure import RunFailure

RELATIVE_TOLERANCE = 1e-8
# The second, implicit throughout and slower, is for states that the first cannot pass.
_METHODS = ("LSODA", "Radau")

InputFunction = Callable[[float], Array]


def constant_input(inputs: Array) -> InputFunction:
    """Constant inputs (m,)."""
    return lambda _: inputs


def flow(
    model: ExchangeModel,
    start: Array,
    times: Array,
    inputs: InputFunction,
    tolerance: float = RELATIVE_TOLERANCE,
) -> Array:
    """States (n, k) at increasing times (k,) [s], from ``start`` (n,) at the first of them.

    Args:
        model: initialised.
        start: (n,) state.
        times: (k,) [s].
        inputs: (m,) at a time [s], smooth between the first and the last time.
        tolerance: relative; absolutely a hundredth of it, in nominal sizes of the states.

    Raises:
        SimulationFailure: no solver gets to the end.
    """
    if not model.states:
        return np.zeros((0, len(times)))
    floor = 0.01 * tolerance * np.array([model.scale(name) for name in model.states])

    def rates(t: float, x: Array) -> Array:
        try:
            model.set(t, x, inputs(t))
            return model.rates()
        except (
            RunFailure
        ):  # a trial step beyond what the model can say; the solver tries a shorter one
            return np.full(len(x), np.nan)

    def jacobian(t: float, x: Array) -> Array:
        model.set(t, x, inputs(t))
        return model.jacobian(model.rate_names, model.states)[0]

    message = ""
    for method in _METHODS:
        try:
            solution = solve_ivp(
                rates,
                (times[0], times[-1]),
                start,
                method,
                times,
                rtol=tolerance,
                atol=floor,
                jac=jacobian,
            )
        except (
            RunFailure,
            ValueError,
        ) as error:  # SciPy raises ValueError where a Jacobian is not finite
            message = str(error)
            continue
        if solution.success and np.isfinite(solution.y).all():
            return np.asarray(solution.y, dtype=float)
        message = str(solution.message)
    raise RunFailure(
        f"the integration failed from {times[0]:.6g} s to {times[-1]:.6g} s: {message}", model.time
    )
