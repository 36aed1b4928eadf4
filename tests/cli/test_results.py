"""Where results go: to a file, through a link, never onto a device, a pipe, a socket or a folder."""

from __future__ import annotations

import os
import socket
import stat
from collections.abc import Callable
from pathlib import Path

import pytest

import pam_cosim as pam
from pam_cosim import study
from tests.cli.conftest import Outcome, everything
from tests.cli.test_bad_input import refused
from tests.cli.test_commands import done

Command = Callable[..., Outcome]

pytestmark = pytest.mark.skipif(os.name != "posix", reason="devices, pipes and links of POSIX")

# every option that writes a file, with the shortest command that has it; {} is the file
WRITERS = {
    "simulate -o": "simulate VesselOrifice -o {}",
    "simulate --plot": "simulate VesselOrifice --plot {}",
    "sweep -o": "sweep VesselOrifice --vary tank.n=1,1.4 -o {}",
    "compare --json": "compare data --json {}",
    "compare --report": "compare data --report {}",
    "compare --table-csv": "compare data --table tank.V orifice.d --table-csv {}",
    "compare --table-plot": "compare data --table tank.V orifice.d --table-plot {}",
    "fit -o": "fit data -o {}",
    "fit --json": "fit data --json {}",
    "diagnose --json": "diagnose data --json {}",
    "diagnose --report": "diagnose data --report {}",
    "diagnose --next": "diagnose data --next {}",
    "diagnose --learned": "diagnose data --learned {}",
    "add -o": "add EnergyGas --to VesselOrifice -o {}",
    "build -o": "build VesselOrifice -o {}",
}
ENDINGS = {
    "add -o": ".mo",
    "diagnose --learned": ".mo",
    "build -o": ".fmu",
    "simulate --plot": ".png",
    "compare --table-plot": ".png",
}
QUICK = [
    "simulate -o",
    "simulate --plot",
    "sweep -o",
    "compare --json",
    "compare --report",
    "add -o",
    "build -o",
]


def words(writer: str, target: Path | str) -> str:
    return WRITERS[writer].format(target)


def make(kind: str, path: Path) -> None:
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "socket":
        with socket.socket(socket.AF_UNIX) as made:
            made.bind(str(path))
    elif kind == "device":  # a node needs privileges, a link to one does not
        path.symlink_to("/dev/full")
    elif kind == "stream":
        path.symlink_to("/dev/stdout")
    elif kind == "link to itself":
        path.symlink_to(path.name)
    elif kind == "link into no folder":
        path.symlink_to("none/x")
    else:
        path.mkdir()


@pytest.mark.parametrize(
    "kind",
    ["pipe", "socket", "device", "stream", "folder", "link to itself", "link into no folder"],
)
@pytest.mark.parametrize("writer", WRITERS)
def test_an_invalid_output_file_is_refused_before_the_work(
    command: Command,
    place: Path,
    data: Path,
    writer: str,
    kind: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for step in (
        "build",
        "describe",
        "read",
        "compare",
        "fit",
        "diagnose",
        "add",
        "simulate",
        "sweep",
    ):
        if (writer, step) != ("build -o", "build"):
            monkeypatch.setattr(study, step, lambda *a, **k: pytest.fail("work was done"))
    target = place / f"x{ENDINGS.get(writer, '')}"
    make(kind, target)
    before = os.lstat(target)
    said = {"device": "is a device", "stream": "is a ", "link to itself": "leads to itself",
            "link into no folder": "does not exist"}.get(kind, f"is a {kind}")  # fmt: skip
    refused(command(words(writer, target)), [target.name, said])
    after = os.lstat(target)
    assert (after.st_ino, after.st_mode) == (before.st_ino, before.st_mode)
    assert sorted(p.name for p in place.iterdir()) == ["data", target.name]
    assert stat.S_ISCHR(os.stat("/dev/full").st_mode)


@pytest.mark.parametrize("there", [True, False], ids=["file", "dangling"])
@pytest.mark.parametrize("writer", QUICK)
def test_a_link_stays_and_its_file_is_replaced(
    command: Command, place: Path, data: Path, writer: str, there: bool
) -> None:
    ending = ENDINGS.get(writer, "")
    (place / "far").mkdir()
    file, link = place / "far" / f"file{ending}", place / f"link{ending}"
    if there:
        file.write_text("old")
        file.chmod(0o640)
    (place / "middle").symlink_to(f"far/file{ending}")
    link.symlink_to("middle")
    done(command(words(writer, link)))
    assert link.is_symlink() and (place / "middle").is_symlink() and not file.is_symlink()
    assert file.stat().st_size > 100
    assert not there or stat.S_IMODE(file.stat().st_mode) == 0o640
    assert [p.name for p in (place / "far").iterdir()] == [file.name]
    assert sorted(p.name for p in place.iterdir()) == sorted(["data", "far", "middle", link.name])


def test_two_results_for_one_file(command: Command, place: Path, data: Path) -> None:
    (place / "link").symlink_to("r")
    refused(command("compare data --json r --report link"), ["link", "two results"])
    assert sorted(p.name for p in place.iterdir()) == ["data", "link"]


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="root may write everything")
def test_a_protected_file(command: Command, place: Path) -> None:
    (place / "x.csv").write_text("kept")
    (place / "x.csv").chmod(0o444)
    refused(command("simulate VesselOrifice -o x.csv"), ["protected"])
    assert (place / "x.csv").read_text() == "kept"


# the shortest command that reads the file and would write to it
OVERWRITERS = {
    "the data set's description": "compare data --json description.json",
    "a recording": "compare data --report recording.html",
    "a recording, through a link": "fit data -o link.json",
    "the parameters": "compare data --params p.json --json p.json",
    "inputs": "simulate TankFilling --input u.csv -o u.csv",
    "inputs that a sweep varies": "sweep TankFilling --stop-time 1 --vary inputs=u.csv,v.csv -o v.csv",
    "a saved comparison, by compare": "compare saved.npz --json link.json",
    "a saved comparison, by fit": "fit saved.npz -o link.json",
    "a saved comparison": "diagnose saved.npz --save saved.npz",
    "an FMU": "compare carries.fmu --json fmu.json",
    "a class of a package": "linearise Lib.Sub --file Lib -o sub.csv",
    "the model that is extended": "add LaminarLeak --to Own.mo -o Own.mo",
    "a further file": "add LaminarLeak --to TankFilling --file Own.mo -o Own.mo",
}


@pytest.mark.parametrize("case", OVERWRITERS)
def test_no_result_replaces_what_the_command_reads(case: str, command: Command, data: Path) -> None:
    place = data.parent
    (place / "p.json").write_text('{"tank.n": 1.2}')
    (place / "u.csv").write_text("time [s],u_in [A]\n0,0.3\n1,0.3\n")
    (place / "Own.mo").write_text(
        "model Own\n  extends PneumaticMuscle.Benches.TankFilling;\nend Own;\n"
    )
    pam.save(pam.compare(pam.read("data")), "saved.npz")
    (place / "v.csv").write_text((place / "u.csv").read_text())
    (place / "carries.fmu").write_text("is not looked at")
    (place / "Lib").mkdir()
    (place / "Lib" / "package.mo").write_text("package Lib\nend Lib;\n")
    (place / "Lib" / "Sub.mo").write_text("within Lib;\nmodel Sub\nend Sub;\n")
    saved = "saved" in case
    for link, file in {
        "link.json": "saved.npz" if saved else "data/one.csv",
        "description.json": "data/experiment.toml",
        "recording.html": "data/../data/one.csv",
        "fmu.json": "carries.fmu",
        "sub.csv": "Lib/Sub.mo",
    }.items():
        (place / link).symlink_to(place / file)
    before = everything(place)
    words = OVERWRITERS[case]
    refused(command(words), [words.split()[-1], "is read by the command"])
    assert everything(place) == before


ENDINGS_OF_OTHERS = (
    "compare data --json x.html",
    "compare data --report x.json",
    "fit data --resume x.png",
    "fit data --json x.npz",
    "build TankFilling -o x.zip",
    "bench --pneumatics regulator --mechanics spring -o x.json",
)


@pytest.mark.parametrize("words", ENDINGS_OF_OTHERS)
def test_the_ending_of_another_format(command: Command, data: Path, words: str) -> None:
    refused(command(words), [words.split()[-1], "name a f"])
    assert [p.name for p in data.parent.iterdir()] == ["data"]
