"""The functions of a model that an FMU's runtime calls, as expressions."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from pam_cosim.compiler.ode import Ode
from pam_cosim.compiler.sensitivities import sensitivity_symbols
from pam_cosim.errors import ModelError


def model_functions(ode: Ode, lean: bool = False) -> list[ca.Function]:
    """The functions the runtime calls, with the inputs and outputs listed in ``pam_model.h``.

    ``pam_check`` is there only where the model states something of itself; directional derivatives and the rates of
    sensitivities are not there in a ``lean`` model.

    Raises:
        ModelError: an expression holds a symbol that is neither time, state, input, delayed input nor parameter.
    """
    t, x, u, d, p = ode.t, ode.x, ode.u, ode.d, ode.p
    f, y, w = (ca.densify(ca.SX(e)) for e in (ode.derivatives, ode.outputs, ode.locals))
    x0 = ca.densify(ca.SX(ode.initial))
    delays = ca.vertcat(ca.SX(0, 1), *[ca.SX(delay.time) for delay in ode.delays])
    du, dd = ca.SX.sym("du", u.numel()), ca.SX.sym("dd", d.numel())
    known = [t, x, u, d, p]
    # One seed for everything at once: the derivative along (st, sx, su, sd, sp).
    seed = [
        ca.SX.sym(n, s.numel()) for n, s in zip(("st", "sx", "su", "sd", "sp"), known, strict=True)
    ]
    sp = seed[-1]
    core, own = f[: ode.core], x[: ode.core]
    chosen = sensitivity_symbols(ode)
    total = ca.jtimes(core, ca.vertcat(t, u, d), ca.vertcat(ca.SX(1), du, dd))
    conditions = ca.vertcat(ca.SX(0, 1), *[ca.SX(s.condition) for s in ode.statements])
    shown = ca.vertcat(
        ca.SX(0, 1), *[ca.SX(value) for s in ode.statements for value, _ in s.values]
    )
    check = [_function("pam_check", known, [conditions, shown])] if ode.statements else []
    return [
        *([] if lean else [_function("pam_rhs", known, [f])]),
        _function("pam_out", known, [y]),
        _function("pam_loc", known, [w]),
        _function("pam_core_rhs", [t, own, u, d, p], [core]),
        _function("pam_lin", [t, own, u, d, du, dd, p], [core, ca.jacobian(core, own), total]),
        _function(
            "pam_variation",
            [t, own, u, d, p],
            [ca.jacobian(core, own), ca.jacobian(core, chosen).T],
        ),
        _function("pam_init", [p, u], [x0]),
        _function("pam_delay", [p, sp], [delays, ca.jtimes(delays, p, sp)]),
        *check,
        *([] if lean else _directional(known, seed, (f, y, w), x0)),
        *(
            _at_start(ode, [t, own, u, d, du, dd, p], chosen, None if lean else seed)
            if ode.following
            else []
        ),
    ]


def _at_start(
    ode: Ode, given: Sequence[ca.SX], chosen: ca.SX, seed: Sequence[ca.SX] | None
) -> list[ca.Function]:
    """As ``pam_lin``, ``pam_variation`` and ``pam_jvp``, of what vanishes where the model begins."""
    (t, own, u, d, du, dd, p), rates = given, ode.start_rates
    total = ca.jtimes(rates, ca.vertcat(t, u, d), ca.vertcat(ca.SX(1), du, dd))
    slopes = ca.jacobian(rates, own)
    known = [t, ode.x, u, d, p]
    along = [] if seed is None else [ca.jtimes(rates, ca.vertcat(*known), ca.vertcat(*seed))]
    return [
        _function("pam_start_lin", given, [rates, slopes, total]),
        _function("pam_start_variation", [t, own, u, d, p], [slopes, ca.jacobian(rates, chosen).T]),
        *([] if seed is None else [_function("pam_start_jvp", [*known, *seed], along)]),
    ]


def _directional(
    known: Sequence[ca.SX], seed: Sequence[ca.SX], of: Sequence[ca.SX], start: ca.SX
) -> list[ca.Function]:
    """Derivatives along a seed, of what is computed of everything known, and of the initial states."""
    told, moved = (known[-1], known[2]), (seed[-1], seed[2])  # parameters and inputs
    along = [ca.jtimes(e, ca.vertcat(*known), ca.vertcat(*seed)) for e in of]
    return [
        _function("pam_jvp", [*known, *seed], along),
        _function(
            "pam_init_jvp",
            [*told, *moved],
            [ca.jtimes(start, ca.vertcat(*told), ca.vertcat(*moved))],
        ),
    ]


def _function(name: str, inputs: Sequence[ca.SX], outputs: Sequence[ca.SX]) -> ca.Function:
    dense = [ca.densify(output) for output in ca.cse(list(outputs))]
    symbols = ca.symvar(ca.vertcat(*[ca.vec(output) for output in dense]))
    known = {str(s) for i in inputs for s in ca.symvar(i)}
    foreign = [str(s) for s in symbols if str(s) not in known]
    if foreign:
        raise ModelError(f"the model's equations use {', '.join(foreign)}, which has no value here")
    return ca.Function(name, list(inputs), dense)
