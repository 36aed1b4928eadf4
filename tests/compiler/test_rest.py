"""States that begin at rest: which they are, and what is refused. Where they begin: ``tests/fmu/test_rest.py``."""

from __future__ import annotations

import casadi as ca
import pytest

from pam_cosim.compiler.saved import ode_bytes, read_ode
from pam_cosim.errors import ModelError
from pam_cosim.fmu.table import table
from tests.compiler.run import compiled, initial

TANK = ("tank.p", "tank.q[1]", "tank.q[2]")


@pytest.mark.parametrize(("model", "resting"), [("Plain", ()), ("Guess", ()), ("Steady", TANK)])
def test_a_parameter_of_the_surroundings_says_how_all_begin(
    model: str, resting: tuple[str, ...]
) -> None:
    ode = compiled(f"Rest.{model}")
    assert tuple(state.name for state in ode.states) == TANK
    assert ode.resting == resting
    assert initial(ode) == {"tank.p": 1.0, "tank.q[1]": 0.0, "tank.q[2]": 0.0}
    assert list(ode.interface.parameters) == ["tank.p_start", "tank.k"]


def test_a_component_may_begin_otherwise_than_its_surroundings() -> None:
    ode = compiled("Rest.Two")
    assert ode.resting == TANK and len(ode.states) == 6


def test_the_start_value_of_a_state_at_rest_is_a_guess() -> None:
    starts = {entry.name: (entry.initial, entry.start) for entry in table(compiled("Rest.Steady"))}
    assert [starts[name] for name in TANK] == [("approx", 1.0), ("approx", 0.0), ("approx", 0.0)]
    fixed = {entry.name: entry.initial for entry in table(compiled("Rest.Plain"))}
    assert [fixed[name] for name in TANK] == [
        "approx",
        "exact",
        "exact",
    ]  # the first is a parameter's value


def test_what_symbols_solve_is_known_beforehand() -> None:
    ode = compiled("Rest.Linear")
    assert ode.resting == ("x",) and initial(ode) == {"x": 1.5}
    assert ca.depends_on(ode.initial, ode.u)


@pytest.mark.parametrize("model", ["Made", "Kept"])
def test_a_variable_at_rest_that_is_no_state_puts_the_state_at_rest(model: str) -> None:
    """T = p V/m: the mass is sought from where the start values of p and T have it."""
    ode = compiled(f"Rest.{model}")
    assert set(ode.resting) == {"p", "m"}
    assert initial(ode) == {"p": 5.0, "m": pytest.approx(5 * 2 / 300)}


def test_what_begins_where_something_at_rest_is_follows_it() -> None:
    ode = compiled("Rest.Leaning")
    ((name, value),) = ode.following
    assert ode.resting == TANK and name == "z" and str(value) == "sq(tank.p)"
    assert initial(ode)["z"] == 1.0  # beside the guess


def test_it_is_saved() -> None:
    ode = compiled("Rest.Leaning")
    back = read_ode(ode_bytes(ode))
    assert back.resting == TANK and str(back.following) == str(ode.following)


@pytest.mark.parametrize(
    ("model", "words"),
    [
        (
            "Late",
            "the parameter 'z' depends on states that begin at rest, known only when the model has settled",
        ),
    ],
)
def test_refused(model: str, words: str) -> None:
    with pytest.raises(ModelError) as caught:
        compiled(f"Rest.{model}")
    assert words in str(caught.value)
