"""The right-hand side of a compiled model as numbers, by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from pathlib import Path

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp

from pam_cosim.compiler import compile_model

Values = dict[str, float]


class Model:
    """A compiled class; ``text``, if given, is Modelica source whose last class is taken."""

    def __init__(self, name: str, text: str = "", folder: Path | None = None) -> None:
        if text:
            assert folder is not None
            file = folder / f"{name}.mo"
            file.write_text(text)
            name = str(file)
        self.ode = compile_model(name)
        self.interface = self.ode.interface
        self.arguments = [self.ode.t, self.ode.x, self.ode.u, self.ode.p]

    @cached_property
    def rates(self) -> ca.Function:
        return ca.Function("rates", self.arguments, [self.ode.derivatives])

    @cached_property
    def everything(self) -> ca.Function:
        results = ca.vertcat(self.ode.derivatives, self.ode.outputs, self.ode.locals)
        return ca.Function("everything", self.arguments, [results])

    @cached_property
    def slopes(self) -> ca.Function:
        """Derivatives of all rates and outputs by states, inputs and parameters."""
        by = ca.vertcat(self.ode.x, self.ode.u, self.ode.p)
        results = ca.vertcat(self.ode.derivatives, self.ode.outputs)
        return ca.Function("slopes", self.arguments, [ca.jacobian(results, by)])

    def parameters(self, changed: Mapping[str, float] | None = None) -> np.ndarray:
        values = {name: v.start or 0.0 for name, v in self.interface.parameters.items()}
        assert not changed or set(changed) <= set(values)
        return np.array([*(values | dict(changed or {})).values()], dtype=float)

    def inputs(self, changed: Mapping[str, float] | None = None) -> np.ndarray:
        values = {name: v.start or 0.0 for name, v in self.interface.inputs.items()}
        return np.array([*(values | dict(changed or {})).values()], dtype=float)

    def initial(self, p: np.ndarray) -> np.ndarray:
        u = self.inputs()
        return (
            ca.Function("initial", [self.ode.p, self.ode.u], [self.ode.initial])(p, u)
            .full()
            .ravel()
        )

    def at(self, x: np.ndarray, u: np.ndarray, p: np.ndarray) -> Values:
        """States, their derivatives as ``der(name)``, outputs and locals."""
        states = [state.name for state in self.ode.states]
        names = [
            *(f"der({name})" for name in states),
            *self.interface.outputs,
            *self.interface.locals,
        ]
        values = self.everything(0, x, u, p).full().ravel().tolist()
        return dict(zip(states, x.tolist(), strict=True)) | dict(zip(names, values, strict=True))

    def ledger(
        self,
        end: float,
        entry: Callable[[Values], float],
        u: np.ndarray,
        p: np.ndarray,
        rtol: float = 1e-11,
    ) -> tuple[Values, Values, float, float]:
        """Integrates a flow along a run, as one more state.

        Returns the values at the start and at the end, the integral of ``entry`` and that of its size.
        """

        def f(t: float, y: np.ndarray) -> np.ndarray:
            values = self.at(y[:-2], u, p)
            flow = entry(values)
            return np.array([*(values[f"der({s.name})"] for s in self.ode.states), flow, abs(flow)])

        start = np.array([*self.initial(p), 0.0, 0.0])
        scale = np.array([abs(s.nominal or 1.0) for s in self.ode.states] + [1e-3, 1e-3])
        solution = solve_ivp(f, (0.0, end), start, method="LSODA", rtol=rtol, atol=1e-13 * scale)
        assert solution.success
        last = solution.y[:, -1]
        return self.at(start[:-2], u, p), self.at(last[:-2], u, p), float(last[-2]), float(last[-1])
