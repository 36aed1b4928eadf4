"""Libraries of others: read class by class, and constructs that are an error only in a class that a model uses."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import pytest

from pam_cosim.compiler import compile_model, read_library
from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import ModelError

PACKAGE = """within ;
package Big "A library as others write them"
  extends Icons.Package;
  constant Real half = 0.5;
  package Icons partial package Package end Package; end Icons;
  annotation(uses(Other(version="1")));
end Big;
"""
FILES = {
    "Matrix.mo": """model Matrix
  constant Real A[2,2] = [1, 2; 3, 4];
  constant Real B[3,2] = [A; 5, 6];
  Real x(start=1, fixed=true);
equation
  der(x) = -B[1,2]*x + B[3,1] + sum([1, 2, 3]*[1; 1; 1]);
end Matrix;""",
    "Imported.mo": """model Imported
  import Big.{half, Constants};
  import Big.Constants.twice;
  import Big.Constants.*;
  Real x(start=1, fixed=true);
equation
  der(x) = -half*twice*Constants.thrice*fourfold*x;
end Imported;""",
    "Constants.mo": """package Constants
  constant Real twice = 2; constant Real thrice = 3; constant Real fourfold = 4;
end Constants;""",
    "Extended.mo": """model Extended
  package Base replaceable function f input Real u; output Real y; protected Real k = 2;
    algorithm y := k*u; end f; end Base;
  package Derived extends Base;
    redeclare function extends f input Real v = 1; algorithm y := y + v; end f; end Derived;
  Real x(start=1, fixed=true);
equation
  der(x) = -Derived.f(x, 3);
end Extended;""",
    "Switched.mo": """model Switched
  connector BooleanOutput = output Boolean; connector BooleanInput = input Boolean;
  block Threshold input Real u; BooleanOutput y; equation y = u > 0.5; end Threshold;
  block Switch BooleanInput open; output Real y; equation y = if open then -1 else 1; end Switch;
  Threshold threshold; Switch switch;
  Integer count; Real x(start=0, fixed=true);
equation
  threshold.u = x; connect(threshold.y, switch.open);
  count = if threshold.y then 3 else 2;
  der(x) = switch.y*count;
end Switched;""",
    "When.mo": """model When
  discrete Real held(start=0); Real x(start=1, fixed=true);
equation
  when x < 0.5 then held = pre(held) + 1; end when;
  der(x) = -x + held;
end When;""",
    "Table.mo": """model Table
  class External extends ExternalObject;
    function constructor output External e; external "C" e = make(); end constructor;
    function destructor input External e; external "C" free(e); end destructor; end External;
  External table = External();
  Real x(start=1, fixed=true);
equation der(x) = -x;
end Table;""",
    "Argument.mo": """model Argument
  partial function Shape input Real u; output Real y; end Shape;
  function apply input Shape f; input Real u; output Real y; algorithm y := f(u); end apply;
  function scaled extends Shape; input Real k; algorithm y := k*u; end scaled;
  Real x(start=1, fixed=true);
equation
  der(x) = apply(function scaled(k=2), x);
end Argument;""",
    "Broken.mo": "model Broken Real ) end Broken;",
}


@pytest.fixture
def big(tmp_path: Path) -> Path:
    """A package in a folder, a class in each file."""
    folder = tmp_path / "Big"
    folder.mkdir()
    (folder / "package.mo").write_text(PACKAGE)
    for name, text in FILES.items():
        (folder / name).write_text(f"within Big;\n{text}\n")
    return folder


def _rate(ode: Ode, x: float) -> float:
    return float(
        ca.Function("f", [ode.x, ode.p], [ode.derivatives])(x, ode.p.numel() * [0.0] or [])
    )


@pytest.mark.parametrize(
    ("model", "x", "rate"),
    [
        ("Matrix", 2.0, -2 * 2 + 5 + 6),
        ("Imported", 1.0, -0.5 * 2 * 3 * 4),
        ("Extended", 1.0, -(2 * 1 + 3)),
        ("Switched", 0.0, 2.0),
        ("Switched", 1.0, -3.0),
    ],
)
def test_constructs_of_large_libraries(big: Path, model: str, x: float, rate: float) -> None:
    """A broken class beside it is not read."""
    assert _rate(compile_model(f"Big.{model}", files=[big]), x) == pytest.approx(rate)


@pytest.mark.parametrize(
    ("model", "line", "words"),
    [
        ("When", 5, "'when' is not supported"),
        ("Table", 3, "external objects are not supported"),
        ("Argument", 8, "a function as an argument is not supported"),
        ("Broken", 2, "expected"),
    ],
)
def test_a_construct_is_refused_where_it_is_used(
    big: Path, model: str, line: int, words: str
) -> None:
    with pytest.raises(ModelError, match=words) as caught:
        compile_model(f"Big.{model}", files=[big])
    assert caught.value.line == line and Path(str(caught.value.file)).name == f"{model}.mo"


def test_its_classes_are_no_effects_and_are_not_read(big: Path) -> None:
    assert not any(name.startswith("Big") for name in read_library(files=[big]).classes)
