"""Systems of equations, solved as far as somebody asks."""

from __future__ import annotations

import casadi as ca
import pytest

from pam_cosim.compiler.blocks import solve
from pam_cosim.compiler.flattening import Residual
from pam_cosim.errors import ModelError


def test_only_what_the_wanted_unknowns_depend_on_is_solved_for() -> None:
    symbols = {name: ca.SX.sym(name) for name in ("a", "b", "c", "d")}
    a, b, c, d = symbols.values()
    p = ca.SX.sym("p")
    residuals = [Residual(e, "here") for e in (b - 2 * a, a - p, c - 3 * b - d, d * d - p)]
    with pytest.raises(ModelError, match="nonlinear algebraic loop for 'd'"):
        solve(residuals, list(symbols), symbols)
    solved = solve(residuals, list(symbols), symbols, ["b"])
    assert set(solved) == {"a", "b"}
    assert float(ca.evalf(ca.substitute(solved["b"], p, 5.0))) == 10.0
    with pytest.raises(ModelError, match="nonlinear"):
        solve(residuals, list(symbols), symbols, ["c"])
