"""``assert``: what becomes of conditions, messages and levels."""

from pathlib import Path

import casadi as ca
import pytest

from pam_cosim.compiler import compile_model
from pam_cosim.errors import ModelError
from tests.compiler.run import MODELS, compiled, defaults


def holds(ode, x=(), u=(), t=0.0):
    arguments = [ode.t, ode.x, ode.u, ode.d, ode.p]
    function = ca.Function("f", arguments, [ca.vertcat(*[s.condition for s in ode.statements])])
    return [bool(v) for v in function(t, list(x), list(u), [], defaults(ode)).full().ravel()]


def test_conditions_messages_and_levels():
    ode = compiled("Assertions.Growing")
    assert [s.is_error for s in ode.statements] == [True, False, True, True]
    assert [s.at_start for s in ode.statements] == [True, False, False, False]
    assert ode.statements[2].texts == ("x = ", " is not below 2 (k = ", ")")
    assert [digits for _, digits in ode.statements[2].values] == [3, 6]
    assert holds(ode, [0.5], [0.0]) == [True, True, True, True]
    assert holds(ode, [1.5], [9.0]) == [True, False, True, False]


def test_a_function_s_assertion_counts_where_it_is_called():
    ode = compiled("Assertions.InFunctions")
    texts = [s.texts[0] for s in ode.statements]
    assert sorted(texts) == ["Assertions.checked: too large", "part: the part is full"]
    at = texts.index("Assertions.checked: too large")
    for t, x, expected in (
        (0.0, 50.0, True),
        (4.0, 0.5, True),
        (4.0, 1.5, True),
        (4.0, 50.0, False),
    ):
        assert holds(ode, [x], t=t)[at] is expected


def test_branches_and_the_start():
    ode = compiled("Assertions.Conditional")
    assert len(ode.statements) == 1
    assert [holds(ode, [x]) for x in (0.5, 1.2, 1.6)] == [[True], [True], [False]]
    assert [s.at_start for s in compiled("Assertions.AtStart").statements] == [True]


def test_models_without_assertions_have_none():
    assert compiled("Tanks.Bench").statements == ()


@pytest.mark.parametrize(
    ("call", "words"),
    [
        ("assert(x < 1)", "takes a condition, a message and a level"),
        ('assert(x < 1, "a", AssertionLevel.error, 2)', "takes a condition, a message and a level"),
        ('assert(x, "a", AssertionLevel.fatal)', "no member 'fatal'"),
        ('assert(x < 1, "a", StateSelect.never)', "AssertionLevel.error or AssertionLevel.warning"),
        ("assert(x < 1, x)", "a String is needed: write String(x)"),
        ('assert(1, "a")', "must be a Boolean"),
        ('assert(1 > 2, "one is less")', "assertion fails: one is less"),
        (
            'assert(x < 1, "a" + String(x, format="%n"))',
            "String() takes one value, and significantDigits",
        ),
        (
            'assert(x < 1, "a" + String(x, significantDigits=40))',
            "must lie between 1 and 17, not 40",
        ),
    ],
)
def test_refused_with_its_place(call: str, words: str, tmp_path: Path):
    file = tmp_path / "M.mo"
    file.write_text(
        f"model M\n  Real x(start=0, fixed=true);\nequation\n  der(x) = 1;\n  {call};\nend M;\n"
    )
    with pytest.raises(ModelError) as caught:
        compile_model(str(file), root=MODELS)
    assert words in str(caught.value) and (caught.value.file, caught.value.line) == (file, 5)
