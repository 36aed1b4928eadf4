"""The real command ``new``: from files to ``compare``, and one error with nothing written for what cannot be used."""

from __future__ import annotations

import re
import shlex
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from pam_cosim.cli.arguments import parse_pairs
from pam_cosim.errors import InputError
from tests.cli.conftest import ROOT, Outcome, everything
from tests.drafting.labs import german, several

Command = Callable[..., Outcome]
ROWS = "".join(f"{0.01 * i:.2f},{min(i, 200)},{0.1 * min(i, 200):.2f}\n" for i in range(300))
GOOD = f"time [s],p [kPa],x [mm]\n{ROWS}"


def test_from_files_to_a_comparison(command: Command, place: Path) -> None:
    several(german, place / "data", ([2e5, 3e5], 1), ([3e5, 4e5], 3), ([2.5e5, 3.5e5], 5))
    files = sorted((place / "data").iterdir())
    outcome = command(
        "new my-rig", *files, "--parameter", "load.m=2.27 kg", "--title", "steps of a regulator"
    )
    assert outcome.status == 0, outcome.err
    for words in (
        "Solldruck",
        "p_set [bar] (input)",
        "Bemerkung",
        "holdout",
        "muscle.L0",
        "pam-cosim compare my-rig",
    ):
        assert words in outcome.out
    assert "written: my-rig" in outcome.err
    assert sorted(one.name for one in (place / "my-rig").iterdir()) == sorted(
        ["experiment.toml", "MyRig.mo", *(file.name for file in files)]
    )
    assert all((place / "my-rig" / file.name).read_bytes() == file.read_bytes() for file in files)
    compared = command("compare my-rig")
    assert compared.status == 0, compared.err
    assert "steps of a regulator" in compared.out and "holdout" in compared.out


@pytest.mark.full
def test_page(command: Command, place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The commands and the script of ``docs/new-data-set.md`` run as they stand, and its example is what is written."""
    whole = (ROOT / "docs" / "new-data-set.md").read_text()
    page, _, _ = whole.partition("## A second logger")  # that is of other files
    several(
        german,
        place / "data",
        ([2e5, 3e5, 1e5], 1),
        ([3e5, 4e5, 2e5], 3),
        ([2.5e5, 3.5e5, 1.5e5], 5),
    )
    files = [str(file.relative_to(place)) for file in sorted((place / "data").iterdir())]
    lines = [
        line
        for block in re.findall(r"```sh\n(.*?)```", page, re.DOTALL)
        for line in block.splitlines()
    ]
    *lines, static = lines
    assert len(lines) == 2 and "DMSP-20-300" in static
    for line in lines:
        words = [
            one
            for word in shlex.split(line)[1:]
            for one in (files if word == "data/*.csv" else [word])
        ]
        outcome = command(*words)
        assert outcome.status == 0, outcome.err
    [example] = re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
    assert example in (place / "my-rig" / "experiment.toml").read_text(encoding="utf-8")
    shutil.rmtree(place / "my-rig")
    [script] = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    exec(compile(script, "docs/new-data-set.md", "exec"), {})
    assert "holdout" in capsys.readouterr().out


def test_a_muscle_by_name(command: Command, place: Path) -> None:
    (place / "a.csv").write_text(GOOD)
    outcome = command("new rig a.csv --muscle DMSP-20")
    assert outcome.status == 0, outcome.err
    assert "DMSP_20" in (place / "rig" / "Rig.mo").read_text().replace("-", "_")
    assert command("compare rig").status == 0
    for options, word in (
        (["--muscle", "DMSP-21"], "DMSP-2"),
        (["--muscle", "DMSP-20", "--model", "Isotonic"], "Isotonic"),
    ):
        outcome = command("new other a.csv", *options)
        assert (outcome.status, outcome.err.count("\n")) == (2, 1) and word in outcome.err, (
            outcome.err
        )


WRONG: dict[str, tuple[str, list[str], list[str]]] = {
    "not a number": (
        GOOD.replace("1.00,100", "1.00,abc"),
        [],
        ["a.csv:102", "column 'p'", "'abc'"],
    ),
    "no time": (GOOD.replace("time [s]", "N"), ["--column", "p=p", "--column", "time=M"], ["'M'"]),
    "dates": (
        "Datum,p [kPa],x [mm]\n" + "2024-02-01,1,2\n" * 5,
        [],
        ["neither a column", "p_set"],
    ),
    "gap": (GOOD.replace("1.00,100", "1.00,"), [], ["a.csv:102", "column 'p'", "empty"]),
    "nobody knows": (
        "time [s],foo,bar2\n0,1,2\n1,3,4\n",
        [],
        ["no column is recognised", "foo", "--column"],
    ),
    "inputs alone": ("time [s],p_set [kPa]\n0,1\n1,3\n", [], ["p_set (set pressure)", "lacks"]),
    "an output alone": (
        GOOD.replace("x [mm]", "source [kPa]"),
        [],
        ["feeds no bench", "lacks the inputs"],
    ),
    "unknown column": (GOOD, ["--column", "p=Druck"], ["--column p", "'Druck'", "Known"]),
    "unknown variable": (GOOD, ["--column", "pp=p"], ["'pp'", "did you mean"]),
    "unknown bench": (GOOD, ["--model", "Nothing"], ["Nothing"]),
    "not a pair": (GOOD, ["--parameter", "load.m"], ["load.m", "NAME=VALUE"]),
    "unknown key": (GOOD, ["--recording", "decimals=,"], ["'decimals'", "did you mean 'decimal'"]),
    "wrong key": (GOOD, ["--recording", "decimal=x"], ["decimal", "'x'"]),
}


@pytest.mark.parametrize("case", WRONG)
def test_one_error_and_nothing_written(command: Command, place: Path, case: str) -> None:
    text, options, words = WRONG[case]
    (place / "a.csv").write_text(text)
    before = everything(place)
    outcome = command("new rig a.csv", *options)
    assert (outcome.status, outcome.out, outcome.err.count("\n")) == (2, "", 1), outcome.err
    assert all(word in outcome.err for word in words), outcome.err
    assert everything(place) == before and not (place / "rig").exists()
    assert not [one for one in place.iterdir() if one.name.startswith(".")]


def test_nothing_is_overwritten(command: Command, place: Path) -> None:
    (place / "a.csv").write_text(GOOD)
    (place / "rig").mkdir()
    (place / "rig" / "mine.txt").write_text("mine")
    for folder, word in (("rig", "not empty"), ("a.csv", "no folder")):
        before = everything(place)
        outcome = command("new", folder, "a.csv")
        assert outcome.status == 2 and word in outcome.err
        assert everything(place) == before
    missing = command("new other b.csv")
    assert missing.status == 2 and "b.csv" in missing.err and not (place / "other").exists()


def test_lists_may_be_given_in_several_options() -> None:
    lists = ("ignore",)
    assert parse_pairs(["ignore=A", "ignore=B", "decimal=,"], lists) == {
        "ignore": "A,B",
        "decimal": ",",
    }
    with pytest.raises(InputError, match="'decimal' is given twice"):
        parse_pairs(["decimal=,", "decimal=."], lists)
