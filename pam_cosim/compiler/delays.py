"""``delay(expr, delayTime)``: what the inputs were some time ago (Modelica 3.6, section 3.7.4.1).

Until the delay has passed since the start, the result is what the expression was at the start, where
``initial()`` is true. A parameter does not change during a run, so a delayed expression of inputs and
parameters is that expression of the delayed inputs, and one of delayed inputs is one of inputs that are delayed by
the sum.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import casadi as ca

from pam_cosim.compiler.ode import Delay
from pam_cosim.compiler.source import SourceText
from pam_cosim.errors import ModelError

# How deep two expressions are compared; equal ones that look different cost a second record of the input.
_DEPTH = 100


@dataclass(frozen=True)
class DelayCall:
    """A scalar call of ``delay``.

    Attributes:
        symbol: stands for the result.
        argument, start: what is delayed, and the same at the start.
        time: by how much [s].
        source, at: where the call is written.
    """

    symbol: ca.SX
    argument: ca.SX
    start: ca.SX
    time: ca.SX
    source: SourceText
    at: int


@dataclass
class DelayedInputs:
    """Turns calls of ``delay`` into delayed inputs.

    Attributes:
        calls: all calls, by the name of their symbols.
        solved: the model's unknowns as expressions of states, inputs, parameters and results of the calls.
        symbols: of the unknowns, by name.
        inputs: symbols of the inputs, in their order.
        parameters: symbols of the free parameters.
        begun: what is 0 from the start for a length of time, and then 1, by the name of its symbol: both.
        delays: the delayed inputs found so far, and ``delayed`` their symbols.
    """

    calls: Mapping[str, DelayCall]
    solved: Mapping[str, ca.SX]
    symbols: Mapping[str, ca.SX]
    inputs: Sequence[ca.SX]
    parameters: ca.SX
    begun: Mapping[str, tuple[ca.SX, ca.SX]] = field(default_factory=dict)
    delays: list[Delay] = field(default_factory=list)
    delayed: list[ca.SX] = field(default_factory=list)
    _results: dict[str, ca.SX] = field(default_factory=dict, init=False)
    _in_progress: dict[str, None] = field(default_factory=dict, init=False)
    _positions: dict[str, int] = field(init=False)
    _known: list[str] = field(init=False)

    def __post_init__(self) -> None:
        self._positions = {symbol.name(): i for i, symbol in enumerate(self.inputs)}
        self._known = [symbol.name() for symbol in ca.symvar(self.parameters)]

    def put_in(self, expressions: Sequence[ca.SX]) -> list[ca.SX]:
        """The expressions with the result of every call in place of its symbol.

        Raises:
            ModelError: with the place of a call that delays something else than inputs and parameters, or by a
                time that is no expression of parameters.
        """
        results = [self._result(call) for call in self.calls.values()]
        results += [self._channel(Delay(None, length)) for _, length in self.begun.values()]
        if not results:
            return list(expressions)
        old = [call.symbol for call in self.calls.values()] + [
            symbol for symbol, _ in self.begun.values()
        ]
        return list(ca.substitute(list(expressions), [ca.vertcat(*old)], [ca.vertcat(*results)]))

    def _result(self, call: DelayCall) -> ca.SX:
        name = call.symbol.name()
        if name not in self._results:
            if name in self._in_progress:
                raise call.source.error(
                    "this delay() is of something that depends on its own result", call.at
                )
            self._in_progress[name] = None
            self._results[name] = self._evaluated(call)
        return self._results[name]

    def _evaluated(self, call: DelayCall) -> ca.SX:
        time = self._time(call)
        result = self._shifted(call.argument, call, time)
        if same(call.argument, call.start):
            return result
        return ca.if_else(
            self._channel(Delay(None, time)) > 0.5, result, self._shifted(call.start, call, time)
        )

    def _time(self, call: DelayCall) -> ca.SX:
        varying = [s.name() for s in ca.symvar(call.time) if s.name() not in self._known]
        if varying:
            message = f"the time of delay() must be an expression of parameters; it depends on '{varying[0]}'"
            raise call.source.error(message, call.at)
        return call.time

    def _shifted(self, argument: ca.SX, call: DelayCall, time: ca.SX) -> ca.SX:
        """The argument of a call with each input in it delayed (further) by ``time``."""
        argument = put(argument, self.symbols, self.solved)
        inner = [name for name in _names(argument) if name in self.calls]
        results = {name: self._result(self.calls[name]) for name in inner}
        argument = put(argument, {name: self.calls[name].symbol for name in inner}, results)
        already = {
            symbol.name(): delay for symbol, delay in zip(self.delayed, self.delays, strict=True)
        }
        old, new = {}, {}
        for symbol in ca.symvar(argument):
            name = symbol.name()
            if name in self._known:
                continue
            if name in self._positions:
                delay = Delay(self._positions[name], time)
            elif name in already:
                delay = Delay(already[name].input, already[name].time + time)
            elif name in self.begun:
                delay = Delay(None, self.begun[name][1] + time)
            else:
                message = f"delay() of something other than an input is not supported: it depends on '{name}'"
                raise call.source.error(message, call.at)
            old[name], new[name] = symbol, self._channel(delay)
        return put(argument, old, new)

    def _channel(self, delay: Delay) -> ca.SX:
        """The symbol of an input delayed by a time: one for all calls with the same delay."""
        for symbol, existing in zip(self.delayed, self.delays, strict=True):
            if existing.input == delay.input and same(existing.time, delay.time):
                return symbol
        self.delays.append(delay)
        what = "start" if delay.input is None else self.inputs[delay.input].name()
        self.delayed.append(ca.SX.sym(f"delayed {len(self.delays)}: {what}"))
        return self.delayed[-1]


def same(a: ca.SX, b: ca.SX) -> bool:
    """Whether two expressions are written alike."""
    return bool(ca.is_equal(a, b, _DEPTH))


def _names(expression: ca.SX) -> list[str]:
    return [symbol.name() for symbol in ca.symvar(expression)]


def put(expression: ca.SX, symbols: Mapping[str, ca.SX], values: Mapping[str, ca.SX]) -> ca.SX:
    """The expression with values in place of those symbols that have one."""
    names = [name for name in _names(expression) if name in values] if values else []
    if not names:
        return expression
    return ca.substitute(
        expression,
        ca.vertcat(*[symbols[name] for name in names]),
        ca.vertcat(*[values[name] for name in names]),
    )


def check_time(time: object) -> None:
    """Refuse a delay time that is known already and impossible.

    Raises:
        ModelError: it is not a number, or negative; the caller adds the place.
    """
    if isinstance(time, ca.SX):
        return
    if isinstance(time, bool) or not isinstance(time, int | float):
        raise ModelError("the time of delay() must be a number of seconds")
    if not time >= 0.0:
        raise ModelError(f"the time of delay() must not be negative, but it is {time:g} s")
