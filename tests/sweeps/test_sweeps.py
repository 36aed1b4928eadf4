"""Sweeps: the same numbers wherever they are made, kept when stopped, in every format."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from threading import Event
from typing import Any

import numpy as np
import pandas
import pytest
import xarray

import pam_cosim as pam
from pam_cosim.sweeps import executors, partial_of, same
from tests.documentation.pages import ROOT
from tests.fmu import models

VARY: dict[str, Any] = {"u_in": np.linspace(0.25, 0.35, 4), "p_supply": ["138 kPa", "207 kPa"]}
SCALARS = {"last pressure": "final(p)", "peak temperature": "max(T)"}
MODEL = "TankFilling"


def swept(**more: Any) -> pam.Sweep:
    return pam.sweep(MODEL, VARY, **{"stop_time": 2.0, "workers": 1, **more})


@pytest.fixture(scope="module")
def reference() -> pam.Sweep:
    return swept(scalars=SCALARS, trajectories=True)


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a Dask scheduler with two processes."""
    from distributed import LocalCluster

    folder = tmp_path_factory.mktemp("cluster")
    with LocalCluster(  # type: ignore[no-untyped-call]
        n_workers=2, threads_per_worker=1, dashboard_address=None, local_directory=folder
    ) as started:
        yield started.scheduler_address


def test_every_run_is_what_simulate_makes(reference: pam.Sweep) -> None:
    assert len(reference) == 8
    for point in reference:
        alone = pam.simulate(MODEL, point.parameters, stop_time=2.0)
        assert point.trajectory is not None and point.failure is None
        for name in ("p", "T"):
            assert np.array_equal(point.trajectory[name], alone[name])
        assert point.scalars["peak temperature"] == alone["T"].max()


def test_times_of_runs_that_have_not_settled_are_missing_and_said_to_be() -> None:
    """After 5 s the tank has a tenth of its supply or so; after 60 s at 0.35 A it is full, at 0.2 A it is not."""
    times = {"filling time": "time_to(p, 90 %)"}
    short = swept(scalars=times, stop_time=5.0)
    assert np.isnan(short.column("filling time")).all()
    assert short.summary_lines() == [
        "filling time: 8 runs have not settled, so that the whole change is not known; make them longer"
    ]
    full = pam.sweep(
        MODEL, {"u_in": [0.2, 0.35]}, scalars=times, stop_time="60 s", interval="0.1 s", workers=1
    )
    slow, fast = full.column("filling time")
    assert np.isnan(slow) and fast == pytest.approx(21.03, abs=0.01)
    assert "filling time: 1 run has not settled" in str(full)


@pytest.mark.parametrize("workers", [2, None])
def test_processes_make_the_same_numbers(reference: pam.Sweep, workers: int | None) -> None:
    assert same(reference, swept(scalars=SCALARS, trajectories=True, workers=workers))


def test_a_dask_cluster_makes_the_same_numbers(reference: pam.Sweep, cluster: str) -> None:
    assert same(reference, swept(scalars=SCALARS, trajectories=True, executor=cluster))


def test_a_dask_cluster_makes_the_same_diagnosis(cluster: str) -> None:
    """A muscle without its bladder's stiffness in the model, of which three candidates are fitted."""
    data = pam.read(ROOT / "examples" / "hidden-spring")
    families = {effect.family for effect in pam.effects()} - {"elasticity", "dry_friction", "leak"}
    here, there = (
        pam.diagnose(data, exclude=sorted(families), explain=False, **where).as_dict()
        for where in ({"workers": 2}, {"executor": cluster})
    )
    assert json.dumps(here) == json.dumps(there)
    assert here["verdict"]["families"] == ["elasticity"]


def test_labelled_by_what_was_varied(reference: pam.Sweep) -> None:
    data = reference.to_xarray()
    assert dict(data.sizes) == {"u_in": 4, "p_supply": 2, "time": len(reference.time)}
    assert data["p"].attrs["units"] == "Pa" and data["u_in"].attrs["units"] == "A"
    one = data.sel(p_supply=207e3).isel(u_in=2)
    assert np.array_equal(one["p"], reference[5].trajectory["p"])  # type: ignore[index]
    assert float(one["last pressure"]) == reference[5].scalars["last pressure"]


def test_what_is_written_reads_back(reference: pam.Sweep, tmp_path: Path) -> None:
    with xarray.open_dataset(reference.save(tmp_path / "s.nc")) as read:
        xarray.testing.assert_equal(
            read.drop_vars("failure").load(), reference.to_xarray().drop_vars("failure")
        )
        assert read["p"].attrs["units"] == "Pa" and json.loads(read.attrs["settings"]) == {}
    csv = pandas.read_csv(reference.save(tmp_path / "s.csv"))
    parquet = pandas.read_parquet(reference.save(tmp_path / "s.parquet"))
    assert list(csv) == list(parquet)
    assert list(csv) == [
        "u_in [A]",
        "p_supply [Pa]",
        "last pressure [Pa]",
        "peak temperature [K]",
        "failure",
    ]
    for table in (csv, parquet):
        assert np.array_equal(table["last pressure [Pa]"], reference.column("last pressure"))
    assert [p.name for p in sorted(tmp_path.iterdir())] == ["s.csv", "s.nc", "s.parquet"]


@pytest.mark.full
def test_a_run_that_fails_is_a_row_with_its_reason(tmp_path: Path) -> None:
    path = models.fmu(models.breaks_down)
    vary = {"floor": [-1e6, -2e6, 0.6]}
    made = pam.sweep(
        str(path), vary, scalars=["max(y)"], trajectories=True, output=tmp_path / "s.nc"
    )
    assert list(made.failed) == [2] and "floor = 0.6" in made.failed[2]
    assert (
        made[2].trajectory is None
        and np.isnan(made[2].scalars["max(y)"])
        and made[1].failure is None
    )
    with xarray.open_dataset(tmp_path / "s.nc") as read:
        assert [bool(text) for text in read["failure"].values] == [False, False, True]
        assert (
            np.isnan(read["y"].sel(floor=0.6)).all()
            and np.isfinite(read["y"].sel(floor=-1e6)).all()
        )


class _Stop(Exception):
    """In the middle."""


class _Gated(ThreadPoolExecutor):
    """A thread that makes the first batch, and the others once the gate is open: it does not run ahead of a stop."""

    def __init__(self) -> None:
        super().__init__(1)
        self.gate, self._begun = Event(), False

    def submit(self, work: Callable[..., Any], /, *args: Any, **words: Any) -> Future[Any]:
        waits, self._begun = self._begun, True

        def made() -> Any:
            if waits:
                self.gate.wait(10.0)
            return work(*args, **words)

        return super().submit(made)


def test_what_was_made_before_a_stop_is_not_made_again(
    reference: pam.Sweep, tmp_path: Path
) -> None:
    def stop(done: int, total: int) -> None:
        if done:
            raise _Stop

    words = {"scalars": SCALARS, "trajectories": True, "output": tmp_path / "s.nc"}
    pool = _Gated()
    with pytest.raises(_Stop):
        swept(**words, executor=pool, progress=stop)
    pool.gate.set()
    pool.shutdown()
    kept = partial_of(tmp_path / "s.nc")
    assert kept.exists() and not (tmp_path / "s.nc").exists()
    told: list[int] = []
    assert same(reference, swept(**words, progress=lambda done, total: told.append(done)))
    assert 0 < told[0] < 8 and told[-1] == 8
    assert not kept.exists() and (tmp_path / "s.nc").exists()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"stop_time": 3.0}, "times differ"),
        ({"parameters": {"tank.V": "1 l"}}, "settings differ"),
        ({"scalars": ["max(p)"]}, "scalars differ"),
    ],
)
def test_runs_of_another_sweep_are_not_gone_on_with(
    change: dict[str, Any], words: str, tmp_path: Path
) -> None:
    def stop(done: int, total: int) -> None:
        if done:
            raise _Stop

    base: dict[str, Any] = {"scalars": ["final(p)"], "output": tmp_path / "s.csv"}
    with pytest.raises(_Stop):
        swept(**base, executor=ThreadPoolExecutor(1), progress=stop)
    before = partial_of(tmp_path / "s.csv").read_bytes()
    with pytest.raises(pam.InputError, match=words):
        swept(**(base | change))
    assert partial_of(tmp_path / "s.csv").read_bytes() == before


@pytest.mark.parametrize("workers", [1, pytest.param(2, marks=pytest.mark.full)])
def test_runs_are_kept_as_they_are_made(workers: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Not all of them at the end, however fast the machine is: what is told is what is kept."""
    for limit in ("_BATCH", "_OPENINGS", "_WORTH"):  # each run is a batch, and worth a process
        monkeypatch.setattr(executors, limit, 0)
    told: list[int] = []
    vary = {"u_in": np.linspace(0.25, 0.35, 60)}
    pam.sweep(
        MODEL,
        vary,
        scalars=["max(p)"],
        workers=workers,
        progress=lambda done, total: told.append(done),
    )
    assert len(told) > 3 and told == sorted(told) and told[-1] == 60
