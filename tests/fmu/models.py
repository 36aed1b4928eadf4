"""Small ODEs whose behaviour is known, written by hand."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path

import casadi as ca

from pam_cosim.compiler.ode import Delay, Ode
from pam_cosim.fmu import build_fmu
from pam_cosim.model.interface import Interface, Variable


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
    delayed: Sequence[tuple[ca.SX, Delay]] = (),
) -> Ode:
    """States are (symbol, derivative, start), parameters (symbol, value); other variables have no unit."""
    inputs, parameters, local, variables = (
        inputs or {},
        parameters or {},
        local or {},
        variables or {},
    )

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
        d=ca.vertcat(ca.SX(0, 1), *[symbol for symbol, _ in delayed]),
        delays=tuple(delay for _, delay in delayed),
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


def ramp_driven() -> Ode:
    """Two states in a chain, driven by two inputs, with known solution for straight inputs."""
    x, z, u, v = (ca.SX.sym(n) for n in ("x", "z", "u", "v"))
    return ode(
        "Test.Ramp",
        {"x": (x, u - x, 0.0), "z": (z, v, 0.0)},
        {"x_out": x, "z_out": z},
        inputs={"u": u, "v": v},
    )


def algebraic() -> Ode:
    """No states at all."""
    u, k, t = ca.SX.sym("u"), ca.SX.sym("k"), ca.SX.sym("t")
    return ode("Test.Gain", {}, {"y": k * u + t}, inputs={"u": u}, parameters={"k": (k, 3.0)}, t=t)


def breaks_down() -> Ode:
    """x' = -sqrt(x - floor), which leaves the real numbers at a time that the parameter sets."""
    x, floor = ca.SX.sym("x"), ca.SX.sym("floor")
    states = {"tank.x": (x, -1 - ca.sqrt(x - floor), 1.0)}
    return ode("Test.Break", states, {"y": x}, parameters={"floor": (floor, 0.5)})


def forced() -> Ode:
    """Nonlinear and dependent on time: x = exp(sin t), v = tan-free rotation driven by x."""
    x, v, t = ca.SX.sym("x"), ca.SX.sym("v"), ca.SX.sym("t")
    return ode(
        "Test.Forced",
        {"x": (x, x * ca.cos(t), 1.0), "v": (v, -(v**2) * x * (1 + ca.sin(t) ** 2), 1.0)},
        {"y": x},
        t=t,
        stop_time=3.0,
    )


def oscillator() -> Ode:
    """An output that is a state, a state that is another's derivative, units, display units, limits."""
    s, v, k, m = (ca.SX.sym(n) for n in ("s", "der(s)", "k", "m"))
    return ode(
        "Test.Oscillator",
        {"s": (s, v, 0.1), "der(s)": (v, -k / m * s, 0.0)},
        {"s": s, "F": -k * s},
        parameters={"k": (k, 0.1 + 0.2), "m": (m, 1 / 3)},
        local={"E": k * s**2 / 2 + m * v**2 / 2, "s": s, "T": ca.SX(293.15)},
        variables={
            "s": Variable(
                "s", "m", "deflection & <more>", nominal=0.1, display_unit="mm", quantity="Length"
            ),
            "der(s)": Variable("der(s)", "m/s"),
            "F": Variable("F", "N"),
            "k": Variable("k", "N/m", "stiffness", start=0.1 + 0.2, min=0.0, max=1e3),
            "m": Variable("m", "kg", start=1 / 3, min=1e-9),
            "E": Variable("E", "J"),
            "T": Variable("T", "K", display_unit="degC"),
        },
    )


def delayed_lag() -> Ode:
    """x' = (u(t - T) - x)/tau, and the delayed input itself."""
    x, u, d, tau, delay = (ca.SX.sym(n) for n in ("x", "u", "d", "tau", "T"))
    return ode(
        "Test.DelayedLag",
        {"x": (x, (d - x) / tau, 0.0)},
        {"y": x, "echo": d},
        inputs={"u": u},
        parameters={"tau": (tau, 0.5), "T": (delay, 0.3)},
        stop_time=5.0,
        delayed=[(d, Delay(0, delay))],
    )


def delayed_start() -> Ode:
    """As ``delayed_lag``; what arrives before the start's own delay is over is -1."""
    x, u, d, begun, delay = (ca.SX.sym(n) for n in ("x", "u", "d", "begun", "T"))
    late = ca.if_else(begun > 0.5, d, -1)
    return ode(
        "Test.DelayedStart",
        {"x": (x, (late - x) / 0.5, 0.0)},
        {"y": x, "echo": late},
        inputs={"u": u},
        parameters={"T": (delay, 0.3)},
        stop_time=5.0,
        delayed=[(d, Delay(0, delay)), (begun, Delay(None, delay))],
    )


def delayed_gain() -> Ode:
    """No states; the sum of an input and of what it was."""
    u, d, delay = (ca.SX.sym(n) for n in ("u", "d", "T"))
    return ode("Test.DelayedGain", {}, {"y": u + 10 * d}, inputs={"u": u}, parameters={"T": (delay, 0.3)},
               delayed=[(d, Delay(0, delay))])  # fmt: skip


def delayed_mix() -> Ode:
    """Nonlinear: one input acts at once and twice delayed, another delayed only."""
    x, z, u, v, d, e, g, delay = (ca.SX.sym(n) for n in ("x", "z", "u", "v", "d", "e", "g", "T"))
    return ode(
        "Test.DelayedMix",
        {"x": (x, d - x**3 + ca.sin(e), 0.2), "z": (z, u * g - z * ca.fabs(x), 1.0)},
        {"x_out": x, "z_out": z},
        inputs={"u": u, "v": v},
        parameters={"T": (delay, 0.3)},
        delayed=[(d, Delay(0, delay)), (e, Delay(1, 0.1 + delay / 2)), (g, Delay(0, 2 * delay))],
    )


_FOLDER = tempfile.TemporaryDirectory(prefix="pam-cosim-tests-")


def folder() -> Path:
    """Where models are built; it goes when the session ends."""
    return Path(_FOLDER.name)


@cache
def fmu(make: Callable[[], Ode], fmi: str = "2.0") -> Path:
    """The FMU of one of these models, built once per session."""
    return build_fmu(make(), folder() / f"{make.__name__}-{fmi}.fmu", fmi=fmi)
