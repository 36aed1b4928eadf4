"""Values of the built-in functions, by the tables of the specification (Modelica 3.6, sections 3.7 and 10.3)."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pam_cosim.compiler import compile_model
from tests.compiler.run import at

# by the definitions: mod(x, y) = x - floor(x/y)*y, div truncates, rem(x, y) = x - div(x, y)*y has the sign of x
OF_ONE = {
    "log10": {1000.0: 3.0, 0.01: -2.0},
    "sinh": {1.0: (math.e - 1 / math.e) / 2, -1.0: (1 / math.e - math.e) / 2},
    "cosh": {1.0: (math.e + 1 / math.e) / 2, -1.0: (math.e + 1 / math.e) / 2, 0.0: 1.0},
    "tanh": {0.5: (math.e - 1) / (math.e + 1), -0.5: (1 - math.e) / (math.e + 1)},
    "floor": {2.7: 2.0, -2.7: -3.0, -2.0: -2.0},
    "ceil": {2.2: 3.0, -2.2: -2.0, -2.0: -2.0},
    "integer": {2.7: 2.0, -2.7: -3.0, 0.4: 0.0},
    "sign": {2.7: 1.0, -2.7: -1.0, 0.0: 0.0},
    "asin": {0.5: math.pi / 6, -1.0: -math.pi / 2},
    "acos": {0.5: math.pi / 3, -1.0: math.pi},
    "atan": {1.0: math.pi / 4, -1.0: -math.pi / 4},
    "tan": {math.pi / 4: 1.0, -math.pi / 4: -1.0},
}
OF_TWO: dict[str, dict[tuple[float, float], float]] = {
    "mod": {(7, 3): 1, (-7, 3): 2, (7, -3): -2, (-7, -3): -1, (3.5, 1.25): 1.0, (-3.5, 1.25): 0.25},
    "div": {(7, 3): 2, (-7, 3): -2, (7, -3): -2, (-7, -3): 2, (3.5, 1.25): 2, (-3.5, 1.25): -2},
    "rem": {(7, 3): 1, (-7, 3): -1, (7, -3): 1, (-7, -3): -1, (3.5, 1.25): 1.0, (-3.5, 1.25): -1.0},
    "atan2": {
        (1.0, 1.0): math.pi / 4,
        (1.0, -1.0): 3 * math.pi / 4,
        (-1.0, -1.0): -3 * math.pi / 4,
        (-1.0, 0.0): -math.pi / 2,
        (0.0, -1.0): math.pi,
    },
}
VALUES: list[tuple[str, tuple[float, ...], float]] = [
    (name, (x,), value) for name, of in OF_ONE.items() for x, value in of.items()
]
VALUES += [(name, args, float(value)) for name, of in OF_TWO.items() for args, value in of.items()]
ARRAYS = {
    "product({2, -3, 4})": -24,
    "product({x, -3, 4})": -24,
    "product(i for i in 1:4)": 24,
    "product({x, x, x})": 8,
    "sum(transpose({{1, x}, {3, 4}, {5, 6}})*{1, 10, 100})": 531 + 642,
    "size(transpose({{1, 2}, {3, 4}, {5, 6}}), 1)": 2,
    "size(transpose({{1, 2}, {3, 4}, {5, 6}}), 2)": 3,
    "linspace(-1, x, 4)*{1, 10, 100, 1000}": -1 + 0 + 100 + 2000,
    "linspace(1, -1, 5)*{1, 10, 100, 1000, 10000}": 1 + 5 - 500 - 10000,
    "sum(fill(-1.5, 2, 3))": -9,
    "fill(x, 2)*{1, 10}": 22,
    "size(fill(0, 2, 3), 2)": 3,
    "sum(ones(2, 3))": 6,
    "sum(zeros(3))": 0,
    "ndims({{1, 2}, {3, 4}})": 2,
    "ndims({1, 2})": 1,
    "ndims(x)": 0,
    "scalar({{-7}})": -7,
    "scalar({{x}})": 2,
    "vector({{1}, {x}, {3}})*{1, 10, 100}": 321,
    "size(vector({{1, 2, 3}}), 1)": 3,
}


def outputs(folder: Path, equations: list[str], declarations: list[str]) -> list[float]:
    """What outputs y[i], right sides of equations, and then declarations of parameters are."""
    count, known = len(equations), len(declarations)
    file = folder / "M.mo"
    file.write_text(
        "model M\n  input Real u[2];\n  Real x = u[1];\n"
        + "".join(f"  final parameter Real k{i} = {d};\n" for i, d in enumerate(declarations))
        + f"  output Real y[{count}];\n  output Real z[{known}];\nequation\n"
        + "".join(f"  y[{i}] = {e};\n" for i, e in enumerate(equations, 1))
        + "".join(f"  z[{i + 1}] = k{i};\n" for i in range(known))
        + "end M;\n"
    )
    values = at(compile_model(str(file)), u=[2.0, 0.0])
    return [values[f"y[{i}]"] for i in range(1, count + 1)] + [
        values[f"z[{i}]"] for i in range(1, known + 1)
    ]


@pytest.mark.parametrize("name", [*OF_ONE, *OF_TWO])
def test_a_function_of_scalars_has_the_value_that_is_defined(name: str, tmp_path: Path) -> None:
    """The same in constants and at run time, where an argument depends on an input."""
    cases = [(args, value) for n, args, value in VALUES if n == name]
    known = [f"{name}({', '.join(map(repr, args))})" for args, _ in cases]
    running = [f"{name}({', '.join(f'u[2] + ({a!r})' for a in args)})" for args, _ in cases]
    expected = [value for _, value in cases]
    assert outputs(tmp_path, running, known) == pytest.approx(2 * expected, abs=1e-14)


def test_functions_of_arrays_have_the_values_that_are_defined(tmp_path: Path) -> None:
    known = {e: value for e, value in ARRAYS.items() if "x" not in e}
    made = outputs(tmp_path, list(ARRAYS), list(known))
    told = dict(zip([*ARRAYS, *(f"constant {e}" for e in known)], made, strict=True))
    assert told == pytest.approx(ARRAYS | {f"constant {e}": v for e, v in known.items()})
