"""What is stated of the start of a run, of the time before it, and of gaps."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, read_data_set
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.starts.run_start import inputs_of_run, start_time

BENCH = Interface("Bench", {"u": Variable("u", "A", start=0.0)}, {"p": Variable("p", "Pa")}, {})
ROWS = "".join(f"{t:g},{t / 10:g},{100 + t:g}\n" for t in np.arange(0.0, 2.0, 0.1))


@pytest.fixture
def read(tmp_path: Path) -> Callable[..., DataSet]:
    def made(top: str = "", run: str = "", rows: str = ROWS) -> DataSet:
        (tmp_path / "run.csv").write_text("time [s],u [A],p [Pa]\n" + rows)
        text = f'{top}\nmodel = "Bench"\n[signals.p]\nsigma = "1 Pa"\n[[runs]]\nfile = "run.csv"\n{run}\n'
        (tmp_path / "experiment.toml").write_text(text)
        return read_data_set(tmp_path, lambda _: BENCH)

    return made


def test_a_run_overrides_what_is_stated_for_all(read: Callable[..., DataSet]) -> None:
    assert read().runs[0].start.mode is None
    assert read('start = "steady"').runs[0].start.mode == "steady"
    assert read('start = "steady"', 'start = "rest"').runs[0].start.mode == "rest"


def test_what_was_before_is_held_before_the_first_row(read: Callable[..., DataSet]) -> None:
    run = read(run='before = { u = "200 mA", for = "5 s" }').runs[0]
    assert (run.start.mode, run.start.seconds, dict(run.start.before)) == ("rest", 5.0, {"u": 0.2})
    inputs = inputs_of_run(run)
    assert inputs is not None and start_time(run) == -5.0
    assert inputs.time[:3].tolist() == [-5.0, 0.0, 0.0] and inputs.values["u"][:3].tolist() == [
        0.2,
        0.2,
        0.0,
    ]


def test_a_periodic_run_is_repeated(read: Callable[..., DataSet]) -> None:
    from dataclasses import replace

    run = read("periodic = true").runs[0]
    run = replace(run, start=replace(run.start, periods=3))
    inputs = inputs_of_run(run)
    assert inputs is not None and start_time(run) == pytest.approx(-6.0)
    assert (
        inputs.time[0] == pytest.approx(-6.0)
        and len(inputs.time) == 80
        and (np.diff(inputs.time) > 0).all()
    )


@pytest.mark.parametrize(
    ("top", "run", "words"),
    [
        ("", 'before = { u = "200 mA" }', "for is missing"),
        ("", 'before = { q = "200 mA", for = "5 s" }', "'q' is no input of Bench"),
        ("", 'before = { u = "2 mm", for = "5 s" }', "u"),
        ("", 'before = { u = "200 mA", for = "-5 s" }', "for must be greater than zero"),
        (
            "",
            'start = "measured"\nbefore = { u = "200 mA", for = "5 s" }',
            "begins at the first samples",
        ),
        ("", 'lead = "20 s"', "no sample would be scored"),
        ("", 'periodic = true\nstart = "rest"', "keep one of them"),
        ("", 'start = "asleep"', "'asleep' is not possible"),
        ('gaps = "jump"', "", "'jump' is not possible"),
    ],
)
def test_refused(read: Callable[..., DataSet], top: str, run: str, words: str) -> None:
    with pytest.raises(InputError, match="experiment.toml:") as caught:
        read(top, run)
    assert words in str(caught.value)


LATER = "".join(f"{t:g},0.1,{100 + t:g}\n" for t in np.arange(10.0, 11.0, 0.1))
AGAIN = "".join(f"{t:g},0.1,{100 + t:g}\n" for t in np.arange(0.0, 1.0, 0.1))


def test_pieces_are_runs(read: Callable[..., DataSet]) -> None:
    first, second = read('gaps = "split"', rows=ROWS + LATER).runs
    assert (first.name, second.name) == ("run piece 1", "run piece 2")
    assert (len(first.time), len(second.time)) == (20, 10) and second.time[0] == 10.0
    assert second.inputs["u"].tolist() == [0.1] * 10


def test_time_that_goes_back(read: Callable[..., DataSet]) -> None:
    with pytest.raises(
        InputError,
        match='time goes back, from 1.9 s to 0 s; in a data set state what that means: gaps = "split"',
    ):
        read(rows=ROWS + AGAIN)
    first, second = read('gaps = "split"', rows=ROWS + AGAIN).runs
    assert (len(first.time), len(second.time)) == (20, 10)
    assert "time goes back once, after 1.9 s: a piece of its own" in first.notes[-1]
    [run] = read('gaps = "through"', rows=ROWS + AGAIN).runs
    assert run.time[20] == pytest.approx(2.0) and (np.diff(run.time) > 0).all()
