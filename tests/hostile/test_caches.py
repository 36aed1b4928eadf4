"""A cache that is damaged, foreign, half cleaned, full or read-only: it is mended, or one message says why not."""

from __future__ import annotations

import os
import shutil
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.cache import cache_dir, is_whole
from pam_cosim.compiler import Ode
from pam_cosim.errors import InputError
from pam_cosim.fmu import cached_fmu
from pam_cosim.fmu.build import cached_lean_model, cached_taped_model
from pam_cosim.fmu.odes import cached_ode
from pam_cosim.simulation import Simulator
from tests.fmu import models
from tests.tiers import quick

TIMES = np.linspace(0.0, 2.0, 21)


def _ode() -> Ode:
    return cached_ode("key", models.lag)


MAKE: dict[str, Callable[[], Path]] = {
    "an FMU": lambda: cached_fmu("key", _ode),
    "a compiled model": lambda: cached_lean_model("key", _ode),
    "a model as data": lambda: cached_taped_model("key", _ode),
}


def _run(path: Path) -> list[float]:
    with Simulator(path) as simulator:
        made: list[float] = simulator.run(TIMES, parameters={"x_start": 1.0})["y"].tolist()
        return made


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty one, beside the files of the C compiler that is used everywhere."""
    (cache_dir() / "zig").mkdir(parents=True, exist_ok=True)
    made = tmp_path / "cache"
    made.mkdir()
    (made / "zig").symlink_to(cache_dir() / "zig")
    monkeypatch.setenv("PAM_COSIM_CACHE", str(made))
    return made


def _files(cache: Path) -> list[Path]:
    return sorted(p for p in cache.rglob("*") if p.is_file() and not p.is_symlink())


def _cut(file: Path) -> None:
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def _changed(file: Path) -> None:
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 0x40
    file.write_bytes(content)


def _pipe(file: Path) -> None:
    file.unlink()
    os.mkfifo(file)


DAMAGE: dict[str, Callable[[Path], object]] = {
    "removed": Path.unlink,
    "cut": _cut,
    "changed in one byte": _changed,
    "emptied": lambda file: file.write_bytes(b""),
    "of another kind": lambda file: file.write_bytes(zlib.compress(b"\x7fELF" + bytes(range(256)))),
}


@pytest.mark.parametrize("what", quick(MAKE, "a model as data"))
def test_what_is_damaged_is_made_again(cache: Path, what: str) -> None:
    """Each file in each way, with those that were made from it gone, so that it is asked for."""
    expected = _run(MAKE[what]())
    for file in _files(cache):
        for damage in DAMAGE.values():
            for later in (
                ("fmus", "models", "tapes") if file.parent.name in ("odes", "binaries") else ()
            ):
                shutil.rmtree(cache / later, ignore_errors=True)
            if file.exists():
                damage(file)
                assert file.name.endswith(".sums") or not is_whole(
                    file.with_name(file.name + ".sums")
                )
            assert _run(MAKE[what]()) == expected


def test_what_is_no_file_is_said(cache: Path) -> None:
    fmu = cached_fmu("key", _ode)
    _pipe(fmu)
    with pytest.raises(
        InputError, match=r"is a pipe.*can be made again.*PAM_COSIM_CACHE"
    ) as caught:
        cached_fmu("key", _ode)
    assert caught.value.file == fmu and "\n" not in str(caught.value)
    shutil.rmtree(cache / "fmus")
    (cache / "fmus").write_text("")
    with pytest.raises(InputError, match=r"folder cannot be made.*PAM_COSIM_CACHE"):
        cached_fmu("key", _ode)
