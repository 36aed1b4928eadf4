"""Results that cannot be written where they are asked for: one message, status 2, and no part of a file."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.hostile.reading import make
from tests.hostile.small_disk import disks_can_be_made, on_disk

RUN = ["simulate", "TankFilling", "--stop-time", "1"]
SWEEP = [
    "sweep",
    "TankFilling",
    "--stop-time",
    "1",
    "--vary",
    "u_in=0.1,0.2",
    "--workers",
    "1",
    "-o",
]


ON_DISK = {
    "csv": [*RUN, "-o", "DISK/x.csv"],
    "netcdf": [*RUN, "-o", "DISK/x.nc"],
    "parquet": [*RUN, "-o", "DISK/x.parquet"],
    "picture": [*RUN, "--plot", "DISK/x.png"],
    "sweep": [*SWEEP, "DISK/x.csv"],
    "comparison": ["compare", "DATA", "--json", "DISK/x.json"],
    "report": ["compare", "DATA", "--report", "DISK/x.html"],
    "fit": ["fit", "DATA", "-o", "DISK/x.json"],
    "resume": ["fit", "DATA", "--resume", "DISK/x"],
    "model": ["add", "LinearBladder", "--to", "Isotonic", "-o", "DISK/x.mo"],
    "fmu": ["build", "TankFilling", "-o", "DISK/x.fmu"],
    "data set": ["new", "DISK/rig", "DATA/run-01.csv"],
}
MAIN = """
import json, sys
from pam_cosim.cli.app import main
for words in json.loads(sys.argv[1]):
    print("status", main(words), flush=True)
    print("said", file=sys.stderr, flush=True)
"""


@pytest.mark.full
@pytest.mark.skipif(not disks_can_be_made(), reason="no disk can be made here")
@pytest.mark.parametrize("how", ["full", "read-only"])
def test_a_disk_that_takes_nothing(tmp_path: Path, how: str) -> None:
    disk, data = tmp_path / "disk", make(tmp_path / "data", {})
    disk.mkdir()
    exact = {"DISK": str(disk), "DATA": str(data)}
    words = [
        [w.replace("DISK", exact["DISK"]).replace("DATA", exact["DATA"]) for w in ws]
        for ws in ON_DISK.values()
    ]
    status, lines, said = on_disk(disk, ["-c", MAIN, json.dumps(words)], how=how)
    assert status == 0, said
    assert [line for line in lines if line.startswith("status")] == ["status 2"] * len(words), said
    assert lines[-1] in ("fill", "status 2"), lines  # what fills the disk, and no other file
    messages = [part.strip() for part in said.split("said\n")][:-1]
    system = {"full": "No space left on device", "read-only": "Read-only|no permission"}[how]
    for message in messages:
        assert message.startswith("pam-cosim: ") and "\n" not in message, message
        assert any(reason in message for reason in system.split("|")), message
