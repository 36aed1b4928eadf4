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
    arguments = [t, x, u, d, p]
    # One seed for everything at once: the derivative along (st, sx, su, sd, sp).
    seed = [
        ca.SX.sym(n, s.numel())
        for n, s in zip(("st", "sx", "su", "sd", "sp"), arguments, strict=True)
    ]
    sp = seed[-1]
    core, core_states = f[: ode.core], x[: ode.core]
    chosen = sensitivity_symbols(ode)
    total = ca.jtimes(core, ca.vertcat(t, u, d), ca.vertcat(ca.SX(1), du, dd))
    conditions = ca.vertcat(ca.SX(0, 1), *[ca.SX(s.condition) for s in ode.statements])
    shown = ca.vertcat(
        ca.SX(0, 1), *[ca.SX(value) for s in ode.statements for value, _ in s.values]
    )
    check = [_function("pam_check", arguments, [conditions, shown])] if ode.statements else []
    return [
        *([] if lean else [_function("pam_rhs", arguments, [f])]),
        _function("pam_out", arguments, [y]),
        _function("pam_loc", arguments, [w]),
        _function("pam_core_rhs", [t, core_states, u, d, p], [core]),
        _function(
            "pam_lin",
            [t, core_states, u, d, du, dd, p],
            [core, ca.jacobian(core, core_states), total],
        ),
        _function(
            "pam_variation",
            [t, core_states, u, d, p],
            [ca.jacobian(core, core_states), ca.jacobian(core, chosen).T],
        ),
        _function("pam_init", [p, u], [x0]),
        _function("pam_delay", [p, sp], [delays, ca.jtimes(delays, p, sp)]),
        *check,
        *([] if lean else _directional(arguments, seed, (f, y, w), x0)),
        *(
            _at_start(ode, [t, core_states, u, d, du, dd, p], chosen, None if lean else seed)
            if ode.following
            else []
        ),
    ]


def _at_start(
    ode: Ode, given: Sequence[ca.SX], chosen: ca.SX, seed: Sequence[ca.SX] | None
) -> list[ca.Function]:
    """As ``pam_lin``, ``pam_variation`` and ``pam_jvp``, of what vanishes where the model begins."""
    (t, core_states, u, d, du, dd, p), rates = given, ode.start_rates
    total = ca.jtimes(rates, ca.vertcat(t, u, d), ca.vertcat(ca.SX(1), du, dd))
    slopes = ca.jacobian(rates, core_states)
    arguments = [t, ode.x, u, d, p]
    along = [] if seed is None else [ca.jtimes(rates, ca.vertcat(*arguments), ca.vertcat(*seed))]
    return [
        _function("pam_start_lin", given, [rates, slopes, total]),
        _function(
            "pam_start_variation", [t, core_states, u, d, p], [slopes, ca.jacobian(rates, chosen).T]
        ),
        *([] if seed is None else [_function("pam_start_jvp", [*arguments, *seed], along)]),
    ]


def _directional(
    arguments: Sequence[ca.SX], seed: Sequence[ca.SX], of: Sequence[ca.SX], start: ca.SX
) -> list[ca.Function]:
    """Derivatives along a seed, of what is computed of everything known, and of the initial states."""
    exogenous, exogenous_seed = (
        (arguments[-1], arguments[2]),
        (seed[-1], seed[2]),
    )  # parameters and inputs
    along = [ca.jtimes(e, ca.vertcat(*arguments), ca.vertcat(*seed)) for e in of]
    return [
        _function("pam_jvp", [*arguments, *seed], along),
        _function(
            "pam_init_jvp",
            [*exogenous, *exogenous_seed],
            [ca.jtimes(start, ca.vertcat(*exogenous), ca.vertcat(*exogenous_seed))],
        ),
    ]


def _function(name: str, inputs: Sequence[ca.SX], outputs: Sequence[ca.SX]) -> ca.Function:
    dense = [ca.densify(output) for output in ca.cse(list(outputs))]
    symbols = ca.symvar(ca.vertcat(*[ca.vec(output) for output in dense]))
    names = {str(s) for i in inputs for s in ca.symvar(i)}
    foreign = [str(s) for s in symbols if str(s) not in names]
    if foreign:
        raise ModelError(f"the model's equations use {', '.join(foreign)}, which has no value here")
    return ca.Function(name, list(inputs), dense)
