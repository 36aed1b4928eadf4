"""FMUs of other tools that crash, hang or dawdle: the lag with its C runtime changed."""

from __future__ import annotations

import re
import zipfile
from functools import cache
from pathlib import Path

from pam_cosim.fmu.build import runtime
from pam_cosim.fmu.compile import compile_library
from pam_cosim.fmu.generate import model_source
from pam_cosim.fmu.platforms import native_platform
from pam_cosim.fmu.read import read_description
from pam_cosim.resources import fmu_runtime
from tests.fmu import models

# Never returns from the function that ALWAYS or the environment names, nor from fmi2SetReal with a value above
# HANG_ABOVE: it waits for ever, or works for ever where it says SPIN. Takes 0.15 s for each step where it says DAWDLE.
_HANG = """
#define _POSIX_C_SOURCE 199309L
#define ALWAYS "{always}"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
static void spin(void) { for (volatile int i = 1; i;) if (!getenv("SPIN")) pause(); }
static void hang(const char *function) {
    const char *chosen = getenv("HANG");
    if (!strcmp(ALWAYS, function) || (chosen && !strcmp(chosen, function))) spin();
    if (getenv("DAWDLE") && !strcmp(function, "fmi2DoStep")) {
        struct timespec pause = {0, 150000000};
        nanosleep(&pause, NULL);
    }
}
static void compare_all(const double *value, size_t n) {
    const char *above = getenv("HANG_ABOVE");
    for (size_t i = 0; above && i < n; i++) if (value[i] > atof(above)) spin();
}
__attribute__((constructor)) static void load(void) { hang("load"); }
"""


def repacked(
    source: Path, target: Path, change: dict[str, str] | None = None, binary: bytes | None = None
) -> Path:
    """A copy with texts of the model description replaced, or with another binary."""
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w") as new:
        for name in old.namelist():
            data = old.read(name)
            if name == "modelDescription.xml":
                text = data.decode()
                for a, b in (change or {}).items():
                    assert a in text
                    text = text.replace(a, b)
                data = text.encode()
            elif binary is not None:
                data = binary
            new.writestr(name, data)
    return target


def _binary(change: dict[str, str]) -> bytes:
    """The lag compiled with other texts for some files of the runtime."""
    guid = read_description(models.fmu(models.lag)).guid
    sources = {name: (fmu_runtime() / name).read_text() for name in runtime()} | change
    sources["model.c"] = model_source(models.lag(), guid)
    return compile_library((), sources, native_platform()).read_bytes()


def patched(folder: Path, name: str, old: str, new: str) -> Path:
    """The lag with another C text in one file of its runtime."""
    text = (fmu_runtime() / name).read_text()
    assert old in text
    binary = _binary({name: "#include <stdio.h>\n#include <stdlib.h>\n" + text.replace(old, new)})
    return repacked(models.fmu(models.lag), folder / "x.fmu", binary=binary)


@cache
def _hanging_binary(always: str) -> bytes:
    name = "pam_fmi2.c"
    text = (fmu_runtime() / name).read_text()
    entry = re.compile(r"^(fmi2\w+ (fmi2\w+)\([^)]*\) \{)", re.MULTILINE)
    assert {"fmi2Instantiate", "fmi2DoStep", "fmi2SetReal"} <= {m[2] for m in entry.finditer(text)}
    text = entry.sub(
        lambda m: f'{m[1]} hang("{m[2]}");' + " compare_all(value, n);" * (m[2] == "fmi2SetReal"),
        text,
    )
    return _binary({name: _HANG.replace("{always}", always) + text})


def hanging(folder: Path, always: str = "") -> Path:
    """The lag, which hangs where the environment says: ``HANG``, ``HANG_ABOVE``, ``DAWDLE``, ``SPIN``.

    Processes that were started before know nothing of that, a pool's among them: for them there is ``always``.
    """
    return repacked(models.fmu(models.lag), folder / "Hanging.fmu", binary=_hanging_binary(always))


def processes_of(path: Path) -> list[int]:
    """Those that were started for this file; reads /proc."""
    processes = []
    for folder in Path("/proc").iterdir():
        if folder.name.isdigit():
            try:
                words = (folder / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if str(path).encode() in words:
                processes.append(int(folder.name))
    return processes
