"""Advice of a draft or a refusal, typed: it works, or leads to another question, never to the same one."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from tests.drafting.corpus import CASES, Case

QUICK = ("regulator: draw wire", "valves: numbered", "imposed: volts", "logger: oscilloscope")
_OPTION = re.compile(
    r"--(model|muscle|valve|column|parameter|recording)[ =]"
    r"""((?:'[^']*'|"(?:[^"\\]|\\.)*"|[^\s'";,)])+)"""
)
_GROUPS = {"column": "columns", "parameter": "parameters", "recording": "recording"}
_OPEN = ("NAME", "...", "FILE")  # what a person has to fill in


def typed(sentence: str) -> Iterator[dict[str, Any]]:
    """The wishes of each alternative that a sentence tells to type."""
    for alternative in re.split(r", or |; |, say ", sentence):
        wishes: dict[str, Any] = {}
        for option, word in _OPTION.findall(alternative):
            value = shlex.split(word)[0]
            if any(gap in value for gap in _OPEN):
                break
            name, _, text = value.partition("=")
            wishes |= (
                {_GROUPS[option]: {name: text}} if option in _GROUPS else {option: value}
            )  # fmt: skip
        else:
            if wishes:
                yield wishes


def merged(one: Mapping[str, Any], other: Mapping[str, Any]) -> dict[str, Any]:
    """Wishes with others, of which those count."""
    nested = {n: {**one.get(n, {}), **v} for n, v in other.items() if isinstance(v, Mapping)}
    return {**one, **other, **nested}


def asked(place: Path, files: list[Path], wishes: Mapping[str, Any]) -> list[str]:
    """The questions of a draft, or the one refusal."""
    try:
        return list(pam.new(place, files, **wishes).to_check)
    except InputError as error:
        return [str(error)]


def check(place: Path, files: list[Path], wishes: Mapping[str, Any]) -> int:
    """Types every piece of advice; how many there are."""
    count = 0
    for sentence in asked(place / "plain", files, wishes):
        for answer in typed(sentence):
            count += 1
            then = asked(place / str(count), files, merged(wishes, answer))
            assert sentence not in then, (answer, sentence)
            assert not any("feeds no bench" in one for one in then), (answer, then)
    return count


@pytest.mark.parametrize(
    "case",
    [
        pytest.param(c, id=c.name.replace(": ", "-"), marks=[pytest.mark.full] * (c.name not in QUICK))
        for c in CASES
    ],
)  # fmt: skip
def test_the_advice_of_a_draft_can_be_typed(case: Case, tmp_path: Path) -> None:
    check(tmp_path, case.write(tmp_path / "files"), case.stated)


ROWS = "".join(f"{k * 0.01:.2f},{min(k, 90)},{min(k, 90) / 4}\n" for k in range(200))
REFUSED = {
    "counts": ("run.csv", "t [s],p [kPa],x [counts]\n" + ROWS),
    "no words": ("run.csv", "t [s],CH1,CH2\n" + ROWS),
    "another quantity": ("run.csv", "t [s],p [kPa],Druck 2 [mm]\n" + ROWS),
    "unknown unit": ("run.csv", "t [s],p [kPa],x [furlongs]\n" + ROWS),
    "factor": ("run.csv", "t [s],p [kPa],x in mm/10\n" + ROWS),
    "transmitter": ("run.csv", "t [s],Druck [mA],x [mm]\n" + ROWS),
    "no time": ("run.csv", "u_in [A],p [kPa],x [mm]\n" + ROWS.replace("0.", "2.")),
    "thousands": ("run.csv", "t [ms];p [kPa];x [mm]\n" + "1;1,234;2\n2;1,235;2\n3;1,236;2\n"),
    "angle": ("run.csv", "t [s],p [kPa],phi [deg]\n" + ROWS),
    "voltage": ("run.csv", "t [s],p [kPa],U_valve [V]\n" + ROWS),
}


@pytest.mark.parametrize("name", REFUSED)
def test_the_advice_of_a_refusal_can_be_typed(name: str, tmp_path: Path) -> None:
    file, text = REFUSED[name]
    (tmp_path / file).write_text(text)
    assert check(tmp_path, [tmp_path / file], {}) > 0
