"""What is installed is this checkout's: no other package of its name, and no environment of another checkout."""

from __future__ import annotations

import re
from pathlib import Path
from types import SimpleNamespace

import pytest

from scripts import environment
from tests.documentation.pages import ROOT


@pytest.mark.parametrize(
    "file", sorted((ROOT / ".github" / "workflows").glob("*.yml")), ids=lambda file: file.name
)
def test_this_package_is_never_installed_by_its_name(file: Path) -> None:
    commands = re.findall(r"pip install (.*)", file.read_text(encoding="utf-8"))
    assert not [words for words in commands if re.search(r"(^|\s)pam[-_]cosim(\s|$|\[|=)", words)]


class Checkout:
    """A checkout whose environment is made without a package index.

    Attributes:
        made: what was installed, in order.
    """

    def __init__(self, root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.root, self.home = root, root / ".venv"
        self.made: list[str] = []
        root.mkdir(exist_ok=True)
        (root / "pyproject.toml").write_text("")
        monkeypatch.setattr(environment, "ROOT", root)
        monkeypatch.setattr(environment, "HOME", self.home)
        monkeypatch.setattr(environment, "PYTHON", self.home / "python")
        monkeypatch.setattr(environment, "install", lambda words: self.made.append(words[-1]))
        nothing = SimpleNamespace(returncode=0)
        monkeypatch.setattr(environment.subprocess, "run", lambda *words, **options: nothing)
        monkeypatch.setattr(environment.venv, "create", self.create)

    def create(self, home: Path, with_pip: bool) -> None:
        home.mkdir(exist_ok=True)
        (home / "python").write_text(str(self.root))

    def set_up(self, extra: str = "") -> list[str]:
        """What is installed now."""
        self.made.clear()
        assert environment.main(extra) == 0
        return list(self.made)


@pytest.mark.parametrize("extra", ["", "test"])
def test_a_moved_checkout_has_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, extra: str
) -> None:
    Checkout(tmp_path / "a", monkeypatch).set_up()
    (tmp_path / "a").rename(tmp_path / "b")
    moved = Checkout(tmp_path / "b", monkeypatch)
    assert moved.set_up(extra) != []
    assert (moved.home / "python").read_text() == str(moved.root)
    assert moved.set_up(extra) == []
