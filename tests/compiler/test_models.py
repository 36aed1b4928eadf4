"""Whole models against solutions derived by hand."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.compiler.run import at, compiled, initial, simulate

TIMES = np.linspace(0, 4, 9)


def test_two_tanks_level_out_as_the_closed_form_says():
    ode = compiled("Tanks.Bench")
    simulated = simulate(ode, TIMES, lambda t: (0.4,), {"valve.k": 0.5})
    a, b, k, q = 2.0, 1.0, 0.5, 0.4
    rate = k * (1 / a + 1 / b)
    difference = q / a / rate + (2.5 - q / a / rate) * np.exp(-rate * TIMES)
    volume = 3 * a + 0.5 * b + q * TIMES
    assert simulated["left.h"] == pytest.approx((volume + b * difference) / (a + b), rel=1e-8)
    assert simulated["right.h"] == pytest.approx((volume - a * difference) / (a + b), rel=1e-8)


def test_interface_carries_units_bounds_and_the_experiment():
    interface = compiled("Tanks.Bench").interface
    assert list(interface.inputs) == ["inflow"] and list(interface.outputs) == ["h"]
    assert interface.inputs["inflow"].unit == "m3/s" and interface.inputs["inflow"].start == 0
    assert list(interface.parameters) == ["left.A", "left.h_start", "right.h_start", "valve.k"]
    area = interface.parameters["left.A"]
    assert (area.unit, area.min, area.max, area.start, area.description) == (
        "m2",
        0.01,
        10,
        2,
        "Cross-section",
    )
    level = interface.outputs["h"]
    assert (level.unit, level.display_unit, level.quantity, level.min, level.nominal) == (
        "m",
        "mm",
        "Length",
        0,
        0.5,
    )
    assert (interface.stop_time, interface.interval, interface.tolerance) == (20, 0.1, 1e-7)
    assert "right.A" in interface.locals


def test_initial_values_follow_the_parameters():
    ode = compiled("Tanks.Bench")
    assert initial(ode) == {"left.h": 3, "right.h": 0.5}
    assert initial(ode, {"right.h_start": 0.25}) == {"left.h": 3, "right.h": 0.25}


def test_condition_switches_component_and_connections():
    off, on = compiled("Tanks.Switched"), compiled("Tanks.SwitchedOn")
    assert (
        "other.k" not in off.interface.parameters
        and on.interface.parameters["other.k"].start == 0.7
    )
    assert at(off, u=[0])["der(right.h)"] == pytest.approx(0.3 * 2.5)
    assert at(on, u=[0])["der(right.h)"] == pytest.approx((0.3 + 0.7) * 2.5)


def test_joined_tanks_share_one_state():
    ode = compiled("Tanks.Short")
    assert len(ode.states) == 1
    values = at(ode)
    assert values[f"der({ode.states[0].name})"] == pytest.approx(0.5 / (2 + 3))
    assert values["left.h" if ode.states[0].name != "left.h" else "right.h"] == pytest.approx(1)


def muscle_by_hand(gas, times, L0, m_flow, h=None, n=1.3):
    b2, R = L0**2 + 0.01, 287.05
    volume = lambda x: (L0 - x) * (b2 - (L0 - x) ** 2) / 10  # noqa: E731

    def rate(t, y):
        p, x, v = y[:3]
        L = L0 - x
        V, dV = volume(x), -(b2 - 3 * L**2) / 10 * v
        if gas == "polytropic":
            T = 293.15 * (p / 2e5) ** ((n - 1) / n)
            rest = [(-n * p * dV + n * R * T * m_flow) / V]
        else:
            T = p * V / (y[3] * R)
            rest = [(-1.4 * p * dV + 0.4 * h * (293.15 - T) + 1.4 * R * 293.15 * m_flow) / V]
        force = (p - 1e5) * (3 * L**2 - b2) / 10
        acceleration = (force - 2e4 * x - 300 * v) / 2
        return [rest[0], v, acceleration] + ([m_flow] if gas == "energetic" else [])

    start = [2e5, 0.01, 0.0] + ([2e5 * volume(0.01) / (R * 293.15)] if gas == "energetic" else [])
    return solve_ivp(rate, (0, times[-1]), start, "LSODA", times, rtol=1e-10, atol=1e-12).y


@pytest.mark.parametrize(
    ("model", "gas", "L0", "flow", "h"),
    [
        ("Muscles.Bench", "polytropic", 0.3, 2e-4, None),
        ("Muscles.Redeclared", "energetic", 0.25, 2e-4, 5.0),
        ("Muscles.RedeclaredInBody", "energetic", 0.3, 0.0, 6.0),
    ],
)
def test_volume_under_der_and_redeclared_gas(model, gas, L0, flow, h):
    ode = compiled(model)
    assert sum(state.name.startswith("muscle") for state in ode.states) == len(ode.states)
    times = np.linspace(0, 0.5, 6)
    expected = muscle_by_hand(gas, times, L0, flow, h)
    simulated = simulate(ode, times, lambda t: (flow,) if ode.interface.inputs else ())
    assert simulated["muscle.gas.p"] == pytest.approx(expected[0], rel=1e-7)
    assert simulated["muscle.x"] == pytest.approx(expected[1], rel=1e-7)
    if gas == "energetic":
        assert simulated["muscle.gas.m"] == pytest.approx(expected[3], rel=1e-7)


def test_redeclaration_three_levels_down_takes_a_parameter_of_the_model():
    ode = compiled("Muscles.Redeclared3")
    slow, fast = (
        at(ode, {"bench.muscle.gas.p": 3e5}),
        at(ode, {"bench.muscle.gas.p": 3e5}, p={"k": 14}),
    )
    slope = [v["der(bench.muscle.gas.p)"] for v in (slow, fast)]
    assert slope[1] == pytest.approx(2 * slope[0]) and slope[0] < 0
    assert "bench.muscle.gas.h" not in ode.interface.parameters


def test_redeclared_component_keeps_the_modifications_of_the_constraint_only():
    old, new = compiled("Muscles.ReplaceableComponent"), compiled("Muscles.RedeclaredComponent")
    assert old.interface.parameters["gas.n"].start == 1.3
    assert new.interface.parameters["gas.n"].start == 1.25
    assert new.interface.parameters["gas.h"].start == 9
    assert initial(new)["gas.p"] == 3e5


def test_outermost_modification_counts():
    again = compiled("Muscles.RedeclaredAgain").interface.parameters
    assert (
        "muscle.gas.h" not in again
        and again["muscle.m"].start == 4
        and again["muscle.L0"].start == 0.25
    )
    modified = compiled("Muscles.ModifiedClass").interface.parameters
    assert modified["muscle.gas.h"].start == 8 and modified["muscle.gas.n"].start == 1.1
    assert compiled("Muscles.ModifiedComponent").interface.parameters["gas.h"].start == 3


def test_computed_parameter_is_no_parameter_but_follows():
    ode = compiled("Muscles.Bench")
    assert "muscle.b" not in ode.interface.parameters
    values = at(ode, u=[0], p={"muscle.L0": 0.4})
    assert values["muscle.b"] == pytest.approx(np.sqrt(0.17))


def test_jacobians_are_finite_and_right():
    import casadi as ca

    ode = compiled("Muscles.Redeclared")
    arguments = [ode.t, ode.x, ode.u, ode.p]
    f = ca.Function("f", arguments, [ode.derivatives])
    jacobian = ca.Function("j", arguments, [ca.jacobian(ode.derivatives, ode.x)])
    x = np.array(list(initial(ode).values()))
    p = [v.start for v in ode.interface.parameters.values()]
    exact = jacobian(0, x, [1e-4], p).full()
    for j in range(len(x)):
        step = np.zeros(len(x))
        step[j] = 1e-6 * max(1e-3, abs(x[j]))
        central = (f(0, x + step, [1e-4], p) - f(0, x - step, [1e-4], p)).full().ravel() / (
            2 * step[j]
        )
        assert exact[:, j] == pytest.approx(central, rel=2e-5, abs=1e-6 * np.abs(central).max())


def test_compile_is_deterministic():
    first, second = compiled("Muscles.Redeclared"), compiled("Muscles.Redeclared")
    assert str(first.derivatives) == str(second.derivatives) and first.interface == second.interface


def test_a_flat_model_in_base_modelica_has_the_names_of_what_was_flattened():
    ode = compiled("Flat")
    assert list(ode.interface.parameters) == ["vessel.V"]
    simulated = simulate(ode, TIMES, lambda t: (), {"vessel.V": 4.0})
    assert simulated["vessel.p"] == pytest.approx(4 * np.exp(-TIMES / 2), rel=1e-7)
    assert at(ode)["half.q[2]"] == 4.0 and ode.interface.stop_time == 3
