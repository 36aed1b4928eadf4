"""Recordings of invented laboratories: right as they are, with one answer, never wrong without a mark."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafting.corpus import CASES
from tests.drafting.corpus_score import outcome

ANSWERED = {"imposed: counts", "imposed: volts", "logger: oscilloscope"}
QUICK = {
    "regulator: german", "regulator: draw wire", "valves: numbered", "press: kilograms", "tank: german", "vessel: psia",
    "switches: words", "map: ratio", "pairs: structures", "load cell: wire", "imposed: volts",
    "abroad: polish", "abroad: paths", "logger: dspace", "logger: plc", "logger: numpy",
}  # fmt: skip


def test_there_are_enough() -> None:
    assert len({case.name.partition(":")[0] for case in CASES}) >= 10
    assert sum(len(case.files) for case in CASES) >= 60


@pytest.mark.parametrize(
    "case",
    [
        pytest.param(
            c, id=c.name.replace(": ", "-"), marks=[pytest.mark.full] * (c.name not in QUICK)
        )
        for c in CASES
    ],
)
def test_a_recording_is_drafted(case: object, tmp_path: Path) -> None:
    kind, why = outcome(case, tmp_path)  # type: ignore[arg-type]
    assert kind == ("answered" if case.name in ANSWERED else "right"), why  # type: ignore[attr-defined]
