"""The exact course of a case, by a solver that is not ours: SciPy's on CasADi's functions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from benchmarks.speed.cases import Case

Array = NDArray[np.float64]
Method = Literal["DOP853", "Radau"]
TOLERANCE = 1e-12


@dataclass(frozen=True)
class Reference:
    """Values at the output points of a case.

    Attributes:
        states, outputs: (n, states) and (n, outputs) [SI].
        evaluations: of the right-hand side.
    """

    states: Array
    outputs: Array
    evaluations: int


def reference(case: Case, method: Method = "DOP853") -> Reference:
    """Integrates from each bend or step of the inputs to the next, in states divided by their nominal values.

    DOP853 has dense output of the seventh order; Radau's is of the third, therefore Radau stops at every output
    point, which takes minutes.
    """
    right, measured, slope = _functions(case)
    begins, values, slopes = case.lines()
    times, scale = case.times, case.nominals
    states, outputs = np.empty((times.size, scale.size)), np.empty((times.size, len(case.outputs)))
    state, evaluations = case.start / scale, 0
    ends = np.append(begins[1:], max(case.end, begins[-1]))
    for begin, end, value, rate in zip(begins, ends, values, slopes, strict=True):
        last = end >= case.end
        here = np.flatnonzero((times >= begin) & ((times <= end) if last else (times < end)))

        def u(t: float, begin: float = begin, value: Array = value, rate: Array = rate) -> Array:
            return value + rate * (t - begin)

        if scale.size:
            stops = np.append(times[here], [] if last else [end])
            states_at_stops, work = _solve(
                case, right, slope, u, (begin, end), state, stops, method
            )
            states[here] = states_at_stops[: here.size] * scale
            state, evaluations = states_at_stops[-1], evaluations + work
        for i in here:
            outputs[i] = measured(times[i], states[i], u(times[i]), case.parameters).full().ravel()
        if last:
            break
    return Reference(states, outputs, evaluations)


def _functions(case: Case) -> tuple[ca.Function, ca.Function, ca.Function]:
    ode = case.ode
    scaled = ca.SX.sym("z", ode.x.numel())
    derivative = ca.substitute(ode.derivatives, ode.x, scaled * case.nominals) / case.nominals
    known = [ode.t, scaled, ode.u, ode.p]
    return (
        ca.Function("right", known, [derivative]),
        ca.Function("measured", [ode.t, ode.x, ode.u, ode.p], [ode.outputs]),
        ca.Function("slope", known, [ca.jacobian(derivative, scaled)]),
    )


def _solve(
    case: Case,
    right: ca.Function,
    slope: ca.Function,
    u: Callable[[float], Array],
    span: tuple[float, float],
    state: Array,
    stops: Array,
    method: Method,
) -> tuple[Array, int]:
    """States at ``stops``, of which the last is the end; number of evaluations."""

    def f(t: float, z: Array) -> Array:
        rate: Array = right(t, z, u(t), case.parameters).full().ravel()
        return rate

    if method == "DOP853":
        # Steps much shorter than the output points, because dense output is worse than the steps where stability
        # rather than accuracy limits these.
        longest = case.end / case.count / 4
        run = solve_ivp(
            f, span, state, method=method, rtol=TOLERANCE, atol=TOLERANCE, t_eval=stops, max_step=longest
        )  # fmt: skip
        assert run.success, run.message
        return run.y.T, run.nfev
    states, now, work = [], span[0], 0
    for stop in stops:
        if stop > now:
            run = solve_ivp(
                f, (now, stop), state, method=method, rtol=TOLERANCE, atol=TOLERANCE,
                jac=lambda t, z: slope(t, z, u(t), case.parameters).full(),
            )  # fmt: skip
            assert run.success, run.message
            state, now, work = run.y[:, -1], stop, work + run.nfev
        states.append(state)
    return np.array(states), work
