"""What is known when a run begins: parameters that initial equations determine, and the start time among them.

A parameter with ``fixed=false`` (Modelica 3.6, section 8.6) is an unknown of the initial equations. Where these make it
an expression of other parameters it is that expression from then on. Where they make it the start time, as in
``initial equation t_0 = time;``, it may stand in comparisons of time with it, such as ``time > t_0 + T`` where T is
made of parameters: the change is at a time known beforehand, which the solver's steps meet.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from pam_cosim.compiler.delays import put
from pam_cosim.errors import ModelError


@dataclass(frozen=True)
class TimeComparison:
    """``time > start + length``.

    Attributes:
        symbol: stands for it: 1 where it holds, 0 where it does not.
        start: name of the parameter that may turn out to be the start time.
        length: expression of parameters [s].
        written: the comparison itself, for the case that the parameter is something else.
    """

    symbol: ca.SX
    start: str
    length: ca.SX
    written: ca.SX


def comparison(
    left: ca.SX, right: ca.SX, time: ca.SX, late: Mapping[str, ca.SX]
) -> tuple[TimeComparison, bool] | None:
    """``left > right`` as a comparison of time with a parameter of ``late``, and whether it is that or its contrary.

    Args:
        left, right: the two sides.
        time: the symbol of time.
        late: symbols, by name, of parameters that initial equations determine.
    """
    gap = left - right
    names = {symbol.name() for symbol in ca.symvar(gap)}
    compared = [symbol for name, symbol in late.items() if name in names]
    if time.name() not in names or len(compared) != 1:
        return None
    terms = ca.vertcat(time, compared[0])
    slopes = ca.jacobian(gap, terms)
    if (
        not slopes.is_constant()
        or abs(float(slopes[0])) != 1.0
        or float(slopes[0]) != -float(slopes[1])
    ):
        return None
    sign = float(slopes[0])
    constant = ca.substitute(gap, terms, ca.SX.zeros(2))
    symbol = ca.SX.sym(f"time > {compared[0].name()} + {-sign * constant}")
    holds = left > right if sign > 0 else ca.logic_not(left > right)
    return TimeComparison(symbol, compared[0].name(), -sign * constant, holds), sign > 0


@dataclass(frozen=True)
class InitialParameters:
    """What the initial equations determine of parameters.

    Attributes:
        values: the parameters' values as expressions of other parameters, by name.
        start_times: names of those that are the start time.
        symbols: of all of them, and of the comparisons with them.
    """

    values: Mapping[str, ca.SX]
    start_times: frozenset[str]
    symbols: Mapping[str, ca.SX]

    def substituted(self, expression: ca.SX) -> ca.SX:
        """The expression with the values in it."""
        return put(put(expression, self.symbols, self.values), self.symbols, self.values)

    def refuse_start_times(self, expression: ca.SX) -> None:
        """Raises:
        ModelError: the expression holds a start time outside of the comparisons.
        """
        for symbol in ca.symvar(expression):
            if symbol.name() in self.start_times:
                raise ModelError(
                    f"'{symbol.name()}' is the start time; it can only be used in comparisons such as "
                    f"time > {symbol.name()} + T, where T is made of parameters"
                )


def beginning(
    solved: Mapping[str, ca.SX],
    late: Mapping[str, ca.SX],
    comparisons: Mapping[str, TimeComparison],
    time: ca.SX,
) -> InitialParameters:
    """What follows from the solution of the initial equations.

    Args:
        solved: values of the parameters of ``late``, expressions of other parameters and of time, which is the start's.
        late: their symbols.
        comparisons: those that were made with them, by the name of their symbol.
        time: the symbol of time.

    Raises:
        ModelError: a parameter depends on the start time and is not equal to it.
    """
    starts = {name for name, value in solved.items() if ca.is_equal(ca.simplify(value), time)}
    values = {name: value for name, value in solved.items() if name not in starts}
    for name, value in values.items():
        if ca.depends_on(value, time):
            raise ModelError(
                f"the parameter '{name}' depends on the start time and is not equal to it"
            )
    values |= {name: c.written for name, c in comparisons.items() if c.start not in starts}
    symbols = dict(late) | {name: c.symbol for name, c in comparisons.items()}
    return InitialParameters(values, frozenset(starts), symbols)
