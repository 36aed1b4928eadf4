"""What the scripts do without a repository, without git, or within the repository of something else."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from scripts import full_tests, repository
from scripts.releasing import make

FULL = "--full"
Prepare = Callable[[Path, pytest.MonkeyPatch], None]


def git(folder: Path, *words: str) -> str:
    own = ["-c", "user.name=n", "-c", "user.email=e@example.org", "-c", "commit.gpgsign=false"]
    done = subprocess.run(
        ["git", *own, *words], cwd=folder, check=True, capture_output=True, text=True
    )
    return done.stdout.strip()


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout, as yet without a repository."""
    made = (tmp_path / "around" / "checkout").resolve()
    (made / "tests").mkdir(parents=True)
    monkeypatch.setattr(repository, "ROOT", made)
    monkeypatch.setattr(full_tests, "PAGE", made / "tests" / "full-tests.md")
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.resolve()))
    return made


def committed(folder: Path) -> str:
    """Makes a repository with one commit."""
    git(folder, "init", "--quiet")
    (folder / "file").write_text("1\n")
    git(folder, "add", "file")
    git(folder, "commit", "--quiet", "--message", "one")
    return git(folder, "rev-parse", "HEAD")


def no_git(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    committed(root)
    monkeypatch.setenv("PATH", "")


def no_repository(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pass


def of_another(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    committed(root.parent)


def no_commit(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    git(root, "init", "--quiet")


WITHOUT = pytest.mark.parametrize(
    ("prepare", "words"),
    [
        (no_git, "there is no git program"),
        (no_repository, "no git repository"),
        (of_another, "no git repository of its own"),
        (no_commit, "nothing is committed"),
    ],
)


@WITHOUT
def test_that_a_pass_will_not_be_recorded_is_said_once_before_the_tests(
    root: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    prepare: Prepare, words: str,
) -> None:  # fmt: skip
    prepare(root, monkeypatch)
    assert full_tests.main(["before", FULL]) == 0
    assert words in capsys.readouterr().err
    assert full_tests.main(["after", FULL]) == 0
    assert not full_tests.PAGE.exists() and not capsys.readouterr().err


@WITHOUT
def test_no_release_is_made_of_what_is_not_committed(
    root: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    prepare: Prepare, words: str,
) -> None:  # fmt: skip
    prepare(root, monkeypatch)
    assert make.main([]) == 2
    said = capsys.readouterr().err
    assert "no release can be made" in said and words in said


def test_a_pass_of_what_is_committed_is_recorded(
    root: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    commit = committed(root)
    for words in (["before", FULL], ["after", FULL, "-k", "fit"], ["after", "tests/fitting"]):
        assert full_tests.main(words) == 0
    assert not full_tests.PAGE.exists()
    assert full_tests.main(["after", FULL]) == 0
    assert f"`{commit}`" in full_tests.PAGE.read_text() and not capsys.readouterr().err


def test_a_pass_of_what_is_not_committed_is_not_recorded(
    root: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    committed(root)
    (root / "file").write_text("2\n")
    assert full_tests.main(["after", FULL]) == 0
    assert "not committed" in capsys.readouterr().err and not full_tests.PAGE.exists()
    assert make.not_committed() == ["not committed: M file"]
