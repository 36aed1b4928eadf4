"""Runs every bench's FMU on Windows (wine) and on ARM (qemu), and compares with Linux on x86-64.

python -m scripts.systems.run [BENCH...]; the status is 1 where a result is farther off than docs/own-fmu.md
allows, a run fails, or the binary for macOS has a fault.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import fmpy
import numpy as np
import ziglang
from fmpy import read_model_description

import pam_cosim as pam
from pam_cosim.fmu.platforms import PLATFORMS, binary_folder
from scripts.systems.mach_o import read_mach_o

HERE = "x86_64-linux"
STEPS = 500
DRIVER = Path(__file__).with_name("driver.c")
ARM_LIBRARIES = Path("/usr/aarch64-linux-gnu")
LONGEST = 300.0  # [s] of a run


@dataclass(frozen=True)
class System:
    """Another system, and what runs its programs here.

    Attributes:
        name: as people say it.
        platform: of ``PLATFORMS``.
        runner: program that runs those of the system; None: they run as they are.
        words: what stands before a program of it.
        tolerance: of results against those of Linux on x86-64, in ranges of the output.
    """

    name: str
    platform: str
    runner: str | None
    words: tuple[str, ...] = ()
    tolerance: float = 0.0

    @property
    def missing(self) -> str:
        """What is not installed here; empty where the system can be run."""
        if self.runner is None:
            return ""
        if shutil.which(self.runner) is None:
            return f"no {self.runner} here"
        return (
            "no libc6-arm64-cross here" if "-L" in self.words and not ARM_LIBRARIES.is_dir() else ""
        )


LINUX = System("Linux x86-64", HERE, None)
# The functions of Windows' C library differ in their last bit: no solver is closer than its tolerance to that.
WINDOWS = System("Windows x86-64 (wine)", "x86_64-windows", "wine", ("wine",), 1e-6)
ARM = System("Linux aarch64 (qemu)", "aarch64-linux", "qemu-aarch64-static",
             ("qemu-aarch64-static", "-L", str(ARM_LIBRARIES)), 1e-12)  # fmt: skip
OTHERS = (WINDOWS, ARM)
MACS = ("x86_64-macos", "aarch64-macos")


@cache
def driver(system: System, folder: Path) -> Path:
    """The program that loads an FMU, compiled for a system."""
    windows = system.platform.endswith("windows")
    made = folder / f"driver-{system.platform}{'.exe' if windows else ''}"
    headers = Path(fmpy.__file__).parent / "c-code"
    command = [
        str(Path(ziglang.__file__).parent / "zig"),
        "cc",
        "-target",
        PLATFORMS[system.platform].target,
    ]
    command += ["-O1", "-w", f"-I{headers}", str(DRIVER), "-o", str(made)]
    subprocess.run(command if windows else [*command, "-ldl"], check=True)
    return made


def simulate(fmu: Path, system: System, folder: Path) -> np.ndarray:
    """What an FMU puts out on a system, shape (instants, outputs).

    Raises:
        RuntimeError: it failed there, with its own words.
    """
    described = read_model_description(str(fmu))
    place = folder / system.platform / described.modelName
    target = PLATFORMS[system.platform]
    part = f"binaries/{binary_folder(system.platform, [*PLATFORMS])}/{described.coSimulation.modelIdentifier}"
    with zipfile.ZipFile(fmu) as archive:
        library = archive.extract(part + target.suffix, place)
    real = [v for v in described.modelVariables if v.type == "Real"]
    inputs = [v for v in real if v.causality == "input"]
    outputs = [v for v in real if v.causality == "output"]
    stop = described.defaultExperiment.stopTime
    words = [
        *system.words,
        str(driver(system, folder)),
        library,
        described.guid,
        stop,
        str(STEPS),
        str(len(inputs)),
    ]
    words += [word for v in inputs for word in (str(v.valueReference), v.start)]
    words += [str(v.valueReference) for v in outputs]
    quiet = os.environ | {
        "WINEDEBUG": "-all",
        "WINEPREFIX": os.environ.get("WINEPREFIX", str(folder / "wine")),
    }
    done = subprocess.run(words, env=quiet, capture_output=True, text=True, timeout=LONGEST)
    if done.returncode:
        raise RuntimeError(f"{described.modelName} on {system.name}: {done.stderr[-500:]}")
    return np.array(
        [[float.fromhex(word) for word in line.split()] for line in done.stdout.splitlines()]
    )


def difference(here: np.ndarray, there: np.ndarray) -> float:
    """The largest difference of any output at any instant, in ranges of that output."""
    assert here.shape == there.shape == (STEPS + 1, here.shape[1]) and here.shape[1] > 0
    span = np.ptp(here, axis=0)
    return float(np.max(np.abs(there - here) / np.where(span > 0.0, span, 1.0)))


def built(bench: str, folder: Path) -> Path:
    """The FMU of a bench with the binaries of all platforms."""
    return pam.build(bench, folder / f"{bench}.fmu", platforms=["all"])


def mac_faults(fmu: Path) -> list[str]:
    """What would keep macOS from loading the FMU, as far as its binary shows; empty: nothing."""
    described = read_model_description(str(fmu))
    name = described.coSimulation.modelIdentifier
    with zipfile.ZipFile(fmu) as archive:
        content = archive.read(f"binaries/darwin64/{name}.dylib")
    slices = read_mach_o(content)
    faults = [f"no slice for {kind}" for kind in ("x86_64", "arm64") if kind not in slices]
    for kind, image in slices.items():
        wanted = {
            "_fmi2Instantiate",
            "_fmi2DoStep",
            "_fmi2GetReal",
            "_fmi2GetDerivatives",
            "_fmi2FreeInstance",
        }
        faults += [
            f"{kind}: {symbol} is not exported" for symbol in sorted(wanted - image.exported)
        ]
        faults += [
            f"{kind}: needs {library}" for library in image.libraries if "libSystem" not in library
        ]
        faults += [
            f"{kind}: an import that is in no library"
            for library in image.imported.values()
            if not library
        ]
        faults += [] if image.is_library else [f"{kind}: is no dynamic library"]
        faults += [f"{kind}: no system version"] * (image.oldest_system is None)
        if kind == "arm64" and not image.signed:
            faults.append("arm64: not signed, which Apple's processors ask for")
    return faults


@dataclass(frozen=True)
class Row:
    """A bench's line of Markdown, and what is wrong with it."""

    line: str
    faults: tuple[str, ...]


def compared(
    fmu: Path, here: np.ndarray, system: System, folder: Path
) -> tuple[str, tuple[str, ...]]:
    """How far a system is from what came of the FMU here, for the table, and what is wrong with that."""
    try:
        far = difference(here, simulate(fmu, system, folder))
    except (RuntimeError, subprocess.TimeoutExpired) as problem:
        return "failed", (str(problem),)
    if far <= system.tolerance:
        return f"{far:.1e}", ()
    allowed = f"allowed are {system.tolerance:g}"
    return f"{far:.1e}", (f"{fmu.stem} on {system.name}: {far:.1e} from Linux, {allowed}",)


def row(bench: str, systems: Sequence[System], folder: Path) -> Row:
    """A bench on each system."""
    fmu = built(bench, folder)
    here = simulate(fmu, LINUX, folder)
    far = [compared(fmu, here, system, folder) for system in systems]
    mac = mac_faults(fmu)
    cells = [bench, str(here.shape[1]), *(cell for cell, _ in far), "; ".join(mac) or "in order"]
    faults = [fault for _, found in far for fault in found]
    faults += [f"{bench} on macOS: {fault}" for fault in mac]
    return Row(f"| {' | '.join(cells)} |", tuple(faults))


def main(words: Sequence[str]) -> int:
    """Prints the table, and what is wrong; returns the exit status."""
    parser = argparse.ArgumentParser(prog="./scripts/other_systems", description=__doc__)
    parser.add_argument("benches", nargs="*", metavar="BENCH", help="default: all")
    asked = parser.parse_args(words)
    for system in OTHERS:
        if system.missing:
            print(f"left out: {system.name}: {system.missing}", file=sys.stderr)
    systems = [system for system in OTHERS if not system.missing]
    heads = ["bench", "outputs", *(s.name for s in systems), "macOS, binary checked"]
    print(f"| {' | '.join(heads)} |", "|" + "---|" * len(heads), sep="\n", flush=True)
    faults: list[str] = []
    with tempfile.TemporaryDirectory() as folder:
        for bench in asked.benches or pam.benches():
            made = row(bench, systems, Path(folder))
            print(made.line, flush=True)
            faults += made.faults
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
