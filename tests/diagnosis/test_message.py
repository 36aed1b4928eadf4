"""What a diagnosis tells while it goes on: lines that print as they are and know what they are."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

import pam_cosim as pam
from pam_cosim.cli.commands.common import follower, teller
from pam_cosim.diagnosis import (
    BaseFitted,
    EffectProbed,
    Event,
    FailedTrial,
    Judged,
    Message,
    Remark,
)
from pam_cosim.diagnosis.judgement.events import listened
from pam_cosim.diagnosis.search.search import result_message
from rig.short import write_light_data


class Status:
    """A status line that remembers what it showed."""

    def __init__(self) -> None:
        self.shown: list[str] = []

    def update(self, text: str) -> None:
        self.shown.append(text)


def test_a_result_is_a_detail_and_a_step_a_headline() -> None:
    failed = result_message(
        FailedTrial("Spring", "elasticity", "force", ("Spring",), "no start value can be simulated")
    )
    assert failed == "  Spring (elasticity): could not be fitted: no start value can be simulated"
    assert failed.detail and not Message("fitting 3 effects").detail


def test_status_line_counts_the_results_since_the_last_headline() -> None:
    status = Status()
    say = teller(status)
    for message in (
        Message("  fitting [red]"),
        Message("a", detail=True),
        Message("b", detail=True),
        Message("added a"),
    ):
        say(message)
    assert status.shown == [
        r"  fitting \[red]",
        r"  fitting \[red]: 1 done",
        r"  fitting \[red]: 2 done",
        "added a",
    ]


def test_a_diagnosis_prints_what_it_tells(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    messages: list[Message] = []

    def say(message: Message) -> None:
        messages.append(message)
        print(message)

    pam.diagnose(
        pam.read(write_light_data(tmp_path / "d", [], 1)), say=say, workers=0, explain=False
    )
    lines = capsys.readouterr().out.splitlines()
    assert lines == messages and lines[0].startswith("base model refitted: ")
    assert [m.detail for m in messages] == [line.startswith("  ") for line in lines]
    assert messages[-1] == "what remains is noise: no effect is tried"


def test_what_happens_is_told_as_data_too(tmp_path: Path) -> None:
    lines: list[Message] = []
    events: list[Event] = []
    data = pam.read(write_light_data(tmp_path / "d", [], 1))
    diagnosis = pam.diagnose(
        data, say=lines.append, progress=events.append, workers=0, explain=False
    )
    spoken = [event for event in events if str(event)]
    assert [event.message for event in spoken] == lines and [line.event for line in lines] == spoken
    assert isinstance(events[0], BaseFitted) and events[0].fit.values == diagnosis.base.values
    assert (
        isinstance(events[-1], Judged)
        and events[-1].verdict == diagnosis.verdict
        and not str(events[-1])
    )


def test_a_line_is_copied_with_what_it_knows() -> None:
    said = Message("Spring (elasticity)", detail=True, event=("tried", "Spring"))
    copied = pickle.loads(pickle.dumps(said))
    assert copied == said == "  Spring (elasticity)"
    assert type(copied) is Message and copied.detail and copied.event == ("tried", "Spring")


def test_how_many_are_done_is_told_as_data_alone() -> None:
    lines: list[Message] = []
    events: list[Event] = []
    tell = listened(lines.append, events.append)
    tell(Remark("looking at what each of 2 effects would change").message)
    tell(EffectProbed(1, 2).message)
    tell(EffectProbed(2, 2).message)
    assert len(lines) == 1 and [type(event) for event in events[1:]] == [EffectProbed] * 2
    status = Status()
    for event in events:
        follower(status)(event)
    assert status.shown[-1].endswith("2 of 2 done") and len(status.shown) == 2
    alone: list[Message] = []
    listened(alone.append, None)(EffectProbed(1, 2).message)
    assert not alone
