"""The sources of an FMU in somebody else's program: FMI 2.0.4, sections 2.1.2 and 2.3, and FMI 3.0.1, section 2.2.2."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from pam_cosim.cache import cache_dir
from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu.platforms import native_platform
from tests.fmu import models

VERSIONS = ["2.0", pytest.param("3.0", marks=pytest.mark.full)]
_NM = shutil.which("nm")


def _objects(make: Callable[[], Ode], fmi: str, folder: Path, *options: str) -> list[Path]:
    """Every source compiled by itself, without a warning."""
    folder.mkdir()
    with zipfile.ZipFile(models.fmu(make, fmi)) as archive:
        archive.extractall(folder)
    sources = folder / "sources"
    gcc = shutil.which("gcc")
    compiler = [gcc] if gcc else [sys.executable, "-m", "ziglang", "cc"]
    zig = str(cache_dir() / "zig")
    environment = os.environ | {"ZIG_GLOBAL_CACHE_DIR": zig, "ZIG_LOCAL_CACHE_DIR": zig}
    command = [
        *compiler,
        "-std=c99",
        "-O1",
        "-Wall",
        "-Werror",
        *options,
        "-c",
        *sorted(sources.glob("*.c")),
    ]
    subprocess.run(command, cwd=sources, check=True, env=environment)
    return sorted(sources.glob("*.o"))


def _defined(objects: list[Path]) -> list[str]:
    assert _NM is not None
    told = subprocess.run(
        [_NM, "-g", "--defined-only", *objects], capture_output=True, text=True, check=True
    )
    return [line.split()[-1] for line in told.stdout.splitlines() if len(line.split()) == 3]


@pytest.mark.skipif(_NM is None, reason="nm lists the symbols")
@pytest.mark.parametrize("fmi", VERSIONS)
def test_two_in_one_program_share_no_symbol(fmi: str, tmp_path: Path) -> None:
    lag = _defined(_objects(models.lag, fmi, tmp_path / "lag"))
    other = f"-DFMI{fmi[0]}_FUNCTION_PREFIX=Another_"
    mix = _defined(_objects(models.delayed_mix, fmi, tmp_path / "mix", other))
    assert len(lag) > 50 and len(mix) > 50
    assert all(name.startswith("Test_Lag_") for name in lag)
    assert all(name.startswith("Another_") for name in mix)
    assert f"Test_Lag_fmi{fmi[0]}DoStep" in lag


@pytest.mark.parametrize("fmi", VERSIONS)
def test_headers_are_those_of_the_release(fmi: str) -> None:
    with zipfile.ZipFile(models.fmu(models.lag, fmi)) as archive:
        text = archive.read(f"sources/fmi{fmi[0]}Functions.h").decode()
    assert f"FMI{fmi[0]}_FUNCTION_PREFIX" in re.sub(r"(?s)/\*.*?\*/", "", text)
    assert "has been changed" not in text


@pytest.mark.skipif(not native_platform().endswith("linux"), reason="ELF alone has that name")
def test_a_binary_carries_the_name_of_its_model() -> None:
    with zipfile.ZipFile(models.fmu(models.lag)) as archive:
        binary = next(archive.read(n) for n in archive.namelist() if n.endswith(".so"))
    assert b"\0Test_Lag.so\0" in binary and b"liblibrary" not in binary
