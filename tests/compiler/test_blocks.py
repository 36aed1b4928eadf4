"""Systems of equations, solved as far as somebody asks."""

from __future__ import annotations

import casadi as ca
import pytest

from pam_cosim.compiler.blocks import solve
from pam_cosim.compiler.flattening import Residual
from pam_cosim.errors import ModelError
from tests.compiler.run import compiled, initial


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


def test_a_nonlinear_loop_is_solved_with_exact_derivatives() -> None:
    """root^3 + root = x: from any x, and the slope of the root by x is 1/(3 root^2 + 1)."""
    ode = compiled("Root")
    rate = ca.Function("rate", [ode.x], [ode.derivatives, ca.jacobian(ode.derivatives, ode.x)])
    for root in (-20.0, -1.0, 0.0, 0.3, 5.0):
        value, slope = rate(root**3 + root)
        assert float(value) == pytest.approx(-root, rel=1e-12, abs=1e-12)
        assert float(slope) == pytest.approx(-1 / (3 * root**2 + 1), rel=1e-9)
    statement = ode.statements[0]
    holds = ca.Function("holds", [ode.x], [statement.condition])
    assert holds(130.0) and not holds(1e9)
    assert "Newton's method finds no solution" in statement.texts[0]


def test_an_initial_equation_may_be_nonlinear() -> None:
    assert initial(compiled("Rest.Hard"))["x"] ** 3 == pytest.approx(
        3 - initial(compiled("Rest.Hard"))["x"]
    )
