"""One construct of the language after the other."""

import numpy as np
import pytest

from pam_cosim.compiler import compile_model
from pam_cosim.errors import ModelError
from tests.compiler.run import at, compiled, initial, simulate


def test_arrays_and_for_equations():
    ode = compiled("Language.Arrays")
    assert [state.name for state in ode.states] == ["x[1]", "x[2]", "x[3]", "x[4]", "y[1]", "y[2]"]
    assert initial(ode, {"start": 5})["x[3]"] == 5
    x = {"x[1]": 1.0, "x[2]": 2.0, "x[3]": 4.0, "x[4]": 7.0, "y[1]": 1.0, "y[2]": 2.0}
    values = at(ode, x, p={"tau[3]": 3})
    assert [values[f"der(x[{i}])"] for i in range(1, 5)] == pytest.approx([-2, -1, -2 / 3, -1.5])
    assert [values["der(y[1])"], values["der(y[2])"]] == pytest.approx([1, 1])
    assert values["total"] == 14 and values["largest"] == 7
    assert values["weighted"] == pytest.approx(0.5 + 2 + 12 + 14)


def test_outer_components_find_the_inner_one():
    values = at(compiled("Language.InnerOuter"), p={"world.g": 3})
    assert [values["der(balls[1].v)"], values["der(balls[2].v)"]] == [-3, -3]


@pytest.mark.parametrize(
    ("model", "balls"), [("NoInner", ("balls[1]", "balls[2]", "single")), ("Ball", ("",))]
)
def test_what_nothing_declares_inner_is_added_at_the_top(
    model: str, balls: tuple[str, ...]
) -> None:
    ode = compiled(f"Language.{model}")
    assert ode.interface.parameters["world.g"].start == 9.81
    values = at(ode, p={"world.g": 3})
    assert [values[f"der({f'{ball}.v'.lstrip('.')})"] for ball in balls] == [-3] * len(balls)


@pytest.mark.parametrize(("u", "expected"), [(2.0, 5 * 14), (0.5, 2.5), (-1.0, 0.0)])
def test_functions_with_loops_branches_and_redeclaration(u, expected):
    values = at(compiled("Language.Functions"), u=[u])
    assert values["y"] == 2 * u and values["z"] == pytest.approx(expected)
    assert values["square"] == u**2 and values["cube"] == pytest.approx(u**3)


def test_function_redeclared_two_levels_down():
    assert at(compiled("Language.NestedFunction"), u=[2.0])["element.y"] == 3 * 14


def test_records_enumerations_and_constructors():
    ode = compiled("Language.Records")
    assert (
        ode.interface.parameters["data.a"].start == 10
        and ode.interface.parameters["data.b"].start == 5
    )
    values = at(ode, p={"data.a": 4, "other.a": 3})
    assert values["area"] == 16 and values["sum_"] == 3 + 6


def test_redeclared_record():
    ode = compiled("Language.RedeclaredRecord")
    assert ode.interface.parameters["other.a"].start == 4
    assert at(ode)["sum_"] == 4 + 8


def test_linear_loop_is_solved():
    values = at(compiled("Language.Loop"), {"x": 2.0, "v": 0.5}, p={"k1": 20})
    force = 2.0 / (1 / 20 + 1 / 30)
    assert values["node"] == pytest.approx(force / 20) and values["der(v)"] == pytest.approx(
        -force / 2
    )


def test_rigid_coupling_is_reduced_from_index_three():
    ode = compiled("Language.Rigid")
    assert [state.name for state in ode.states] == ["s1", "v1"]
    times = np.linspace(0, 3, 7)
    assert simulate(ode, times)["s1"] == pytest.approx(0.5 * np.cos(np.sqrt(2) * times), abs=1e-8)
    assert at(ode)["f"] == pytest.approx(3 * 8 * 0.5 / 4)
    assert at(ode)["s2"] == 1.5


def test_initial_equations_follow_parameters():
    ode = compiled("Language.Initial")
    start = initial(ode, {"T0": 350})
    assert start["m"] == 2 and start["steady"] == pytest.approx(350 / 3)
    assert at(ode, p={"T0": 350})["T"] == pytest.approx(350)


@pytest.mark.parametrize(
    ("t", "x", "y"), [(0.0, 1.0, 1.0), (0.0, 0.2, 0.5), (1.0, 1.0, 1.0), (1.0, 0.05, 2.0)]
)
def test_conditions(t, x, y):
    values = at(compiled("Language.Conditions"), {"x": x}, t=t)
    assert values["der(x)"] == -2 * x and values["y"] == y
    assert values["rate"] == pytest.approx(2 * x * -2 * x + 1)


def test_state_select_decides():
    ode = compiled("Language.Chosen")
    assert [state.name for state in ode.states] == ["b"]
    assert initial(ode) == {"b": 3} and at(ode)["der(b)"] == pytest.approx(-2)


def test_algorithm_section():
    assert at(compiled("Language.Algorithm"), u=[3.0])["y"] == 81


def test_only_literal_public_top_most_parameters_are_free():
    ode = compiled("Language.Parameters")
    assert list(ode.interface.parameters) == ["free", "constant_expression", "third.tau"]
    assert {"computed", "inner_.tau", "hidden", "fixed_"} <= set(ode.interface.locals)


def test_connections_through_outside_connectors_and_arrays():
    values = at(compiled("Language.Circuit"))
    assert values["current"] == pytest.approx(12 / 6) and values["top.i"] == 0
    assert values["box.b.i"] == pytest.approx(-2)


def test_output_that_is_a_state():
    ode = compiled("Language.Lowpass")
    assert [state.name for state in ode.states] == ["y"] and list(ode.interface.outputs) == ["y"]
    assert at(ode, {"y": 0.25}, u=[1.0], p={"tau": 3}) == {"der(y)": 0.25, "y": 0.25}


def test_base_class_inherited_twice_states_its_equations_once():
    assert at(compiled("Diamond.Both")) == {"der(x)": -1, "x": 1, "left": 2, "right": 3}


def test_signal_connectors():
    ode = compiled("Diamond.Signals")
    assert list(ode.interface.inputs) == ["u"] and ode.interface.outputs["y"].unit == "V"
    assert at(ode, u=[2])["y"] == 6


LOOPS = """model Loops
  function divisor "Greatest common divisor by Euclid's algorithm"
    input Integer a;
    input Integer b;
    output Integer n;
  protected
    Integer m;
    Integer rest;
  algorithm
    n := a;
    m := b;
    while m > 0 loop
      rest := mod(n, m);
      n := m;
      m := rest;
    end while;
  end divisor;
  function place "Of the first number that is larger"
    input Real v[:];
    input Real limit;
    output Integer i = 0;
  algorithm
    for k in 1:size(v, 1) loop
      i := k;
      if v[k] > limit then
        break;
      end if;
    end for;
  end place;
  function early
    input Integer n;
    output Real y;
  algorithm
    y := 1;
    if n > 2 then
      return;
    end if;
    y := 2;
  end early;
  output Real y = divisor(12, 18) + 10*place({1, 5, 9}, 4) + 100*early(3) + 1000*early(1);
end Loops;
"""


def test_functions_have_loops_that_end_early(tmp_path):
    file = tmp_path / "Loops.mo"
    file.write_text(LOOPS)
    assert at(compile_model(str(file)))["y"] == 6 + 20 + 100 + 2000


def test_a_loop_does_not_end_by_what_is_known_later(tmp_path):
    file = tmp_path / "Loops.mo"
    file.write_text(
        LOOPS.replace(
            "output Real y =", "output Real z = place({1, time, 9}, 4);\n  output Real y ="
        )
    )
    with pytest.raises(ModelError, match="'break' depends on a condition that is known only when"):
        compile_model(str(file))
