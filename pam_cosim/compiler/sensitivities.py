"""Derivatives with respect to parameters as further states and outputs of a model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import casadi as ca

from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Variable, sensitivity_name
from pam_cosim.units import quotient


def with_sensitivities(ode: Ode, parameters: Sequence[str]) -> Ode:
    """The model with S = dx/ds as states behind its own and dy/ds as outputs behind its own.

    S' = df/dx S + df/ds and dy/ds = dh/dx S + dh/ds, exact; S(0) = dx0/ds.

    Args:
        ode: the model.
        parameters: names of s; that of a state stands for its start value, where a run sets one.

    Raises:
        InputError: the model has no such parameter, it is named twice, or it is the length of a delay, with which
            the solution does not change smoothly, or the delay of a record.
    """
    names = tuple(parameters)
    if not names:
        return ode
    _check(ode, names)
    chosen = sensitivity_symbols(replace(ode, sensitivities=names))
    x, s = ode.x, ca.SX.sym("S", ode.x.numel(), len(names))
    rates = ca.jacobian(ode.derivatives, x) @ s + ca.jacobian(ode.derivatives, chosen)
    slopes = ca.jacobian(ode.outputs, x) @ s + ca.jacobian(ode.outputs, chosen)
    interface = ode.interface
    by = interface.parameters | {state.name: state for state in ode.states}
    states = [_variable(state, by[n]) for state in ode.states for n in names]
    outputs = [_variable(output, by[n]) for output in interface.outputs.values() for n in names]
    return replace(
        ode,
        interface=replace(interface, outputs=interface.outputs | {v.name: v for v in outputs}),
        states=(*ode.states, *states),
        x=ca.vertcat(x, ca.vec(s.T)),
        derivatives=ca.vertcat(ode.derivatives, ca.vec(rates.T)),
        outputs=ca.vertcat(ode.outputs, ca.vec(slopes.T)),
        initial=ca.vertcat(ode.initial, ca.vec(ca.jacobian(ca.SX(ode.initial), chosen).T)),
        sensitivities=names,
    )


def smooth_parameters(ode: Ode) -> tuple[str, ...]:
    """Names of the parameters that ``with_sensitivities`` takes.

    A delay of the record is no part of the equations, which have no derivative with respect to it.
    """
    lengths = ca.vertcat(ca.SX(0, 1), *[ca.SX(delay.time) for delay in ode.delays])
    bound = set(ca.jacobian_sparsity(lengths, ode.p).get_col()) if ode.delays else set()
    late = ode.interface.record_delays
    return tuple(
        name
        for i, name in enumerate(ode.interface.parameters)
        if i not in bound and name not in late
    )


def sensitivity_symbols(ode: Ode) -> ca.SX:
    """(s,) what ``ode.sensitivities`` are with respect to; a start value stands in no equation."""
    parameters = {name: ode.p[i] for i, name in enumerate(ode.interface.parameters)}
    chosen = [
        parameters[n] if n in parameters else ca.SX.sym(f"start of {n}") for n in ode.sensitivities
    ]
    return ca.vertcat(ca.SX(0, 1), *chosen)


def _check(ode: Ode, names: tuple[str, ...]) -> None:
    names_in_model, smooth = (
        [*ode.interface.parameters, *(state.name for state in ode.states)],
        smooth_parameters(ode),
    )
    for i, name in enumerate(names):
        if name not in names_in_model:
            raise InputError(
                f"there is no parameter '{name}' to differentiate by", ode.interface.model
            )
        if name in names[:i]:
            raise InputError(f"parameter '{name}' is named twice", ode.interface.model)
        if name in ode.interface.record_delays:
            raise InputError(
                f"parameter '{name}' is the delay of a record, which stands in no equation of the model: there is no "
                "derivative with respect to it",
                ode.interface.model,
            )
        if name in ode.interface.parameters and name not in smooth:
            raise InputError(
                f"parameter '{name}' is the length of a delay: where an input jumps there is no derivative with "
                "respect to it",
                ode.interface.model,
            )


def _variable(of: Variable, by: Variable) -> Variable:
    size = (of.nominal or 1.0) / abs(by.nominal or by.start or 1.0)
    return Variable(
        sensitivity_name(of.name, by.name),
        quotient(of.unit, by.unit),
        f"Derivative of {of.name} with respect to {by.name}",
        nominal=size,
    )
