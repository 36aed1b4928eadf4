"""A clock that is a counter of so many bits goes on where these are full; one that was set back does not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.measurement import read_data_set
from pam_cosim.measurement.table import Column, Table
from pam_cosim.measurement.wrapped_clocks import with_clocks_going_on
from pam_cosim.model.interface import Interface, Variable

COUNT = 50
JITTER = np.random.default_rng(1).integers(-80, 80, COUNT)
EVEN = 10_000 * np.arange(COUNT)
BENCH = Interface("Bench", {"u": Variable("u", "A", start=0.0)}, {"p": Variable("p", "Pa")}, {})


def table(values: np.ndarray) -> Table:
    return Table(Path("a.csv"), {"t": Column("t", "us", values.astype(float))})


@pytest.mark.parametrize(
    ("bits", "values"),
    [
        (32, (2**32 - 200_000 + EVEN) % 2**32),
        (32, (2**32 - 200_000 + EVEN + JITTER) % 2**32),
        (32, (2**32 - 200_000 + EVEN) % 2**32 - 2**31),
        (16, (62_000 + EVEN // 10) % 2**16),
        (16, (EVEN // 2) % 2**16),
    ],
    ids=["32 bits", "jitter", "signed", "16 bits", "several times"],
)
def test_a_full_counter_goes_on(bits: int, values: np.ndarray) -> None:
    read = with_clocks_going_on(table(values))
    assert (np.diff(read.columns["t"].values) > 0.0).all()
    np.testing.assert_array_equal((read.columns["t"].values - values) % 2**bits, 0.0)
    assert f"that of t, which has {bits} bits" in read.notes[0]


@pytest.mark.parametrize(
    "values",
    [
        EVEN,
        EVEN % 250_000,
        np.concatenate([EVEN, EVEN + 2**16]) % (2**16 + 30),
        (2**32 - 200_000 + EVEN * np.linspace(1.0, 3.0, COUNT).round()) % 2**32 + 0.5,
        np.where(np.arange(COUNT) == 20, 0, EVEN),
    ],
    ids=["on and on", "begins anew", "not its bits", "no whole numbers", "a wrong cell"],
)
def test_what_goes_back_otherwise_stays(values: np.ndarray) -> None:
    assert with_clocks_going_on(table(values)).columns["t"].values.tolist() == values.tolist()


def test_other_columns_stay() -> None:
    read = table((2**32 - 200_000 + EVEN) % 2**32)
    assert with_clocks_going_on(read, frozenset({"time"})) is read


def test_a_run_of_a_full_counter_is_one(tmp_path: Path) -> None:
    rows = "".join(f"{t},0.1,100\n" for t in (2**32 - 200_000 + EVEN) % 2**32)
    (tmp_path / "run.csv").write_text("micros,u [A],p [Pa]\n" + rows)
    (tmp_path / "experiment.toml").write_text(
        'model = "Bench"\n[columns]\ntime = { column = "micros", unit = "us" }\n'
        '[signals.p]\nsigma = "1 Pa"\n[[runs]]\nfile = "run.csv"\n'
    )
    (run,) = read_data_set(tmp_path, lambda _: BENCH).runs
    np.testing.assert_allclose(np.diff(run.time), 0.01)
    assert any(note.startswith("a counter was full once") for note in run.notes)
