"""Calls in random order with good and bad arguments, under the sanitizers, compiled from the FMU's own sources."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import fmpy
import pytest

from pam_cosim.cache import cache_dir
from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu.platforms import PLATFORMS, native_platform
from tests.fmu import models

_FUZZ = Path(__file__).with_name("fuzz.c")
_COMMON = ["-std=c99", "-g", "-O1", "-w"]
_GCC = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
_ZIG = ["-fsanitize=undefined", "-fno-sanitize-recover=all"]


def _compiler(folder: Path) -> list[str]:
    """Two sanitizers of gcc or clang, where they work; else ziglang, without a runtime for AddressSanitizer."""
    gcc = shutil.which("gcc") or shutil.which("clang")
    if gcc is not None:
        (folder / "probe.c").write_text("int main(void) { return 0; }\n")
        probe = str(folder / "probe")
        made = subprocess.run([gcc, *_GCC, f"{probe}.c", "-o", probe], capture_output=True)
        if not made.returncode and not subprocess.run([probe], capture_output=True).returncode:
            return [gcc, *_GCC]
    target = PLATFORMS[native_platform()].target  # stated, as for an FMU
    return [sys.executable, "-m", "ziglang", "cc", "-target", target, *_ZIG]


def _program(path: Path, fmi: str, folder: Path) -> Path:
    compiler = _compiler(folder)
    with zipfile.ZipFile(path) as archive:
        archive.extractall(folder)
    sources = sorted(str(p) for p in (folder / "sources").glob("*.c"))
    guid = fmpy.read_model_description(str(path)).guid
    program = folder / "fuzz"
    command = [
        *compiler,
        *_COMMON,
        f"-DFMI={fmi[0]}",
        f"-DFMI{fmi[0]}_OVERRIDE_FUNCTION_PREFIX",
        f'-DGUID="{guid}"',
        f"-I{folder / 'sources'}",
        str(_FUZZ),
        *sources,
    ]
    zig = str(cache_dir() / "zig")
    environment = os.environ | {"ZIG_GLOBAL_CACHE_DIR": zig, "ZIG_LOCAL_CACHE_DIR": zig}
    subprocess.run([*command, "-lm", "-o", str(program)], check=True, env=environment)
    return program


@pytest.mark.full
@pytest.mark.parametrize(
    ("make", "fmi"),
    [
        (models.lag, "2.0"),
        (models.lag, "3.0"),
        (models.delayed_mix, "3.0"),
        (models.breaks_down, "2.0"),
    ],
)
def test_no_call_does_harm(make: Callable[[], Ode], fmi: str, tmp_path: Path) -> None:
    path = models.fmu(make, fmi)
    program = _program(path, fmi, tmp_path)
    description = fmpy.read_model_description(str(path))
    arguments = [
        str(len({v.valueReference for v in description.modelVariables})),
        str(int(description.modelExchange is not None)),
    ]
    first = int(os.environ.get("PAM_COSIM_FUZZ_SEED", "0"))
    for seed in range(first, first + 2):
        run = subprocess.run(
            [str(program), str(seed), "4000", *arguments],
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )
        assert run.returncode == 0, run.stderr[-4000:]
        good, _, _, refused, messages = (int(n) for n in run.stdout.split())
        assert good > 500 and refused > 500 and messages > 100
