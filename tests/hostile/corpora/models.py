"""Modelica that is legal, or nearly so, and asks for more than anybody has: texts of models by what they ask for."""

# ruff: noqa: E501  # texts of models
from __future__ import annotations


def model(declarations: str = "", equations: str = "", before: str = "") -> str:
    """A file whose last class is the model ``M``."""
    return f"{before}\nmodel M\n {declarations}\nequation\n {equations}\nend M;\n"


def _doubling(levels: int, what: str = "Real x = 1;") -> str:
    parts = [f"model A0 {what} end A0;"]
    parts += [f"model A{i} A{i - 1} a; A{i - 1} b; end A{i};" for i in range(1, levels)]
    return "\n".join(parts) + f"\nmodel M A{levels - 1} a; end M;"


def _function(name: str, body: str, inputs: str = "input Real n;", locals_: str = "") -> str:
    return (
        f"function {name} {inputs} output Real y; protected {locals_} algorithm {body} end {name};"
    )


def _output(value: str, before: str = "") -> str:
    return model(f"output Real y = {value};", before=before)


def _inputs(value: str, before: str = "") -> str:
    return model(f"input Real u; output Real y = {value};", before=before)


FIB = _function("f", "y := if n < 2 then n else f(n - 1) + f(n - 2);")
SUMS = "sum(sum(sum(sum(i*j*k*l for i in 1:100) for j in 1:100) for k in 1:100) for l in 1:100)"

REFUSED: dict[str, str] = {
    # nested texts
    "5000 parentheses": _output("(" * 5000 + "1" + ")" * 5000),

    "5000 braces": _output("sum(" + "{" * 5000 + "1" + "}" * 5000 + ")"),

    "500 nested modifications": model("A a(" + "b(" * 500 + "x=1" + ")" * 500 + ");", before="model A Real x; end A;"),
    "a modification of 5000 parts": model("A a(" + ".".join("b" * 5000) + "=1);", before="model A Real x; end A;"),

    "2000 classes in one another": "".join(f"model A{i} " for i in range(2000))
    + "".join(f"end A{i}; " for i in reversed(range(2000))),
    "if 2000 deep": _inputs("if u > 0 then 1 else " * 2000 + "2"),
    "if equations 500 deep": model(
        "input Real u; Real y;", "if u > 0 then " * 500 + "y = 1;" + " else y = 2; end if;" * 500
    ),

    "annotation 5000 deep": model("Real y = 1; annotation(" + "a(" * 5000 + ")" * 5000 + ");"),

    # classes without end

    "a class in itself": "model M M m; end M;",
    "a class that extends itself": "model M extends M; end M;",
    "two classes that extend each other": "model A extends B; end A; model M extends A; end M; model B extends A; end B; "
    "model N extends A; end N;",


    "packages that extend each other": "package P extends Q; end P; package Q extends P; end Q; "
    "model M P.nothing x; end M;",
    "an import of what is imported": "package P import x = P.x; end P; model M P.x y; end M;",

    "redeclared by itself": "model A replaceable model B = C; B b; end A; model C Real x = 1; end C; "
    "model M A a(redeclare model B = A(redeclare model B = A)); end M;",
    "a record that holds itself": "record R R r; Real x; end R; model M R r; output Real y = r.x; end M;",
    "a constant that needs itself": "package P constant Real a = P.b; constant Real b = P.a; end P; "
    "model M output Real y = P.a; end M;",
    "a size that needs itself": model("parameter Integer n = size(x, 1); Real x[n];", "x = ones(n);"),
    "ten thousand packages in a chain": "".join(f"package P{i} extends P{i + 1}; end P{i}; " for i in range(3000))
    + "package P3000 end P3000; model M P0.nothing x; end M;",
    # numbers of things
    "2^40 instances": _doubling(40),


    "an array of 300000": model("Real z[300000];", "for i in 1:300000 loop der(z[i]) = -z[i]; end for;"),

    "a matrix of 10^5 by 10^5": model("Real z[100000, 100000];"),

    "a negative size": model("Real z[-5] = ones(-5); output Real y = z[1];"),
    "a parameter array of 10^9": model("parameter Real z[1000000000] = fill(1, 1000000000); output Real y = z[1];"),
    "a range to 1e9": _output("sum(1:1000000000)"),
    "a range of tiny steps": _output("sum(0:1e-12:1)"),
    "a range to infinity": _output("sum(1:1e400)"),

    "linspace of 1e9": _output("sum(linspace(0, 1, 1000000000))"),


    "fill of 1e9": _output("sum(fill(1.0, 1000000000))"),

    "fill in 30 dimensions": _output("sum(fill(1.0, " + ", ".join("2" * 30) + "))"),


    "a sum to 1e9": _output("sum(i for i in 1:1000000000)"),
    "a loop of 1e9 in a function": _output("f(1)", _function("f", "y := 0; for i in 1:1000000000 loop y := y + i; end for;")),
    "loops in loops": _output(
        "f(1)", _function("f", "y := 0; " + "for i in 1:1000 loop " * 4 + "y := y + 1;" + " end for;" * 4)
    ),
    "nested sums": _output(SUMS),
    "a function that calls itself twice": _output("f(45)", FIB),

    "two functions that call each other": _output(
        "f(1)", _function("f", "y := g(n);") + _function("g", "y := f(n) + f(n);")
    ),
    "an array that is copied": _output(
        "f(1)",
        _function("f", "for i in 1:90000 loop z[i] := i; end for; y := z[1];", locals_="Real z[90000];"),
    ),
    "connections of all with all": "connector C Real e; flow Real f; end C; model A C c; end A; "
    "model M A a[1500]; equation for i in 1:1500, j in 1:1500 loop connect(a[i].c, a[j].c); end for; end M;",
    "equations in loops": model("Real x;", "for i in 1:3000, j in 1:3000 loop x = i; end for;"),
    # texts

    "a string that grows": model(
        'parameter String s = f("x"); Real y = 1;',
        before="function f input String a; output String s; algorithm s := a; "
        "for i in 1:60 loop s := s + s; end for; end f;",
    ),
    # numbers
    "a number of 400 digits": _inputs("u*" + "9" * 400),

    "an exponent of a million digits": _output("1e" + "9" * 100000),

    "a product of huge integers": _output("product(i for i in 1:1000)"),
    "an integer that grows": _output("f(3)", _function("f", "y := n; for i in 1:40 loop y := y*y; end for;", "input Integer n;")),

    "division by zero": _output("1/0"),

    "exp(1000)": _output("exp(1000)"),
    "integer of infinity": _output("integer(1e308*10)"),
    "a subscript that is infinite": model("parameter Real z[2] = {1, 2}; output Real y = z[integer(1e308*10)];"),


    # wrong kinds
    "a text times a number": _output('product({"a", "b"})'),


    "scalar of nothing": _output("scalar({i for i in 1:0})"),

    "transpose of ragged rows": _output("sum(transpose({{1, 2}, {3}}))"),
    "size of a text": _output('size("a", "b")'),


    "mod by zero": _output("mod(1, 0)"),


    "a delay of a text": _inputs('delay(u, "a")'),

    "an operation of a record and a number": "record R Real x; end R; model M R r(x=1); output Real y = r + 1; end M;",
    "a comparison of a text and a number": model('parameter Boolean b = "a" < 1; output Real y = if b then 1 else 2;'),

    "an if over a text": model('output Real y = if "a" then 1 else 2;'),

    "a matrix product that does not fit": _output("sum({{1, 2}, {3}}*{{1}, {2}})"),

    "16 nested derivatives": model(
        "Real x[16]; output Real y = x[16];",
        "x[1] = sin(time)*exp(time)*cos(time*time); for i in 2:16 loop x[i] = der(x[i-1]); end for;",
    ),
    "a product of four matrices of unknowns": model(
        "input Real u; Real A[60, 60]; output Real y = sum(A*A*A*A);",
        "for i in 1:60, j in 1:60 loop A[i,j] = u*i*j; end for;",
    ),
    "equations that say the same": model("Real x, z; output Real y = x;", "x + z = 1; 2*x + 2*z = 2;"),


    "a loop that is singular at the start": model(
        "parameter Real a = 1; Real x, z; output Real y = x;", "x + z = 1; a*x + z = 2;"
    ),
    "too many unknowns": model("Real x[5000];", "for i in 1:5000 loop x[i] = i; end for;"),
}  # fmt: skip
"""Refused with a sentence that names the file and the line, within seconds and little memory."""

TAKEN: dict[str, str] = {
    "a product of 3000 factors": _inputs("*".join(["u"] * 3000)),
    "a sum of 10000 terms": _inputs("+".join(["u"] * 10000)),
    "elseif 3000": _inputs("if u > 0 then 0 " + "".join(f"elseif u > {i} then {i} " for i in range(1, 3000)) + "else 1"),
    "a conjunction of 2000": model(
        "input Real u; output Real y = if " + " and ".join(f"u > {i}" for i in range(2000)) + " then 1 else 2;"
    ),
    "50 parentheses": _inputs("(" * 50 + "u" + ")" * 50),
    "a dense loop of 100 unknowns": model(
        "Real x[100]; output Real y = x[1]; input Real u;",
        "for i in 1:100 loop sum(sin(i*j + 0.3*i*i)*x[j] for j in 1:100) + x[i] = u*i; end for;",
    ),
    "1000 components": model("parameter Real z[1000] = fill(1.0, 1000); output Real y = sum(z);"),
    "a chain of 100 states": model(
        "Real z[100](each start=1, each fixed=true); output Real y = z[100];",
        "der(z[1]) = -z[1]; for i in 2:100 loop der(z[i]) = z[i-1] - z[i]; end for;",
    ),
    "a chain of 60 parameters": model(
        "parameter Real p0 = 1; " + "".join(f"parameter Real p{i} = p{i - 1}; " for i in range(1, 60)) + "output Real y = p59;"
    ),
    "fib(12)": _output("f(12)", FIB),
    "a table of 3000 numbers": model(
        "parameter Real t[3000] = {" + ", ".join(map(str, range(3000))) + "}; output Real y = sum(t);"
    ),
}  # fmt: skip
"""Large, but no larger than that a compiler can take them."""
