"""Runs that begin later or end earlier than their recording: by the data set, or by whoever reads it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, overrides_of, read_data_set
from pam_cosim.model.interface import Interface, Variable

BENCH = Interface("Bench", {"u": Variable("u", "A", start=0.0)}, {"p": Variable("p", "Pa")}, {})
TIMES = np.arange(20) / 10
ROWS = "".join(f"{t:g},{t / 10:g},{100 + t:g}\n" for t in TIMES)


@pytest.fixture
def read(tmp_path: Path) -> Callable[..., DataSet]:
    def made(run: str = "", rows: str = ROWS, **overrides: dict) -> DataSet:
        (tmp_path / "run.csv").write_text("time [s],u [A],p [Pa]\n" + rows)
        text = f'model = "Bench"\n[signals.p]\nsigma = "1 Pa"\n[[runs]]\nfile = "run.csv"\n{run}\n'
        (tmp_path / "experiment.toml").write_text(text)
        return read_data_set(tmp_path, lambda _: BENCH, overrides=overrides_of(**overrides))

    return made


def test_a_run_is_what_lies_between_its_ends(read: Callable[..., DataSet]) -> None:
    run = read('from = "500 ms"\nto = "1.2 s"').runs[0]
    assert run.time.tolist() == pytest.approx([0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2])
    assert run.inputs["u"][0] == pytest.approx(0.05) and run.measurements["p"][-1] == pytest.approx(
        101.2
    )
    assert run.recorded == (0.0, 1.9) and "0.5 to 1.2 s of 0 to 1.9 s" in run.describe()
    assert read().runs[0].recorded is None
    assert read('from = "-5 s"\nto = "9 s"').runs[0].recorded is None  # nothing was cut


def test_whoever_reads_may_cut_elsewhere_or_not_at_all(read: Callable[..., DataSet]) -> None:
    stated = 'from = "0.5 s"\nto = "1.2 s"'
    assert read(stated, cuts={"run": ("0.9 s", None)}).runs[0].time[
        [0, -1]
    ].tolist() == pytest.approx([0.9, 1.9])
    assert read(stated, cuts={"run": (None, None)}).runs[0].recorded is None


def test_a_start_is_of_the_first_sample_that_it_was_stated_for(
    read: Callable[..., DataSet],
) -> None:
    stated = 'start = "rest"\nlead = "0.3 s"'
    assert read(stated).runs[0].start.mode == "rest"
    assert read('from = "0.5 s"\n' + stated).runs[0].start.mode == "rest"  # both are stated
    later = read(stated, cuts={"run": (0.5, None)}).runs[0]
    assert later.start.mode is None and later.sample_count("p") == len(later.time)
    shorter = read(stated, cuts={"run": (None, 1.0)}).runs[0]
    assert shorter.start.mode == "rest" and shorter.start.lead == 0.3


@pytest.mark.parametrize(
    ("run", "overrides", "said"),
    [
        ('from = "1 m"', {}, "from: "),
        ('from = "5 s"', {}, "no samples lie between 5 and 1.9 s"),
        ('from = "1 s"\nto = "0.5 s"', {}, "no samples lie between"),
        ("to = 1.5", {}, "needs a unit"),
        ("form = 1", {}, "did you mean 'from'"),
        ("", {"cuts": {"rum": (None, 1)}}, "did you mean 'run'"),
        ("", {"starts": {"rum": "rest"}}, "did you mean 'run'"),
        ("", {"starts": {"run": "moving"}}, "rest, steady, measured, estimated"),
        ("", {"cuts": {"run": ("soon", None)}}, "from"),
        ("", {"cuts": {"run": (float("nan"), None)}}, "finite"),
        ("", {"cuts": {"run": "0:1"}}, "a first and a last time"),
        ("", {"cuts": {"run": (3, 4)}}, "no samples lie between"),
    ],
)
def test_what_cannot_be_cut_is_refused_in_words(
    read: Callable[..., DataSet], run: str, overrides: dict, said: str
) -> None:
    with pytest.raises(InputError, match=said) as caught:
        read(run, **overrides)
    if run:
        assert caught.value.line is not None


def test_a_pattern_means_the_runs_that_match_it(read: Callable[..., DataSet]) -> None:
    run = read(cuts={"r*": ("0.5 s", None), "ru*": ("0.7 s", None)}, starts={"r*n": "steady"}).runs[
        0
    ]
    assert run.time[0] == 0.7 and run.start.mode == "steady"
    with pytest.raises(InputError, match=r"has no run 'test\*'; .*Known: run"):
        read(starts={"test*": "rest"})


def test_a_pattern_gives_roles_to_the_runs_without_an_own_one(read: Callable[..., DataSet]) -> None:
    rows = ROWS + "".join(f"{t:g},0,100\n" for t in TIMES + 50)
    data = read('gaps = "split"', rows=rows)
    assert [run.name for run in data.runs] == ["run piece 1", "run piece 2"]
    for roles in ({"run piece 1": "fit", "run*": "holdout"}, {"*": "fit", "*2": "holdout"}):
        assert [run.role for run in data.with_roles(roles).runs] == ["fit", "holdout"]
    with pytest.raises(InputError, match=r"has no run 'test\*'"):
        data.with_roles({"test*": "holdout"})
    with pytest.raises(InputError, match="no run would be left to fit"):
        data.with_roles({"*": "holdout"})


AGAIN = '[[runs]]\nfile = "run.csv"\nrole = "holdout"\n'


@pytest.mark.parametrize(
    ("first", "second"),
    [("", ""), ('to = "1.2 s"', ""), ('to = "1.2 s"', 'from = "1.1 s"'), ('from = "1 s"', "")],
)
def test_no_sample_is_of_two_runs(read: Callable[..., DataSet], first: str, second: str) -> None:
    with pytest.raises(InputError, match="'run.csv' is listed twice, and its runs share samples"):
        read(f"{first}\n{AGAIN}{second}")
