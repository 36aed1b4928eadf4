"""What a person sees of a model's own assertions."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from tests.cli.conftest import Outcome

MODEL = """\
model Rising
  Real x(start=0, fixed=true);
  output Real y = x;
equation
  assert(x < 1, "x has passed one", AssertionLevel.warning);
  assert(x < 2, "x must stay below two");
  der(x) = 1;
end Rising;
"""


def test_the_command_ends_with_the_message(place: Path, command: Callable[..., Outcome]) -> None:
    (place / "Rising.mo").write_text(MODEL)
    outcome = command("simulate", "Rising.mo", "--stop-time", "20", "-o", "out.csv")
    assert outcome.status == 1
    assert "at time 2 s: x must stay below two" in outcome.err and "Traceback" not in outcome.err
    assert not (place / "out.csv").exists()


def test_a_warning_is_told_once_and_the_run_goes_on(
    place: Path, command: Callable[..., Outcome]
) -> None:
    (place / "Rising.mo").write_text(MODEL)
    outcome = command("simulate", "Rising.mo", "--stop-time", "1.9", "-o", "out.csv")
    assert outcome.status == 0 and (place / "out.csv").exists()
    assert (
        outcome.out.count(
            "LOOK FIRST: an assertion of the model fails at time 1 s: x has passed one"
        )
        == 1
    )


def test_a_condition_on_a_condition(place: Path, command: Callable[..., Outcome]) -> None:
    """A missing else has no equations, and an assertion is none (Modelica 3.6, section 8.3.4)."""
    branch = 'if x > 1 then\n    assert(k > 5, "too slow beyond one");\n  end if;'
    text = MODEL.replace('assert(x < 2, "x must stay below two");', branch).replace(
        "der(x) = 1;", "der(x) = k;"
    )
    (place / "Rising.mo").write_text(
        text.replace("  Real x(", "  parameter Real k = 1;\n  Real x(", 1)
    )
    outcome = command("simulate", "Rising.mo", "--stop-time", "3")
    assert outcome.status == 1 and "at time 1 s: too slow beyond one" in outcome.err
    assert command("simulate", "Rising.mo", "--stop-time", "3", "--set", "k=6").status == 0
