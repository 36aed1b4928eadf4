"""Results that cannot be written where they are asked for: one message, status 2, and no part of a file."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from pam_cosim.cli.app import main
from tests.hostile.reading import make
from tests.hostile.small_disk import disks_can_be_made, on_disk
from tests.tiers import quick

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
COMMANDS = {
    "a trajectory": [*RUN, "-o"],
    "a picture": [*RUN, "--plot"],
    "a sweep": SWEEP,
    "a model": ["add", "LinearBladder", "--to", "Isotonic", "-o"],
    "an FMU": ["build", "TankFilling", "-o"],
    "a comparison": ["compare", "data", "--json"],
    "a report": ["compare", "data", "--report"],
    "a fit": ["fit", "data", "-o"],
    "what a fit keeps": ["fit", "data", "--resume"],
    "a data set": ["new"],
}
MORE = {"a data set": ["data/run-01.csv"]}
PLACES = ("/dev/null", "/dev/full", "link to a device", "link to nowhere", "link to itself", "pipe", "/proc/version",
          "/dev/stdout", "file/x.csv", "x" * 300, "nowhere/x.csv", "", "..")  # fmt: skip
TAKEN = {
    "an FMU": ("", "..", "nowhere/x.csv"),
    "a data set": ("nowhere/x.csv",),
}  # folders, which are made for them
NAMES = ("$(touch MADE)", "`touch MADE`", "-x", "[red]x <b>", "a'b\"c;touch MADE", "%s%n{0}", "ü ß")


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    make(tmp_path / "data", {})
    (tmp_path / "file").write_text("x")
    os.mkfifo("pipe")
    for name, target in (
        ("a device", "/dev/full"),
        ("nowhere", "nowhere/x"),
        ("itself", "link to itself"),
    ):
        os.symlink(target, f"link to {name}")
    return tmp_path


@pytest.mark.full
@pytest.mark.parametrize("what", COMMANDS)
def test_places_that_hold_no_file(
    place: Path, capfd: pytest.CaptureFixture[str], what: str
) -> None:
    before = sorted(place.rglob("*"))
    for name in PLACES:
        if name in TAKEN.get(what, ()):
            continue
        assert main([*COMMANDS[what], name, *MORE.get(what, [])]) == 2, name
        said = capfd.readouterr().err
        assert (
            said.startswith("pam-cosim: ") and said.count("\n") == 1 and "Traceback" not in said
        ), (name, said)
        assert sorted(place.rglob("*")) == before, name


@pytest.mark.parametrize("name", quick(NAMES, NAMES[0]))
def test_names_are_names(place: Path, capfd: pytest.CaptureFixture[str], name: str) -> None:
    """Nothing in them is run, looked up or set in colours; runs and files are told by them as they are."""
    assert main([*RUN, f"-o{name}.csv"]) == 0
    assert (
        f"written: {name}.csv" in capfd.readouterr().err
        and (place / f"{name}.csv").stat().st_size > 100
    )
    run = place / "data" / "run-01.csv"
    run.rename(run.with_name(f"{name}.csv"))
    experiment = place / "data" / "experiment.toml"
    experiment.write_text(experiment.read_text().replace('"run-01.csv"', json.dumps(f"{name}.csv")))
    assert main(["compare", "data", "--json", "c.json", "--report", "c.html"]) == 0
    assert json.loads((place / "c.json").read_text())["runs"][0]["name"] == name
    assert "<b>" not in (place / "c.html").read_text() and not list(place.rglob("MADE"))


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
