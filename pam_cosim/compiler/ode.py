"""The product of the compiler: an explicit ODE with exact symbolic expressions."""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca

from pam_cosim.compiler.part import Part
from pam_cosim.model.interface import Interface, Variable


@dataclass(frozen=True)
class Delay:
    """An input as it was some time ago: ``u[input](t - time)``, and its value at the start where that is earlier.

    Attributes:
        input: position of the input in ``Ode.u``; None: a signal that is 0 until the start and 1 from then on.
        time: the delay [s], an expression of ``Ode.p``.
    """

    input: int | None
    time: ca.SX


@dataclass(frozen=True)
class Statement:
    """An assertion of the model, and its message.

    Attributes:
        condition: 0 where it does not hold; an expression like the outputs.
        texts: the message's parts, one more than there are values between them.
        values: the numbers in the message, expressions like the outputs, each with its significant digits.
        is_error: whether the run ends there; otherwise it is warned once.
        at_start: whether it is asked at the start alone.
    """

    condition: ca.SX
    texts: tuple[str, ...]
    values: tuple[tuple[ca.SX, int], ...] = ()
    is_error: bool = True
    at_start: bool = False


@dataclass(frozen=True)
class Ode:
    """dx/dt = f(t, x, u, d, p), y = h(t, x, u, d, p), x(0) = x0(p, u(0)).

    Attributes:
        interface: names, units, defaults of inputs, outputs, parameters and locals.
        states: the state variables, in the order of ``x``.
        t, x, u, p: CasADi SX symbols, column vectors ordered like ``states``,
            ``interface.inputs`` and ``interface.parameters``.
        derivatives: f, same order as ``x``.
        outputs: h, ordered like ``interface.outputs``.
        locals: algebraic variables, ordered like ``interface.locals``.
        initial: x0 as a function of ``p`` and ``u``.
        description: the model's own one-line description.
        d: symbols of the delayed inputs, a column vector; empty in a model without ``delay``.
        delays: what each element of ``d`` stands for.
        sensitivities: parameters with respect to which the states' derivatives follow the states in ``x``: state by
            state, each by these parameters in order.
        parts: the components of the model that are no variables, with the classes that they consist of.
        libraries: packages that the model is made of, with their versions.
        statements: what must hold while the model runs.
        resting: names of the states that begin at rest, where their rates vanish at the initial values of
            the others and the first inputs; ``initial`` has the values from which that is sought.
        following: names of states that begin where those at rest are, and their initial values in terms of these too.
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
    d: ca.SX = field(default_factory=lambda: ca.SX(0, 1))
    delays: tuple[Delay, ...] = ()
    sensitivities: tuple[str, ...] = ()
    parts: tuple[Part, ...] = ()
    libraries: tuple[tuple[str, str], ...] = ()
    statements: tuple[Statement, ...] = ()
    resting: tuple[str, ...] = ()
    following: tuple[tuple[str, ca.SX], ...] = ()

    @property
    def core(self) -> int:
        """How many of the states are the model's own; those after them are sensitivities."""
        return len(self.states) // (1 + len(self.sensitivities))

    @property
    def start_rates(self) -> ca.SX:
        """What vanishes at the start, of the states that rest and of those that follow them; else the derivatives."""
        follows, rates = dict(self.following), ca.vertsplit(ca.SX(self.derivatives[: self.core]))
        conditions = [
            follows[s.name] - self.x[i] if s.name in follows else rates[i]
            for i, s in enumerate(self.states[: self.core])
        ]
        return ca.vertcat(ca.SX(0, 1), *conditions)
