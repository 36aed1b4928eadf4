"""Where the recordings of others come from, and how they are checked: repository, commit, files and SHA-256 sums."""

from __future__ import annotations

import hashlib
import subprocess
from dataclasses import dataclass
from pathlib import Path

SUMS = Path(__file__).with_name("SHA256SUMS")


class FetchError(Exception):
    """What went wrong while recordings were fetched."""


@dataclass(frozen=True)
class Source:
    """A public repository at one commit."""

    owner: str
    name: str
    commit: str
    terms: str

    @property
    def slug(self) -> str:
        """Owner and name as one word, also the name of a local mirror's folder."""
        return f"{self.owner}+{self.name}"

    @property
    def address(self) -> str:
        """Where git finds it."""
        return f"https://github.com/{self.owner}/{self.name}.git"


HOSES = Source(
    "Foadsf",
    "PneuAct_ICRA2018",
    "066f640644178dd853d2783d6095dd54a2201905",
    "scientific and academic purposes; cite Sojoodi Farimani and Misra, ICRA 2018",
)
MUSCLES = Source(
    "Agile-and-Adaptive-Robotics",
    "Muscle_Sensory",
    "e3a82772cc06d6461d47e93977240af863d6f1e8",
    "no licence stated: for use by yourself; ask the authors before passing anything on",
)


@dataclass(frozen=True)
class Store:
    """The files of one source, read from a git directory and checked against their sums."""

    source: Source
    directory: Path
    sums: dict[str, str]

    def paths(self, folder: str) -> list[str]:
        """All files below a folder."""
        listed = _git(
            self.directory, "ls-tree", "-r", "-z", "--name-only", self.source.commit, folder
        )
        return [p for p in listed.decode("utf-8").split("\0") if p]

    def content(self, path: str) -> bytes:
        """The content of one file, unchecked."""
        return _git(self.directory, "show", f"{self.source.commit}:{path}")

    def read(self, path: str) -> bytes:
        """The content of one file.

        Raises:
            FetchError: the file is not there, or is not the one that was used here.
        """
        content = self.content(path)
        wanted = self.sums.get(f"{self.source.slug}/{path}")
        found = hashlib.sha256(content).hexdigest()
        if wanted != found:
            raise FetchError(f"{self.source.slug}/{path}: SHA-256 is {found}, expected {wanted}")
        return content


def opened(source: Source, cache: Path, mirror: Path | None) -> Store:
    """The source from a local mirror, or fetched into ``cache``: one commit, and of its files those that are read.

    A mirror holds a git directory ``OWNER+NAME/repo`` (or ``OWNER+NAME``) for each source.

    Raises:
        FetchError: there is no such mirror, or git fails.
    """
    directory = cache / source.slug
    if mirror is not None:
        places = [mirror / source.slug / "repo", mirror / source.slug]
        directory = next((p for p in places if p.is_dir()), places[0])
        if not directory.is_dir():
            raise FetchError(f"{mirror}: no git directory {source.slug}")
    elif not directory.is_dir():
        directory.mkdir(parents=True)
        _git(directory, "init", "--quiet")
        _git(directory, "remote", "add", "origin", source.address)
        _git(
            directory,
            "fetch",
            "--quiet",
            "--depth=1",
            "--filter=blob:none",
            "origin",
            source.commit,
        )
    return Store(source, directory, _sums())


def _sums() -> dict[str, str]:
    lines = SUMS.read_text(encoding="utf-8").splitlines() if SUMS.is_file() else []
    return {path: value for value, _, path in (line.partition("  ") for line in lines)}


def _git(directory: Path, *arguments: str) -> bytes:
    done = subprocess.run(
        ["git", "-C", str(directory), *arguments], capture_output=True, check=False
    )
    if done.returncode:
        raise FetchError(
            f"git {arguments[0]} in {directory}: {done.stderr.decode(errors='replace').strip()}"
        )
    return done.stdout
