"""What is likely to be given to a function instead of what it takes: one error that says what to write."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import pam_cosim as pam
from tests.fitting.models import vessel_data


@pytest.mark.parametrize("call", [pam.compare, pam.fit, pam.diagnose, pam.check])
@pytest.mark.parametrize("given", ["my-rig", Path("my-rig"), None], ids=str)
def test_a_folder_in_the_place_of_a_data_set(call: Callable[[Any], object], given: object) -> None:
    with pytest.raises(pam.InputError, match=r"a data set is needed, not .*pam.read\(FOLDER\)"):
        call(given)


@pytest.mark.parametrize("call", [pam.plan, pam.predict])
@pytest.mark.parametrize(
    "given", ["d.npz", Path("my-rig"), vessel_data()], ids=lambda g: str(g)[:9]
)
def test_a_file_in_the_place_of_a_product(call: Callable[[Any], object], given: object) -> None:
    with pytest.raises(
        pam.InputError, match=r"a .*diagnosis is needed, not .*pam.load\(FILE.npz\)"
    ):
        call(given)


def test_models_are_named_by_texts_or_paths(tmp_path: Path) -> None:
    by_path = pam.simulate(Path("TankFilling"), stop_time=1)  # type: ignore[arg-type]
    assert by_path["p"].tolist() == pam.simulate("TankFilling", stop_time=1)["p"].tolist()
    file = pam.build("TankFilling", tmp_path / "x.fmu")
    assert pam.describe(file).inputs  # type: ignore[arg-type]
    with pytest.raises(pam.InputError, match="named by a text or a path, not by a int"):
        pam.simulate(3)  # type: ignore[arg-type]
