"""MATLAB, HDF5, TDMS and Parquet hold the same table; what is none of them is one clear error."""

from __future__ import annotations

import sys
from pathlib import Path

import h5py
import numpy as np
import pandas
import pyarrow
import pytest
import scipy.io
from nptdms import ChannelObject, TdmsWriter
from pyarrow import parquet

from pam_cosim.errors import InputError
from pam_cosim.measurement import read_data_set
from pam_cosim.measurement.formats import read_table
from pam_cosim.measurement.table import Layout
from tests.measurement.bench import MODEL, describe

TIME, P, X = np.array([0.0, 0.1, 0.2]), np.array([1.5, np.nan, -32.5]), np.array([1.0, 2.0, 4.0])
NAMES = ("time [s]", "p [kPa]", "x [mm]")
MATRIX = np.column_stack([TIME, P, X])


def matlab(file: Path) -> Layout:
    scipy.io.savemat(
        file, {"time": TIME, "p": P[:, None], "x": X[None, :], "rate": 10.0, "who": "me"}
    )
    return Layout()


def matlab_structure(file: Path) -> Layout:
    scipy.io.savemat(file, {"run": {"time": TIME, "p": P, "x": X}, "rate": 10.0})
    return Layout()


def matlab_matrix(file: Path) -> Layout:
    scipy.io.savemat(file, {"data": MATRIX, "other": MATRIX})
    return Layout(table="data", names=NAMES)


def matlab_73(file: Path) -> Layout:
    with h5py.File(file, "w", userblock_size=512) as out:
        for name, values in zip(("time", "p", "x"), (TIME, P, X), strict=True):
            out[name] = values[None, :]
    return Layout()


def hdf5(file: Path) -> Layout:
    with h5py.File(file, "w") as out:
        for name, values, unit in zip(
            ("time", "p", "x"), (TIME, P, X), ("s", b"kPa", "mm"), strict=True
        ):
            out[f"rig/run 1/{name}"] = values
            out[f"rig/run 1/{name}"].attrs["unit"] = unit
        out["rig/about"] = "text"
    return Layout()


def hdf5_fields(file: Path) -> Layout:
    with h5py.File(file, "w") as out:
        kinds = [(name, float) for name in ("time", "p", "x")]
        out["table"] = np.array([tuple(row) for row in MATRIX], dtype=kinds)
    return Layout()


def hdf5_matrix(file: Path) -> Layout:
    with h5py.File(file, "w") as out:
        out["a"], out["b"] = MATRIX, MATRIX
    return Layout(table="b", names=NAMES)


def tdms(file: Path) -> Layout:
    with TdmsWriter(file) as out:
        for name, values, unit in zip(("p", "x"), (P, X), ("kPa", "mm"), strict=True):
            waveform = {"unit_string": unit, "wf_increment": 0.1}
            out.write_segment([ChannelObject("run", name, values, properties=waveform)])
    return Layout()


def tdms_groups(file: Path) -> Layout:
    with TdmsWriter(file) as out:
        for group in ("one", "two"):
            for name, values in zip(NAMES, (TIME, P, X), strict=True):
                out.write_segment([ChannelObject(group, name, values)])
    return Layout(table="two")


def parquet_headings(file: Path) -> Layout:
    pandas.DataFrame(dict(zip(NAMES, (TIME, P, X), strict=True))).to_parquet(file)
    return Layout()


def parquet_times(file: Path) -> Layout:
    stamps = pyarrow.array(np.datetime64("2024-02-01T10:00") + (TIME * 1000).astype("m8[ms]"))
    fields = [
        pyarrow.field("time", stamps.type),
        pyarrow.field("p", pyarrow.float32(), metadata={"unit": "kPa"}),
    ]
    columns = [
        stamps,
        pyarrow.array([1.5, None, -32.5], pyarrow.float32()),
        pyarrow.array([1, 2, 4]),
    ]
    schema = pyarrow.schema([*fields, pyarrow.field("x [mm]", pyarrow.int64())])
    parquet.write_table(pyarrow.table(columns, schema=schema), file)
    return Layout()


def workbook(file: Path) -> Layout:
    """Above the table a title; beside its sheet another one."""
    with pandas.ExcelWriter(file) as out:
        for sheet, rows in (("rig", MATRIX), ("notes", MATRIX[:2])):
            pandas.DataFrame(rows, columns=NAMES).to_excel(
                out, sheet_name=sheet, index=False, startrow=2
            )
        out.sheets["rig"]["A1"] = "Filling of a muscle, 7 bar"
    return Layout(table="rig", separator=";", decimal=",")


def workbook_times(file: Path) -> Layout:
    dates = pandas.to_datetime(TIME, unit="s", origin="2024-03-12 14:05:00")
    columns = {"time": dates, "p [kPa]": P, "x [mm]": X}
    with pandas.ExcelWriter(file, datetime_format="yyyy-mm-dd hh:mm:ss.000") as out:
        pandas.DataFrame().to_excel(out, sheet_name="empty")
        pandas.DataFrame(columns).to_excel(out, sheet_name="rig", index=False)
    return Layout()


FILES = [
    ("run.xlsx", workbook), ("run.XLSX", workbook_times),
    ("run.mat", matlab), ("run.mat", matlab_structure), ("run.mat", matlab_matrix), ("run.mat", matlab_73),
    ("run.h5", hdf5), ("run.hdf5", hdf5_fields), ("run.h5", hdf5_matrix), ("run.tdms", tdms),
    ("run.TDMS", tdms_groups), ("run.parquet", parquet_headings), ("run.parquet", parquet_times),
]  # fmt: skip


@pytest.mark.parametrize(("name", "write"), FILES, ids=[write.__name__ for _, write in FILES])
def test_the_same_table(tmp_path, name, write):
    stated = write(tmp_path / name)
    columns = read_table(tmp_path / name, stated).columns
    assert sorted(columns) == ["p", "time", "x"]
    for one, values in (("time", TIME), ("p", P), ("x", X)):
        np.testing.assert_allclose(columns[one].values, values, atol=1e-12)


@pytest.mark.parametrize(
    "write", [hdf5, tdms, tdms_groups, parquet_times, hdf5_matrix, matlab_matrix]
)
def test_units_come_along(tmp_path, write):
    name = next(name for name, one in FILES if one is write)
    columns = read_table(tmp_path / name, write(tmp_path / name)).columns
    assert [columns[one].unit for one in ("time", "p", "x")] == ["s", "kPa", "mm"]


def test_a_run_of_a_data_set(tmp_path):
    matlab(tmp_path / "run.mat")
    (tmp_path / "experiment.toml").write_text(
        f'model = "{MODEL}"\n[columns]\ntime = {{ unit = "ms" }}\np = {{ unit = "kPa" }}\nx = {{ unit = "mm" }}\n'
        '[[runs]]\nfile = "run.mat"\n'
    )
    run = read_data_set(tmp_path, describe).runs[0]
    np.testing.assert_allclose(run.time, TIME / 1000)
    np.testing.assert_allclose(run.measurements["x"], X / 1000)


def refusal(file: Path, stated: Layout | None = None) -> InputError:
    with pytest.raises(InputError) as caught:
        read_table(file, stated)
    assert caught.value.file == file
    return caught.value


@pytest.mark.parametrize(
    "content", [b"", b"time,p\n0,1\n", b"\x89HDF\r\n\x1a\n" + bytes(40), b"TDSm" + b"\xff" * 60]
)
@pytest.mark.parametrize("name", ["run.mat", "run.h5", "run.tdms", "run.parquet", "run.xlsx"])
def test_what_is_no_such_file(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    assert (
        "cannot be read as" in refusal(tmp_path / name).message
        or "state one of" in refusal(tmp_path / name).message
    )


@pytest.mark.parametrize(
    ("name", "library", "extra"),
    [
        ("run.tdms", "nptdms", "lab"),
        ("run.xlsx", "python_calamine", "lab"),
        ("run.h5", "h5py", "tables"),
        ("run.parquet", "pyarrow", "tables"),
    ],
)
def test_a_missing_library_names_the_extra(tmp_path, monkeypatch, name, library, extra):
    (tmp_path / name).touch()
    monkeypatch.setitem(sys.modules, library, None)
    message = f"{library} is needed and is not installed: pip install 'pam-cosim[{extra}]'"
    assert refusal(tmp_path / name).message == message


def test_a_sheet_is_named_or_numbered(tmp_path):
    file = tmp_path / "run.xlsx"
    workbook(file)
    message = 'state one of rig, notes under [recording], as table = "rig"'
    assert refusal(file).message == f"the workbook has several sheets; {message}"
    assert refusal(file, Layout(table="3")).message == f"there is no sheet '3'; {message}"
    assert len(read_table(file, Layout(table="2")).columns["time"].values) == 2
    table = read_table(file, Layout(table="rig"))
    assert table.header_line == 3 and table.lines.tolist() == [4, 5, 6]


@pytest.mark.parametrize(
    "name", ["run.csv", "run.xlsx", "run.h5", "run.mat", "run.parquet", "run.tdms"]
)
def test_a_pointer_of_git_is_named(tmp_path, name):
    text = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a2146\nsize 12345\n"
    (tmp_path / name).write_text(text)
    assert refusal(tmp_path / name).message.endswith(
        "pointer of Git LFS, and not the recording: git lfs pull"
    )


def test_what_must_be_stated_is_named(tmp_path):
    file = tmp_path / "run.tdms"
    tdms_groups(file)
    assert "one, two" in refusal(file).message
    assert "no group 'three'" in refusal(file, Layout(table="three")).message
    file = tmp_path / "run.mat"
    matlab_matrix(file)
    assert "table = " in refusal(file).message
    assert set(read_table(file, Layout(table="data")).columns) >= {"signal 1", "signal 2"}
    assert "2 headings" in refusal(file, Layout(table="data", names=("a", "b"))).message
    assert "did you mean 'data'" in refusal(file, Layout(table="date")).message
    file = tmp_path / "run.h5"
    hdf5(file)
    assert "did you mean 'rig/run 1'" in refusal(file, Layout(table="rig/run 2")).message
    hdf5_matrix(file)
    assert "there is none" in refusal(file).message
    with h5py.File(file, "w") as out:
        out["time"], out["p"] = TIME, P[:2]
    error = refusal(file)
    assert error.column in ("p", "time") and "ignore = [...]" in error.message
    assert list(read_table(file, Layout(ignore=("p",))).columns) == ["time"]
    file = tmp_path / "run.parquet"
    pandas.DataFrame({"time [s]": TIME, "remark": ["a", "b", "c"]}).to_parquet(file)
    assert refusal(file).column == "remark"
    assert list(read_table(file, Layout(ignore=("rem*",))).columns) == ["time"]


def structures(kind: str) -> dict[str, object]:
    """The same recording as programs nest it."""
    p, x = ({"values": v, "label": n, "rank": 1} for v, n in ((P, "p [kPa]"), (X, "x [mm]")))
    row = np.array([tuple(p.values()), tuple(x.values())], dtype=[(name, object) for name in p])
    return {
        "within": {"log": {"time": TIME, "signals": {"p": P, "x": X}, "rate": 10.0}},
        "beside": {"time": TIME, "log": {"signals": {"p": P, "x": X}}},
        "a row": {"ScopeData": {"time": TIME, "signals": row}},
        "cells": {"ScopeData": {"time": TIME, "signals": np.array([p, x])}},
        "alike": {"log": {"time": TIME, "p": {"values": P}, "x": {"values": X}}},
    }[kind]  # type: ignore[return-value]


@pytest.mark.parametrize(
    ("kind", "names"),
    [
        ("within", ["time", "p", "x"]),
        ("beside", ["time", "p", "x"]),
        ("a row", ["time", "p", "x"]),
        ("cells", ["time", "p", "x"]),
        ("alike", ["time", "p.values", "x.values"]),
    ],
)
def test_structures_within_structures(tmp_path: Path, kind: str, names: list[str]) -> None:
    file = tmp_path / "a.mat"
    scipy.io.savemat(file, structures(kind))
    columns = read_table(file).columns
    assert list(columns) == names
    for column, values in zip(columns.values(), (TIME, P, X), strict=True):
        np.testing.assert_array_equal(column.values, values)


def test_arrays_of_numpy_are_columns_and_objects_are_left_out(tmp_path):
    file = tmp_path / "run.npz"
    np.savez(file, t=TIME, p=P, note=np.array("a"), size=3.0, more=np.array([{}], dtype=object))
    np.testing.assert_array_equal(read_table(file, Layout()).columns["p"].values, P)
    np.savez(file, note=np.array("a"))
    assert "no array of numbers" in refusal(file).message
    file.write_bytes(b"PK no archive")
    assert "cannot be read as NumPy's" in refusal(file).message


def test_a_signal_of_dspace_has_its_unit_beside_its_name(tmp_path):
    file = tmp_path / "run.mat"
    signal = {"Name": "Model Root/p", "Data": P, "Unit": "bar"}
    axis = {"Name": "Time", "Data": TIME, "Unit": "unknown"}
    scipy.io.savemat(file, {"rec": {"X": axis, "Y": signal}})
    assert {n: c.unit for n, c in read_table(file).columns.items()} == {
        "Time": "",
        "Model Root/p": "bar",
    }
