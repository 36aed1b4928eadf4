"""The right-hand side of a compiled model and its slopes as numbers, at many points at once."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.compiler import Ode
from pam_cosim.ledger.grid import Grid
from pam_cosim.ledger.rest import settled

_FEW = 64  # rows, up to which a function for so many is kept


class Slopes(NamedTuple):
    """Values at K points, and derivatives by states, unknown inputs and free parameters, each (K, rows, columns)."""

    value: Array
    by_state: Array
    by_unknown_input: Array
    by_parameter: Array


class Model:
    """f and h of an ``Ode`` for many points; unknown inputs and free parameters are elements of its p."""

    def __init__(
        self, ode: Ode, unknown_inputs: Sequence[str], free: Sequence[str], signals: Sequence[str]
    ) -> None:
        names = list(ode.interface.parameters)
        self.ode = ode
        self.states, self.unknown_inputs, self.free = (
            len(ode.states),
            len(unknown_inputs),
            len(free),
        )
        self.unknown_at = [names.index(u) for u in unknown_inputs]
        self.free_at = [names.index(f) for f in free]
        outputs = list(ode.interface.outputs)
        h = ca.vertcat(ca.SX(0, 1), *[ode.outputs[outputs.index(s)] for s in signals])
        self.outputs = h.shape[0]
        arguments = [ode.t, ode.x, ode.u, ode.d, ode.p]
        by = ca.vertcat(ode.x, *[ode.p[i] for i in [*self.unknown_at, *self.free_at]])
        f = ode.derivatives
        self._rates = _AtPoints("rates", arguments, [f, ca.jacobian(f, by)])
        rates_and_outputs = ca.vertcat(f, h)
        self._all = _AtPoints(
            "all", arguments, [rates_and_outputs, ca.jacobian(rates_and_outputs, by)]
        )
        begin = ode.start_rates
        self._start_rates = _AtPoints("begin", arguments, [begin, ca.jacobian(begin, ode.x)])
        self._initial = ca.Function("initial", [ode.p, ode.u], [ode.initial])
        self._locals = _AtPoints("others", arguments, [ca.vertcat(ode.outputs, ode.locals)])

    def initial(self, parameters: Array, grid: Grid) -> Array:
        """States at the starts of the runs, (R, n), with parameters (R, P) under the first inputs.

        Those that the grid has as numbers stay; those of a model that begins at rest come to rest with them.
        """
        nodes = grid.first[:-1]
        inputs = grid.node_inputs[nodes]
        own_states = [
            np.array(self._initial(p, u)).ravel() for p, u in zip(parameters, inputs, strict=True)
        ]
        begin = np.where(np.isnan(grid.starts), np.array(own_states), grid.starts)
        settled_states = {*self.ode.resting, *(name for name, _ in self.ode.following)}
        rests = np.isnan(grid.starts) & np.array(
            [s.name in settled_states for s in self.ode.states], dtype=bool
        )
        size = np.array([s.nominal or 1.0 for s in self.ode.states])
        for run in np.flatnonzero(rests.any(axis=1)).tolist():
            at, p = slice(nodes[run], nodes[run] + 1), parameters[run : run + 1]
            place = grid.time[at], grid.node_inputs[at], grid.node_delayed[at], p
            begin[run] = settled(partial(self._rates_at, *place), begin[run], rests[run], size)
        return begin

    def _rates_at(self, t: Array, u: Array, d: Array, p: Array, x: Array) -> tuple[Array, Array]:
        value, by = self._start_rates(t, x[None], u, d, p)
        return value.reshape(-1), by.reshape(self.states, self.states).T

    def rates(self, t: Array, x: Array, u: Array, d: Array, p: Array) -> Slopes:
        """Rates of the states at K points [SI/s].

        Args:
            t: (K,) times [s].
            x: (K, n) states [SI].
            u: (K, U) inputs [SI].
            d: (K, D) delayed inputs [SI].
            p: (K, P) parameters [SI].

        Returns:
            values (K, n) and their derivatives (K, n, columns).
        """
        return self._slopes(self._rates, self.states, t, x, u, d, p)

    def everything(self, t: Array, x: Array, u: Array, d: Array, p: Array) -> Slopes:
        """Rates of the states, and below them the S signals, at K points [SI].

        Arguments as for ``rates``; values (K, n + S) and their derivatives (K, n + S, columns).
        """
        return self._slopes(self._all, self.states + self.outputs, t, x, u, d, p)

    def variables(self, t: Array, x: Array, u: Array, d: Array, p: Array) -> dict[str, Array]:
        """Every output and local variable, (K,) each, by name."""
        names = [*self.ode.interface.outputs, *self.ode.interface.locals]
        (values,) = self._locals(t, x, u, d, p)
        return dict(zip(names, values.T.copy(), strict=True))

    def _slopes(
        self, f: _AtPoints, rows: int, t: Array, x: Array, u: Array, d: Array, p: Array
    ) -> Slopes:
        value, jacobian = f(t, x, u, d, p)
        columns = self.states + self.unknown_inputs + self.free
        slopes = jacobian.reshape(len(t), columns, rows).transpose(0, 2, 1)
        a, b = self.states, self.states + self.unknown_inputs
        return Slopes(value, slopes[:, :, :a], slopes[:, :, a:b], slopes[:, :, b:])


class _AtPoints:
    """A function of vectors for the rows of arrays, in place: a ledger asks for few rows very often."""

    def __init__(self, name: str, arguments: Sequence[ca.SX], results: Sequence[ca.SX]) -> None:
        dense = [ca.vec(ca.densify(result)) for result in results]
        self._function = ca.Function(name, list(arguments), dense, {"cse": True})
        self._sizes = [result.numel() for result in dense]
        self._few: dict[int, tuple[Any, Any]] = {}

    def __call__(self, *arguments: Array) -> list[Array]:
        """Results (K, size) of arguments (K, size), or (K,) where the size is 1."""
        count = len(arguments[0])
        buffered: tuple[Any, Any] = self._few.get(count) or self._function.map(count).buffer()
        buffer, evaluate = buffered
        if count <= _FEW:
            self._few[count] = buffer, evaluate
        dense_arguments = [np.ascontiguousarray(argument, dtype=float) for argument in arguments]
        results = [np.empty((count, size)) for size in self._sizes]
        for i, argument in enumerate(dense_arguments):
            buffer.set_arg(i, argument.data)
        for i, result in enumerate(results):
            buffer.set_res(i, result.data)
        evaluate()
        return results
