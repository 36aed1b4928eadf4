"""Values and files on a command line that mean nothing: one sentence, status 2, and nothing is written."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from pam_cosim.cli.app import main
from tests.hostile.reading import make

RUN = ["simulate", "TankFilling", "--stop-time", "1"]
SWEEP = ["sweep", "TankFilling", "--stop-time", "1", "--workers", "1", "-o", "s.csv"]
BODE = ["bode", "TankFilling", "--by", "u_in", "--amplitude", "20 mA", "--frequencies"]
SETTINGS = (
    "tank.V=5 K", "tank.V=", "=", "tank.V", "tank.V=1e400", "tank.V=nan", "tank.V=1 L/0", "tank.V=1 L;rm",
    "tank.V=__import__('os')", "tank.V=" + "9" * 5000, "tank.V=1 " + "m" * 10_000, "\x1b[31m=1", "u_in=inf",
    "p_supply=100 dB", "tank.V=1,5 L", "tank.V==1", "tank.V=1 m^3^3^3", "tank.n=true",
)  # fmt: skip
VARIED = ("u_in=", "u_in=1:2", "u_in=1:2:0", "u_in=1:2:1.5", "u_in=nan,1", "u_in=1 K,2 K", "u_in=a:b:c", "zzz=1,2",
          "u_in=1:2:3:4", "u_in=,,", "u_in=1e308:-1e308:5", "inputs=nowhere.csv,x.csv")  # fmt: skip
SCALARS = (
    "max(",
    "max(zzz)",
    "nothing(T)",
    "time_to(p, -5 %)",
    "time_to(p, 1e400 %)",
    "steady(x, 200 %)",
    "max(T);ls",
    "=max(T)",
    "hottest=",
    "",
)
FORMULAS = ("u_in = time^^2", "u_in = " + "(" * 3000 + "1" + ")" * 3000, "u_in = __import__('os').system('ls')",
            "zzz = 1", "u_in = u_in", "u_in = 1/0*time")  # fmt: skip
OPTIONS = (
    [*RUN, "--interval", "1 kg"], [*RUN, "--interval", "-1"], [*RUN, "--keep", "nothing"],
    [*RUN, "--input", ""], [*RUN, "--input", "u_in = 0.1", "--input", "u_out = 0"],
    ["linearise", "TankFilling", "--at", ""],
    [*RUN, "--timeout", "nan"], ["simulate", "TankFilling", "--stop-time", "3 m"],
    ["compare", "data", "--set", "valve.C_A=5 K"], ["compare", "data", "--set", "valve.C_A@run-09=1"],
    ["compare", "data", "--role", "="], ["compare", "data", "--params", "data/run-01.csv"],
    ["compare", "data", "--table", "load.m", "zzz"], ["compare", "data", "--model", "$(ls)"],
    ["fit", "data", "--free", ""], ["fit", "data", "--start", "valve.C_A=nan"], ["fit", "data", "--method", "x"],
    ["fit", "data", "--free", "valve.C_A", "--start", "valve.C_A=5 K"], ["fit", "data", "--resume", "data/run-01.csv"],
    ["linearise", "TankFilling", "--at", "nan"], ["linearise", "TankFilling", "--at", "3 m"],
    [*BODE, "0:1:3"], [*BODE, "-1:1:3"], [*BODE, "nan"], [*BODE, "1:2:" + "9" * 5000], ["describe", "x" * 5000],
    ["build", "TankFilling", "--fmi", "9"], ["build", "TankFilling", "--platform", "; ls"],
    ["add", "Zzz", "--to", "Isotonic", "-o", "x.mo"],
)  # fmt: skip
WORDS = [
    *([*RUN, "--set", word] for word in SETTINGS),
    *([*SWEEP, "--vary", word] for word in VARIED),
    *([*SWEEP, "--vary", "u_in=0.1,0.2", "--scalar", word] for word in SCALARS),
    *([*RUN, "--input", word] for word in FORMULAS),
    *OPTIONS,
]
ENDLESS = {
    ".mo": [["simulate", "FILE"], ["describe", "FILE"], ["build", "FILE", "-o", "x.fmu"], [*RUN, "--file", "FILE"],
            ["compare", "data", "--model", "FILE"], ["add", "LinearBladder", "--to", "FILE", "-o", "x.mo"]],
    ".fmu": [["simulate", "FILE"], ["describe", "FILE"], ["build", "FILE", "-o", "x.fmu"],
             ["compare", "data", "--model", "FILE"]],
    ".csv": [[*RUN, "--input", "FILE"], ["new", "rig", "FILE"],
             ["observe", "TankFilling", "FILE", "--noise", "p=1 kPa"]],
    ".json": [["compare", "data", "--params", "FILE"], ["compare", "data", "--against", "FILE"]],
    ".toml": [["couple", "FILE"]],
}  # fmt: skip


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    make(tmp_path / "data", {})
    return tmp_path


def refused(words: list[str], place: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """One message and nothing else."""
    before = sorted(place.rglob("*"))
    assert main(words) == 2, words
    said = capfd.readouterr().err
    assert (
        "Traceback" not in said
        and "Warning" not in said
        and 20 < len(said) < 1500
        and said.count("\n") < 6
    ), said
    assert sorted(place.rglob("*")) == before, words


@pytest.mark.parametrize(
    "words", WORDS, ids=lambda words: " ".join(words)[:60].encode("unicode_escape").decode()
)
def test_what_means_nothing(
    words: list[str], place: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    refused(words, place, capfd)


@pytest.mark.parametrize("suffix", ENDLESS)
@pytest.mark.parametrize("kind", ["pipe", "endless"])
def test_files_without_an_end(
    suffix: str, kind: str, place: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    file = place / f"file{suffix}"
    if kind == "pipe":
        os.mkfifo(file)
    else:
        file.symlink_to("/dev/zero")
    for words in ENDLESS[suffix]:
        refused([word.replace("FILE", file.name) for word in words], place, capfd)
