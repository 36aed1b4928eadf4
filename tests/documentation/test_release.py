"""One version everywhere, and files of a release that can be made; the script itself needs tools and minutes."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
import yaml

from scripts.releasing import licences, versions
from tests.documentation.pages import ROOT

WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The places that state the version."""
    for place in (*(p.file for p in versions.PLACES), "CHANGELOG.md"):
        (tmp_path / place).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / place, tmp_path / place)
    return tmp_path


def test_every_place_states_the_version() -> None:
    assert versions.faults() == []


def test_a_place_that_says_otherwise_is_found(copy: Path) -> None:
    citation = copy / "CITATION.cff"
    citation.write_text(
        citation.read_text().replace(f"version: {versions.version()}", "version: 9.9.9")
    )
    assert versions.faults(copy) == [f"CITATION.cff says 9.9.9, not {versions.version()}"]


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


@pytest.mark.parametrize("file", WORKFLOWS, ids=lambda file: file.stem)
def test_workflows_call_what_is_there(file: Path) -> None:
    jobs = yaml.safe_load(file.read_text())["jobs"]
    assert jobs
    for job in jobs.values():
        assert "timeout-minutes" in job
        commands = [step["run"] for step in job["steps"] if "run" in step]
        assert commands
        for command in commands:
            if command.startswith("./"):
                assert (ROOT / command.split()[0]).is_file(), command


def test_paper_cites_what_its_list_has() -> None:
    paper = (ROOT / "paper" / "paper.md").read_text(encoding="utf-8")
    listed = re.findall(
        r"^@\w+\{(\w+),", (ROOT / "paper" / "paper.bib").read_text(encoding="utf-8"), re.MULTILINE
    )
    assert len(listed) == len(set(listed)) and set(re.findall(r"@(\w+)", paper)) == set(listed)
    head = yaml.safe_load(paper.split("---")[1])
    assert {"title", "tags", "authors", "affiliations", "date", "bibliography"} <= set(head)
    assert 750 <= len(paper.split("---", 2)[2].split()) <= 1750  # as the journal asks
