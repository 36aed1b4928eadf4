"""Every product of a study is saved and loaded with every number as it was, draws itself, and holds nothing to run."""

from __future__ import annotations

import json
import pickle
import sys
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.exports import Tabular
from pam_cosim.fitting import HoldoutUncertainty
from pam_cosim.simulation import Trajectory
from pam_cosim.study.products import _KINDS
from pam_cosim.sweeps import Sweep
from pam_cosim.wording import Printed
from tests.fitting.models import vessel_data
from tests.pictures import drawn
from tests.reporting.synthetic import make_comparison, make_data, make_diagnosis, make_fit
from tests.reporting.test_ledger_learned_next import make_learned, make_ledger
from tests.tiers import quick

DATA = make_data()
PRODUCTS = {
    "comparison": make_comparison(DATA, 2.0),
    "fit": make_fit(DATA, 2.0),
    "fit with holdout uncertainty": replace(
        make_fit(DATA, 2.0),
        holdout_uncertainty=HoldoutUncertainty({("run", "x"): np.array([0.1, 0.0])}, 0.3),
    ),
    "ledger": make_ledger(),
    "ambiguous": make_diagnosis("ambiguous", DATA),
    "unknown": make_diagnosis("unknown", DATA, learned=make_learned(DATA), ledger=make_ledger()),
}


def same(a: Any, b: Any) -> None:
    """Equal in every field, arrays to the bit, not-a-number equal to itself."""
    assert type(a) is type(b), (type(a), type(b))
    if isinstance(a, np.ndarray):
        assert a.dtype == b.dtype
        np.testing.assert_array_equal(a, b)
    elif is_dataclass(a):
        for f in fields(a):
            same(getattr(a, f.name), getattr(b, f.name))
    elif isinstance(a, dict):
        assert list(a) == list(b)
        for key in a:
            same(a[key], b[key])
    elif isinstance(a, (list, tuple)):
        assert len(a) == len(b)
        for one, other in zip(a, b, strict=True):
            same(one, other)
    else:
        assert a == b or (a != a and b != b)


@pytest.mark.parametrize("name", PRODUCTS)
def test_what_is_loaded_is_what_was_saved(name: str, tmp_path: Path) -> None:
    product = PRODUCTS[name]
    same(pam.load(pam.save(product, tmp_path / "product.npz")), product)


def test_real_products(tmp_path: Path) -> None:
    """A trajectory, and a fit with the record of its swarm: fitted, saved, loaded, printed, drawn."""
    run = pam.simulate("VesselOrifice", stop_time=1.0)
    same(pam.load(pam.save(run, tmp_path / "run.npz")), run)
    fit = pam.fit(vessel_data(), method="particle-swarm")
    again = pam.load(pam.save(fit, tmp_path / "fit.npz"))
    same(again, fit)
    assert (
        str(again) == str(fit)
        and "swarm of 50 particles" in str(again)
        and again.as_dict() == fit.as_dict()
    )
    for product in (run, again):
        pam.draw(product, tmp_path / "picture.png")
        assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("name", quick(PRODUCTS, "comparison", "fit", "unknown"))
def test_every_product_draws_and_prints_itself(name: str, tmp_path: Path) -> None:
    pam.draw(PRODUCTS[name], tmp_path / "picture.png")
    assert drawn(tmp_path / "picture.png")
    assert len(str(PRODUCTS[name])) > 40


def test_every_kind_of_product_prints_itself() -> None:
    public = [getattr(pam, name) for name in pam.__all__]
    kinds = [one for one in public if isinstance(one, type) and not issubclass(one, Exception)]
    assert len(kinds) > 12
    for kind in (*kinds, *_KINDS.values()):
        assert issubclass(kind, Printed) and kind.__str__ is not Printed.__str__, kind
        assert kind.__repr__ is Printed.__repr__, kind


def test_every_product_with_rows_becomes_a_frame() -> None:
    assert not {
        kind.__name__
        for kind in (*_KINDS.values(), pam.CoupledRun, Sweep)
        if not issubclass(kind, (Tabular, Sweep))
    } - {"Ledger", "LinearModels"}  # whose rows are those of their parts
    comparison, fit, diagnosis = PRODUCTS["comparison"], PRODUCTS["fit"], PRODUCTS["ambiguous"]
    samples = comparison.to_frame()
    run = comparison.runs[0]
    of_x = samples[(samples.index == run.run.name) & (samples["signal"] == "x")]
    there = np.isfinite(run.run.measurements["x"])
    np.testing.assert_array_equal(of_x["residual"], run.residual("x")[there])
    np.testing.assert_array_equal(of_x["time"], run.run.time[there])
    assert set(of_x["unit"]) == {"m"} and samples.attrs["units"] == {"time": "s"}
    assert fit.to_frame().loc["valve.C_A", "value"] == fit.parameters["valve.C_A"].value
    assert list(diagnosis.to_frame().index) == [" + ".join(c.effects) for c in diagnosis.candidates]
    data = diagnosis.to_xarray()
    np.testing.assert_array_equal(data["delta_bic"], [c.delta_bic for c in diagnosis.candidates])
    assert data["delta_bic"].attrs == {"units": "1"} and data["family"].attrs == {}


@pytest.mark.parametrize(
    ("use", "library", "extra"),
    [
        (lambda run, place: run.to_frame(), "pandas", "tables"),
        (lambda run, place: run.to_xarray(), "xarray", "tables"),
        (lambda run, place: run.save(place / "run.nc"), "h5netcdf", "tables"),
        (lambda run, place: run.save(place / "run.parquet"), "pyarrow", "tables"),
        (lambda run, place: Sweep.__new__(Sweep).to_frame(), "pandas", "tables"),
        (lambda run, place: Sweep.__new__(Sweep).to_xarray(), "xarray", "tables"),
        (lambda run, place: Sweep.__new__(Sweep).save(place / "sweep.nc"), "h5netcdf", "tables"),
        (lambda run, place: pam.sweep("VesselOrifice", {"tank.V": [0.01]}, stop_time=0.1, executor="tcp://here:1"),
         "distributed", "dask"),
        (lambda run, place: pam.linearise("VesselOrifice", at=0.5).to_control(), "control", "control"),
    ],
)  # fmt: skip
def test_a_missing_library_is_named_with_what_to_type(
    use: Any, library: str, extra: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    run = Trajectory(np.arange(3.0), {"x": np.ones(3)}, {"x": "m"})
    monkeypatch.setitem(sys.modules, library, None)
    message = f"{library} is needed and is not installed: pip install 'pam-cosim.{extra}.'"
    with pytest.raises(pam.InputError, match=message):
        use(run, tmp_path)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "damage", ["text", "empty", "cut", "pickle", "other npz", "unknown kind", "missing"]
)
def test_a_file_that_is_none_is_refused(damage: str, tmp_path: Path) -> None:
    file = tmp_path / "product.npz"
    pam.save(PRODUCTS["fit"], file)
    whole = file.read_bytes()
    if damage == "text":
        file.write_text("hello")
    elif damage == "empty":
        file.write_bytes(b"")
    elif damage == "cut":
        file.write_bytes(whole[: len(whole) // 2])
    elif damage == "pickle":
        file.write_bytes(pickle.dumps({"a": 1}))
    elif damage == "other npz":
        np.savez(file, a=np.zeros(3))
    elif damage == "unknown kind":
        np.savez(
            file,
            product=np.frombuffer(b'{"kind": "Path", "content": "/etc/passwd"}', dtype=np.uint8),
        )
    else:
        file.unlink()
    with pytest.raises(pam.InputError, match="product.npz"):
        pam.load(file)


def test_a_file_of_a_later_version_is_said_to_be_one(tmp_path: Path) -> None:
    with np.load(pam.save(PRODUCTS["fit"], tmp_path / "fit.npz")) as saved:
        arrays = dict(saved)
    document = json.loads(bytes(arrays.pop("product")))
    text = json.dumps(document | {"version": 99}).encode()
    np.savez(tmp_path / "later.npz", product=np.frombuffer(text, dtype=np.uint8), **arrays)
    with pytest.raises(pam.InputError, match="saved by a later pam-cosim .form 99"):
        pam.load(tmp_path / "later.npz")


def test_a_name_that_says_another_format_is_refused(tmp_path: Path) -> None:
    run = pam.Trajectory(np.linspace(0.0, 1.0, 3), {"p": np.zeros(3)}, {"p": "Pa"})
    with pytest.raises(pam.InputError, match=r"x\.json: a Fit is saved as \.npz"):
        pam.save(PRODUCTS["fit"], tmp_path / "x.json")
    with pytest.raises(pam.InputError, match=r"x\.json: the result is written as CSV, NetCDF"):
        run.save(tmp_path / "x.json")
    assert not list(tmp_path.iterdir())
    assert run.save(tmp_path / "x").read_bytes() == run.save(tmp_path / "x.CSV").read_bytes()


def test_what_is_no_product_is_not_saved(tmp_path: Path) -> None:
    with pytest.raises(pam.InputError, match="a dict cannot be saved"):
        pam.save({}, tmp_path / "x.npz")  # type: ignore[arg-type]
    with pytest.raises(pam.InputError, match="a dict cannot be drawn"):
        pam.draw({}, tmp_path / "x.png")
    assert not list(tmp_path.iterdir())
