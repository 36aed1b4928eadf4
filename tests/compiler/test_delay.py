"""``delay``: which inputs it asks for, by how much, and what is refused."""

import casadi as ca
import pytest

from pam_cosim.compiler import compile_model
from pam_cosim.errors import ModelError
from tests.compiler.run import MODELS, WRONG, at, compiled, defaults


def times(ode, changed=None):
    function = ca.Function("times", [ode.p], [ca.vertcat(*[delay.time for delay in ode.delays])])
    return function(defaults(ode, changed)).full().ravel()


def test_delayed_inputs_are_found_through_aliases_and_expressions():
    """Equal ones are one; a delay of a delay is a delay by the sum."""
    ode = compiled("Delays.Uses")
    assert list(ode.interface.inputs) == ["a", "b"]
    delays = {
        (delay.input, float(time)) for delay, time in zip(ode.delays, times(ode), strict=True)
    }
    assert delays == {(0, 1.5), (1, 1.5), (0, 2.5), (None, 1.5), (0, 3.5), (None, 3.5)}
    assert len(ode.delays) == 6 == ode.d.numel()
    changed = {
        (delay.input, float(time))
        for delay, time in zip(ode.delays, times(ode, {"k": 8}), strict=True)
    }
    assert changed == {(0, 4.0), (1, 4.0), (0, 5.0), (None, 4.0), (0, 6.0), (None, 6.0)}


def test_values_follow_from_the_delayed_inputs():
    ode = compiled("Delays.Uses")
    value = {
        (0, 1.5): 2.0,
        (1, 1.5): 5.0,
        (0, 2.5): 7.0,
        (None, 1.5): 1.0,
        (0, 3.5): 9.0,
        (None, 3.5): 0.0,
    }
    d = [
        value[delay.input, float(time)] for delay, time in zip(ode.delays, times(ode), strict=True)
    ]
    values = at(ode, {"x": 10.0}, u=[0.25, 99.0], d=d)
    assert (values["drive.y[1]"], values["drive.y[2]"], values["y"]) == (2.0, -5.0, -3.0)
    assert values["mixed"] == 3 * 2.0 + 5.0**2
    assert (
        values["switched"] == 2.0 + 1 and values["again"] == 3.0
    )  # of which the second has not begun
    assert values["later"] == 7.0 and values["known"] == 4.0
    assert values["der(x)"] == 31.0 - 0.25 * 10.0


def test_models_without_delay_have_no_delayed_inputs():
    ode = compiled("Tanks.Bench")
    assert ode.d.numel() == 0 and ode.delays == ()


@pytest.mark.parametrize(
    ("name", "line", "column", "words"),
    [
        (
            "DelayOfState",
            6,
            16,
            ["delay() of something other than an input is not supported", "'x'"],
        ),
        (
            "DelayOfTime",
            3,
            12,
            ["delay() of something other than an input is not supported", "'time'"],
        ),
        ("DelayVaries", 6, 11, ["time of delay()", "expression of parameters", "'T'"]),
        ("DelayNegative", 5, 7, ["must not be negative", "-0.5 s"]),
        ("DelayDerivative", 5, 7, ["derivative of the input 'delay(u)'"]),
        (
            "DelayDifferentiated",
            1,
            7,
            ["derivative of its input 'delay(u)'", "DelayDifferentiated.mo:3"],
        ),
        ("DelayOfItself", 5, 11, ["depends on its own result"]),
        ("DelayInitial", 1, 7, ["initial value of 'x' depends on the input 'delay(u)'"]),
        ("DelayAlone", 5, 7, ["delay() takes 2 or 3 arguments"]),
        ("DelayInFunction", 6, 10, ["delay() cannot be used in a function"]),
    ],
)
def test_refused(name, line, column, words):
    file = WRONG / f"{name}.mo"
    with pytest.raises(ModelError) as caught:
        compile_model(str(file), root=MODELS)
    error = caught.value
    for word in words:
        assert word in str(error)
    assert (error.file, error.line, error.column) == (file, line, column)
