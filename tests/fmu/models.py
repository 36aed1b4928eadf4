"""Small ODEs whose behaviour is known, written by hand."""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from pam_cosim.compiler.ode import Ode
from pam_cosim.interface import Interface, Variable


def named(*variables: Variable) -> dict[str, Variable]:
    return {v.name: v for v in variables}


def ode(
    model: str,
    states: Mapping[str, tuple[ca.SX, ca.SX, ca.SX | float]],
    outputs: Mapping[str, ca.SX],
    *,
    inputs: Mapping[str, ca.SX] | None = None,
    parameters: Mapping[str, tuple[ca.SX, float]] | None = None,
    local: Mapping[str, ca.SX] | None = None,
    t: ca.SX | None = None,
    variables: Mapping[str, Variable] | None = None,
    stop_time: float = 10.0,
) -> Ode:
    """States are (symbol, derivative, start), parameters (symbol, value); other variables have no unit."""
    inputs, parameters, local, variables = inputs or {}, parameters or {}, local or {}, variables or {}

    def variable(name: str, start: float | None = None) -> Variable:
        return variables.get(name, Variable(name, start=start))

    face = Interface(
        model,
        named(*(variable(n, 0.0) for n in inputs)),
        named(*(variable(n) for n in outputs)),
        named(*(variable(n, v) for n, (_, v) in parameters.items())),
        named(*(variable(n) for n in local)),
        stop_time=stop_time,
        interval=stop_time / 100,
    )
    return Ode(
        face,
        tuple(variable(n) for n in states),
        ca.SX.sym("t") if t is None else t,
        ca.vertcat(*[s for s, _, _ in states.values()]) if states else ca.SX(0, 1),
        ca.vertcat(*inputs.values()) if inputs else ca.SX(0, 1),
        ca.vertcat(*[s for s, _ in parameters.values()]) if parameters else ca.SX(0, 1),
        ca.vertcat(*[f for _, f, _ in states.values()]) if states else ca.SX(0, 1),
        ca.vertcat(*outputs.values()) if outputs else ca.SX(0, 1),
        ca.vertcat(*local.values()) if local else ca.SX(0, 1),
        ca.SX(ca.vertcat(*[x0 for _, _, x0 in states.values()])) if states else ca.SX(0, 1),
        description=f"Test model {model}",
    )


def van_der_pol() -> Ode:
    """Stiff: mu = 1000, in the scaled time of Hairer and Wanner."""
    x, v, mu = ca.SX.sym("x"), ca.SX.sym("v"), ca.SX.sym("mu")
    return ode(
        "Test.VanDerPol",
        {"x": (x, v, 2.0), "v": (v, mu * ((1 - x**2) * v - x), 0.0)},
        {"y": x},
        parameters={"mu": (mu, 1000.0)},
        local={"power": x * v},
        stop_time=2.0,
    )


def lag() -> Ode:
    """x' = (u - x)/tau with feedthrough output; the start value is a parameter."""
    x, u, tau, start = ca.SX.sym("x"), ca.SX.sym("u"), ca.SX.sym("tau"), ca.SX.sym("x_start")
    return ode(
        "Test.Lag",
        {"x": (x, (u - x) / tau, start)},
        {"y": x, "feed": u + 2 * x},
        inputs={"u": u},
        parameters={"tau": (tau, 0.5), "x_start": (start, 0.0)},
        stop_time=5.0,
    )
