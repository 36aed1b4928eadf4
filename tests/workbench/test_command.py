"""The command, where it cannot open a page: one clear sentence, and nothing is left."""

from __future__ import annotations

import socket
from pathlib import Path

import pytest

from pam_cosim.cli.app import main


def test_a_folder_that_is_no_data_set(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    assert main(["workbench", str(tmp_path), "--no-browser"]) == 2
    assert "experiment.toml" in capsys.readouterr().err
    assert [one.name for one in tmp_path.iterdir()] == ["notes.txt"]


def test_a_port_that_is_taken(recorded: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        assert main(["workbench", str(recorded), "--no-browser", "--port", str(port)]) == 2
    said = capsys.readouterr().err
    assert f"port {port}" in said and "--port" in said


def test_without_the_extra_it_says_what_to_install(
    recorded: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "uvicorn", None)
    monkeypatch.delitem(sys.modules, "pam_cosim.workbench.server", raising=False)
    assert main(["workbench", str(recorded), "--no-browser"]) == 2
    assert "pip install 'pam-cosim[workbench]'" in capsys.readouterr().err
