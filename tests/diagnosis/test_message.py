"""What a diagnosis tells while it goes on: lines that print as they are and know what they are."""

from __future__ import annotations

from pathlib import Path

import pytest

import pam_cosim as pam
from pam_cosim.diagnosis import (
    BaseFitted,
    Event,
    Judged,
    Message,
)
from rig.short import write_light_data


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
