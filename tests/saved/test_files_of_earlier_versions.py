"""Files of every version that was ever released are read, and say what they said then."""

from __future__ import annotations

import json
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.files import json_text
from pam_cosim.fitting import read_parameters
from pam_cosim.study.tables import read_comparison
from tests.saved.write import HERE, main

VERSIONS = sorted(folder for folder in HERE.iterdir() if (folder / "fitted.json").exists())
PRODUCTS = [file for folder in VERSIONS for file in sorted(folder.glob("*.npz"))]


def test_this_version_has_its_files_and_they_stay(capsys: pytest.CaptureFixture[str]) -> None:
    assert version("pam-cosim") in [folder.name for folder in VERSIONS], (
        "run python -m tests.saved.write"
    )
    assert main() == 2 and "stays as it is" in capsys.readouterr().err


@pytest.mark.parametrize("file", PRODUCTS, ids=lambda file: f"{file.parent.name}-{file.stem}")
def test_products(file: Path) -> None:
    product, stated = pam.load(file), file.with_suffix(".json")
    assert len(str(product)) > 40
    if stated.exists():
        check_kept(json.loads(stated.read_text()), json.loads(json_text(product.as_dict())))


def check_kept(old: Any, new: Any) -> None:
    """All that was stated is stated still; there may be more."""
    if isinstance(old, dict):
        for key in old:
            check_kept(old[key], new[key])
    elif isinstance(old, list):
        assert len(old) == len(new)
        for one, other in zip(old, new, strict=True):
            check_kept(one, other)
    else:
        assert new == (pytest.approx(old, rel=1e-9) if isinstance(old, float) else old)


@pytest.mark.parametrize("folder", VERSIONS, ids=lambda folder: folder.name)
def test_parameters_data_sets_and_results(folder: Path) -> None:
    fitted = read_parameters(folder / "fitted.json")
    assert fitted == pytest.approx(read_parameters(folder / "fitted.ssv"), rel=1e-15)
    assert set(fitted) == {"orifice.C_d", "tank.n"}
    data = pam.read(folder / "data-set")
    assert [run.role for run in data.runs] == ["fit"] and set(data.fit) == set(fitted)
    assert read_comparison(folder / "compared.json")


def test_a_file_of_a_later_version_is_said_to_be_one(tmp_path: Path) -> None:
    with np.load(PRODUCTS[0]) as old:
        arrays = dict(old)
    document = json.loads(bytes(arrays.pop("product")))
    text = json.dumps(document | {"version": 99}).encode()
    np.savez(tmp_path / "new.npz", product=np.frombuffer(text, dtype=np.uint8), **arrays)
    with pytest.raises(pam.InputError, match="saved by a later pam-cosim .form 99"):
        pam.load(tmp_path / "new.npz")


def test_a_file_without_a_version_is_of_the_first(tmp_path: Path) -> None:
    with np.load(PRODUCTS[0]) as old:
        arrays = dict(old)
    document = json.loads(bytes(arrays.pop("product")))
    del document["version"]
    text = json.dumps(document).encode()
    np.savez(tmp_path / "old.npz", product=np.frombuffer(text, dtype=np.uint8), **arrays)
    assert str(pam.load(tmp_path / "old.npz")) == str(pam.load(PRODUCTS[0]))
