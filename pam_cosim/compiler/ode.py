"""The product of the compiler: an explicit ODE with exact symbolic expressions."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from pam_cosim.interface import Interface, Variable


@dataclass(frozen=True)
class Ode:
    """dx/dt = f(t, x, u, p), y = h(t, x, u, p), x(0) = x0(p).

    Attributes:
        interface: names, units, defaults of inputs, outputs, parameters and locals.
        states: the state variables, in the order of ``x``.
        t, x, u, p: CasADi SX symbols, column vectors ordered like ``states``,
            ``interface.inputs`` and ``interface.parameters``.
        derivatives: f, same order as ``x``.
        outputs: h, ordered like ``interface.outputs``.
        locals: algebraic variables, ordered like ``interface.locals``.
        initial: x0 as a function of ``p`` only.
        description: the model's own one-line description.
    """

    interface: Interface
    states: tuple[Variable, ...]
    t: ca.SX
    x: ca.SX
    u: ca.SX
    p: ca.SX
    derivatives: ca.SX
    outputs: ca.SX
    locals: ca.SX
    initial: ca.SX
    description: str = ""
