"""One version everywhere, and files of a release that can be made; the script itself needs tools and minutes."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from scripts.releasing import licences, versions
from tests.documentation.pages import ROOT


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The places that state the version."""
    for place in (*(p.file for p in versions.PLACES), "CHANGELOG.md"):
        (tmp_path / place).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / place, tmp_path / place)
    return tmp_path


def test_every_place_states_the_version() -> None:
    assert versions.faults() == []


def test_a_new_version_is_written_to_every_place(copy: Path) -> None:
    versions.set_version("7.8.9", copy)
    assert versions.version(copy) == "7.8.9"
    assert versions.faults(copy) == []
    assert "`pam-cosim demo`" in versions.notes("7.8.9", copy), (
        "what was not released is the new section"
    )
    log = (copy / "CHANGELOG.md").read_text()
    assert log.index("## [Unreleased]") < log.index("## 7.8.9") < log.index("## 0.1.0")
    with pytest.raises(ValueError, match="no version"):
        versions.set_version("7.8", copy)


def test_every_dependency_states_a_licence() -> None:
    page = licences.page(ROOT / "scripts" / "locks" / "base.txt")
    rows = [line for line in page.splitlines() if line.startswith("| ") and "package" not in line]
    assert len(rows) > 30 and not [row for row in rows if "not stated" in row]
    assert "| numpy |" in page and "| casadi |" in page
