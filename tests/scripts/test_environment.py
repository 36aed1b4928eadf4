"""When .venv is made anew, and what is said where it cannot be made."""

from __future__ import annotations

import subprocess
import sys
import venv
from pathlib import Path
from types import SimpleNamespace

import pytest

from scripts import environment

NOW = ".".join(map(str, sys.version_info[:3]))


class Checkout:
    """A checkout whose .venv is made without a package index.

    Attributes:
        made: how often .venv was made.
        installed: how often something was installed into it.
        problem: what ends an installation; None: nothing.
    """

    def __init__(self, root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.home, self.python = root / ".venv", root / ".venv" / "python"
        self.made = self.installed = 0
        self.problem: Exception | None = None
        (root / "pyproject.toml").write_text("")
        monkeypatch.delenv(environment.UNLOCKED, raising=False)
        monkeypatch.setattr(environment, "ROOT", root)
        monkeypatch.setattr(environment, "HOME", self.home)
        monkeypatch.setattr(environment, "PYTHON", self.python)
        monkeypatch.setattr(environment, "install", self.install)
        monkeypatch.setattr(venv, "create", self.create)
        nothing = SimpleNamespace(returncode=0)
        monkeypatch.setattr(subprocess, "run", lambda *words, **options: nothing)

    def create(self, home: Path, with_pip: bool) -> None:
        home.mkdir(exist_ok=True)
        self.python.write_text("")
        (home / "pyvenv.cfg").write_text(f"home = /usr/bin\nversion = {NOW}\n")
        self.made += 1

    def install(self, words: list[str]) -> None:
        self.installed += 1
        if self.problem:
            raise self.problem


@pytest.fixture
def checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Checkout:
    return Checkout(tmp_path, monkeypatch)


def test_the_same_python_keeps_it(checkout: Checkout) -> None:
    assert environment.main("") == environment.main("") == environment.main("test") == 0
    assert (checkout.made, checkout.installed) == (1, 2)


@pytest.mark.parametrize("line", ["version = 3.9.1", "version_info = 3.9.1.final.0"])
def test_another_version_of_python_has_its_own(checkout: Checkout, line: str) -> None:
    environment.main("")
    (checkout.home / "pyvenv.cfg").write_text(f"home = /usr/bin\n{line}\n")
    (checkout.home / "of-the-old-one").touch()
    assert environment.main("") == 0
    assert checkout.made == 2 and not (checkout.home / "of-the-old-one").exists()


def test_one_whose_python_is_gone_is_made_anew(checkout: Checkout) -> None:
    environment.main("")
    checkout.python.unlink()
    checkout.python.symlink_to("/nowhere/python3")
    assert environment.main("") == 0
    assert checkout.made == 2 and not checkout.python.is_symlink()


def test_without_the_lock_it_is_installed_again(
    checkout: Checkout, monkeypatch: pytest.MonkeyPatch
) -> None:
    for count, value in enumerate(["", "1", "1", ""]):
        monkeypatch.setenv(environment.UNLOCKED, value)
        assert environment.main("") == 0
        assert checkout.installed == (1, 2, 2, 3)[count]
    assert checkout.made == 1
