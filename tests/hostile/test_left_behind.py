"""What a command that is killed leaves behind, and names of results that would harm what is there."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from pam_cosim.cli.app import main
from pam_cosim.workbench.saved import FILE
from tests.hostile.reading import make

pytestmark = pytest.mark.skipif(os.name != "posix", reason="processes are looked at")


def test_folders_of_killed_commands_are_removed_by_the_next(tmp_path: Path) -> None:
    ended = subprocess.Popen([sys.executable, "-c", ""])
    ended.wait()
    old, young, alive, other = (
        tmp_path / f"pam-cosim-{name}"
        for name in (
            f"{ended.pid}-0123abcd",
            f"{ended.pid}-89efabcd",
            f"{os.getpid()}-0123abcd",
            "x",
        )
    )
    for folder in (old, young, alive, other):
        (folder / "in it").mkdir(parents=True)
        if folder is not young:
            os.utime(folder, (0, 0))
    environment = os.environ | {"TMPDIR": str(tmp_path)}
    subprocess.run(
        [sys.executable, "-m", "pam_cosim", "--help"],
        env=environment,
        check=True,
        capture_output=True,
    )
    assert sorted(tmp_path.iterdir()) == sorted([young, alive, other])


@pytest.mark.parametrize(
    "words", [["compare", "--json"], ["diagnose", "--json"], ["check", "--json"]]
)
def test_a_saved_study_is_no_place_for_a_result(
    words: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    data = make(tmp_path / "data", {FILE: "a study"})
    assert main([words[0], str(data), words[1], str(data / FILE)]) == 2
    assert "this file is read by the command; name another one" in capsys.readouterr().err
    assert (data / FILE).read_text() == "a study"


def test_a_model_makes_no_folder_a_package(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert (
        main(["add", "LinearBladder", "--to", "Isotonic", "-o", str(tmp_path / "package.mo")]) == 2
    )
    assert "name a file after the model" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
