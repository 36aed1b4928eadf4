"""What a command that is killed leaves behind, and names of results that would harm what is there."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from pam_cosim.cli.app import main
from pam_cosim.errors import InputError
from pam_cosim.measurement.table import Layout
from pam_cosim.measurement.text_table import read_text_table
from pam_cosim.workbench.commands.files import save
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


def test_a_study_that_another_workbench_saved_is_not_overwritten(tmp_path: Path) -> None:
    """It was opened where nothing was saved yet."""
    study: Any = SimpleNamespace(check_free=lambda: None, folder=tmp_path, saved_file=None)
    (tmp_path / FILE).write_text("of the other")
    with pytest.raises(InputError, match="another workbench has saved this study"):
        save(study)
    assert (tmp_path / FILE).read_text() == "of the other"


def test_a_text_of_too_many_lines(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pam_cosim.measurement.text_table._MOST_LINES", 1000)
    file = tmp_path / "long.csv"
    file.write_text("time [s],p [kPa]\n" + "1,2\n" * 1001)
    with pytest.raises(InputError, match="it has 1002 lines, and 1000 of a text can be taken"):
        read_text_table(file, Layout())
