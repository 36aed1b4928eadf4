"""The FMUs' binaries for other systems: run under wine and qemu, and read where they cannot be run."""

from __future__ import annotations

import struct
import warnings
from pathlib import Path

import numpy as np
import pytest
from fmpy import read_model_description

from pam_cosim.fmu import build_fmu
from scripts.systems import run
from scripts.systems.mach_o import read_mach_o
from tests.documentation.pages import ROOT
from tests.fmu import models

SAME = 1e-12  # of the range, where both systems compute functions alike


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("systems")


def tolerance(fmu: Path) -> float:
    return float(read_model_description(str(fmu)).defaultExperiment.tolerance)


@pytest.mark.full
@pytest.mark.parametrize("system", run.OTHERS, ids=lambda system: system.platform)
def test_results_are_those_of_linux(system: run.System, folder: Path) -> None:
    if system.missing:
        warnings.warn(f"{system.name} was not run: {system.missing}", stacklevel=1)
        pytest.skip(system.missing)
    page = (ROOT / "docs" / "own-fmu.md").read_text(encoding="utf-8")
    for bench in run.pam.benches():
        fmu = run.built(bench, folder)
        here = run.simulate(fmu, run.LINUX, folder)
        assert np.ptp(here, axis=0).max() > 0.0, bench
        far = run.difference(here, run.simulate(fmu, system, folder))
        # The functions of Windows' C library differ in their last bit: no solver is closer than its tolerance to that.
        assert far <= (tolerance(fmu) if system is run.WINDOWS else SAME), bench
        assert f"| {bench} | {here.shape[1]} |" in page


def test_difference_is_seen() -> None:
    course = np.linspace(0.0, 2.0, 2 * (run.STEPS + 1)).reshape(-1, 2)
    other = course.copy()
    other[7, 1] += 1e-9
    assert run.difference(course, course) == 0.0
    assert run.difference(course, other) == pytest.approx(5e-10, rel=0.01)


def test_binary_of_macos_asks_for_nothing_that_is_not_there(tmp_path: Path) -> None:
    fmu = build_fmu(models.lag(), tmp_path / "lag.fmu", platforms=["x86_64-macos", "aarch64-macos"])
    assert run.mac_faults(fmu) == []


def test_other_files_are_no_libraries_of_macos() -> None:
    with pytest.raises(ValueError, match="no 64-bit Mach-O"):
        read_mach_o(struct.pack("<8I", 0x464C457F, *range(7)))
