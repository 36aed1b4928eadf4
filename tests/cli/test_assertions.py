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
    outcome = command("simulate Rising.mo --stop-time 20 -o out.csv")
    assert outcome.status == 1
    assert "at time 2 s: x must stay below two" in outcome.err and "Traceback" not in outcome.err
    assert not (place / "out.csv").exists()


def test_a_warning_is_printed_once_and_the_run_continues(
    place: Path, command: Callable[..., Outcome]
) -> None:
    (place / "Rising.mo").write_text(MODEL)
    outcome = command("simulate Rising.mo --stop-time 1.9 -o out.csv")
    assert outcome.status == 0 and (place / "out.csv").exists()
    assert (
        outcome.out.count(
            "LOOK FIRST: an assertion of the model fails at time 1 s: x has passed one"
        )
        == 1
    )
