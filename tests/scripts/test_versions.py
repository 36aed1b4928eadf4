"""A version that is written twice has one section in the change log."""

from __future__ import annotations

import shutil
from pathlib import Path

from scripts.releasing import versions
from tests.documentation.pages import ROOT


def test_a_version_with_nothing_new_has_one_section(tmp_path: Path) -> None:
    for place in versions.PLACES:
        (tmp_path / place.file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / place.file, tmp_path / place.file)
    log = tmp_path / "CHANGELOG.md"
    log.write_text("# Changelog\n\n## [Unreleased]\n\n## 0.1.0\n\n- The first.\n")
    versions.set_version("7.8.9", tmp_path)
    once = log.read_text()
    assert once.count("## 7.8.9 (") == 1
    versions.set_version("7.8.9", tmp_path)
    assert log.read_text() == once
    assert versions.notes("7.8.9", tmp_path) == "", "an empty section is still a fault"
    assert "CHANGELOG.md has nothing under '## 7.8.9'" in versions.faults(tmp_path)
