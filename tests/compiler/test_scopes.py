"""Which value a name has where classes are inherited, modified and put into arrays; OpenModelica says the same."""

from __future__ import annotations

from pathlib import Path

import pytest

from pam_cosim.compiler import Ode, compile_model
from pam_cosim.errors import ModelError
from tests.compiler.run import MODELS, at

PACKAGE = """
package A
  constant Real k = 1;
  model M Real y = k; end M;
  function f input Real x; output Real y; algorithm y := k*x; end f;
  function g input Real x; output Real y; algorithm y := f(x) + k; end g;
end A;
"""
PINS = """
connector C Real v; flow Real i; end C;
model S C c; parameter Real e = 1; equation c.v = e + c.i; end S;
model L C c; equation c.i = c.v; end L;
"""


def made(tmp_path: Path, text: str) -> Ode:
    """The last model of a text."""
    file = tmp_path / "a.mo"
    file.write_text(text)
    return compile_model(str(file), root=MODELS)


def test_an_inherited_function_or_model_has_the_constants_of_the_package(tmp_path: Path) -> None:
    text = """
    package B extends A(k = 2); model N Real z = g(time); end N; end B;
    model Top Real y = B.f(time); Real z = B.k; B.M m; B.N n; Real old = A.f(time); end Top;
    """
    values = at(made(tmp_path, PACKAGE + text), t=3.0)
    assert [values[n] for n in ("y", "z", "m.y", "n.z", "old")] == [6, 2, 2, 8, 3]


def test_a_redeclared_package_has_its_constants(tmp_path: Path) -> None:
    text = """
    model Q replaceable package P = A; Real y = P.f(time) + P.k; P.M m; end Q;
    model Top Q q(redeclare package P = A(k = 7)); Q old; end Top;
    """
    values = at(made(tmp_path, PACKAGE + text), t=3.0)
    assert [values[n] for n in ("q.y", "q.m.y", "old.y", "old.m.y")] == [28, 7, 4, 1]


def test_a_constant_without_value_is_given_where_the_package_is_extended(tmp_path: Path) -> None:
    text = """
    partial package Medium constant Integer n; model M Real y[n] = fill(time, n); end M; end Medium;
    package Air extends Medium(n = 2); end Air;
    model Top Air.M m; end Top;
    """
    assert [n for n in at(made(tmp_path, text)) if n.startswith("m.y")] == ["m.y[1]", "m.y[2]"]


def test_a_subscript_behind_an_array_of_components_is_of_each(tmp_path: Path) -> None:
    text = """
    record R Real b[2]; end R;
    model Top R a[2](b = {{1, 2}, {3, 4}}); Real s = sum(a.b[1]); Real q[2] = a[:].b[2]; end Top;
    """
    values = at(made(tmp_path, text))
    assert [values[n] for n in ("s", "q[1]", "q[2]")] == [4, 2, 4]


def test_a_modifier_of_a_function_is_looked_up_where_it_is_written(tmp_path: Path) -> None:
    text = """
    function g input Real x; input Real k = 2*x; output Real y; algorithm y := k*x; end g;
    model Top parameter Real x = 3; function f = g(k = x); Real y = f(2 + time); Real z = g(time); end Top;
    """
    values = at(made(tmp_path, text), t=2.0)
    assert values["y"] == 3 * 4 and values["z"] == 8


def test_a_constructor_knows_the_names_around_it(tmp_path: Path) -> None:
    text = """
    record C Real re; end C;
    function F input Real a; output Real y; protected C c; algorithm c := C(re = a); y := 2*c.re; end F;
    model Top parameter Real i = 10; C c[3] = {C(re = i) for i in 1:3}; Real y = F(time); end Top;
    """
    values = at(made(tmp_path, text), t=4.0)
    assert [values[f"c[{i}].re"] for i in (1, 2, 3)] == [1, 2, 3] and values["y"] == 8


def test_each_gives_every_component_an_array(tmp_path: Path) -> None:
    text = """
    model H parameter Real a[3] = {0, 0, 0}; parameter Real b = 1; end H;
    model G H h[2](each a = {1, 2, 3}, b = {5, 6}); end G;
    model Top H h[2, 2](each a = {1, 2, 3}); G g[2]; G k[2](h(each b = 9)); end Top;
    """
    parameters = made(tmp_path, text).interface.parameters
    names = ("h[2,1].a[3]", "g[2].h[1].a[2]", "g[1].h[2].b", "k[2].h[1].b")
    assert [parameters[n].start for n in names] == [3, 2, 6, 9]


def test_what_the_structure_follows_from_is_no_parameter(tmp_path: Path) -> None:
    """It could be set, and what depends on it stayed."""
    text = """
    model Top
      parameter Real c = 3; parameter Real a = 2*c; parameter Integer n = integer(a);
      parameter Real limit = 1; parameter Boolean b = limit > 2; parameter Real length = 2; Real v[integer(length)];
      parameter Real free = 2; parameter Real bound = 5; Real s(max = bound) = free*bound;
      Real y = if b then time else n*time;
    equation v = fill(free, integer(length));
    end Top;
    """
    ode = made(tmp_path, text)
    assert list(ode.interface.parameters) == ["free", "bound"]
    assert at(ode, t=2.0)["y"] == 12


@pytest.mark.parametrize("condition", ["k > 0.5", "time > 1"])
def test_a_connection_is_not_made_by_what_may_change(tmp_path: Path, condition: str) -> None:
    """All branches were connected."""
    text = f"""
    model Top parameter Real k = 1; S s1(e = 1), s2(e = 5); L l;
    equation
      if {condition} then connect(s1.c, l.c); else connect(s2.c, l.c); end if;
    end Top;
    """
    with pytest.raises(ModelError, match="whose condition may change") as caught:
        made(tmp_path, PINS + text)
    assert caught.value.line == 8
    fixed = text.replace("parameter Real k = 1", "constant Real k = 1").replace("time", "k")
    assert at(made(tmp_path, PINS + fixed))["l.c.v"] == pytest.approx(0.5 if "0.5" in text else 2.5)


@pytest.mark.parametrize("call", ["simplified = 0, actual = 2*time", "2*time, simplified = 0"])
def test_homotopy_is_the_actual_expression(tmp_path: Path, call: str) -> None:
    assert at(made(tmp_path, f"model Top Real y = homotopy({call}); end Top;"), t=3.0)["y"] == 6
