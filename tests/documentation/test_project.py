"""What stands around the code says the same everywhere."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import yaml

from pam_cosim import benches
from pam_cosim.catalogue import effect_classes
from pam_cosim.compiler import read_library

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def test_citation() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    assert {"cff-version", "message", "title", "authors"} <= set(
        citation
    )  # what the format asks for
    assert citation["title"] == PROJECT["name"]
    assert citation["version"] == PROJECT["version"]
    assert citation["license"] == PROJECT["license"]
    assert [a["name"] for a in citation["authors"]] == [a["name"] for a in PROJECT["authors"]]
    assert set(citation["keywords"]) <= set(PROJECT["keywords"])


def test_changelog_begins_with_what_is_not_released() -> None:
    headings = re.findall(r"^## (.+)$", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    assert headings[:2] == ["[Unreleased]", PROJECT["version"]]


def test_checks_before_a_commit_are_those_of_the_tests() -> None:
    """From ``.venv``, which is there: nothing to download, and no other version than that of the tests."""
    configuration = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text())
    assert [repository["repo"] for repository in configuration["repos"]] == ["local"]
    entries = [hook["entry"] for hook in configuration["repos"][0]["hooks"]]
    assert all(entry.startswith(".venv/bin/") for entry in entries)
    commands = re.findall(
        r"^(\.venv/bin/\w+(?: check)?)", (ROOT / "scripts" / "test").read_text(), re.MULTILINE
    )
    assert len(commands) >= 2
    assert all(any(entry.startswith(command) for entry in entries) for command in commands)


def test_extras_do_what_the_scripts_ask_for() -> None:
    extras = PROJECT["optional-dependencies"]
    for script in ("test", "docs"):
        asked = re.search(r"environment\.py (\w+)", (ROOT / "scripts" / script).read_text())
        assert asked and asked[1] in extras
    assert f"{PROJECT['name']}[docs]" in extras["test"], "the full tier builds the site"


CODE = {
    word
    for folder, suffix in (("pam_cosim", ".py"), ("fmu", ".c"), ("refsim", ".py"))
    for file in (ROOT / folder).rglob(f"*{suffix}")
    for word in re.findall(r"\w+", file.read_text(encoding="utf-8"))
}
NUMBERS = ("ten", "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen")


def test_what_the_readme_counts() -> None:
    text = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    effects = effect_classes(read_library())
    assert f"{NUMBERS[len(benches()) - 10]} benches" in text
    assert f"{len(effects)} effects in {len({e.family for e in effects})} families" in text


def test_every_package_has_a_line_in_how_it_works() -> None:
    page = (ROOT / "docs" / "how-it-works.md").read_text(encoding="utf-8")
    packages = [p.parent.name for p in (ROOT / "pam_cosim").glob("*/__init__.py")]
    assert [name for name in packages if f"pam_cosim/{name}`" not in page] == []


def test_contributing_says_what_continuous_integration_runs() -> None:
    run = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    assert "--full" not in run and "continuous integration runs the line above" in text


def test_files_and_functions_of_how_it_works_exist() -> None:
    """Each name in backticks is a file below the packages, or stands in the code of some file on its line."""
    rooms = [ROOT, *(ROOT / room for room in ("pam_cosim", "pam_cosim/workbench", "refsim"))]
    missing = []
    for line in (ROOT / "docs" / "how-it-works.md").read_text(encoding="utf-8").splitlines():
        for name in re.findall(r"`([\w./]+)`", line):
            if "/" in name or re.search(r"\.(py|c|js)$", name):
                found = any((room / name).exists() for room in rooms)
            elif re.fullmatch(r"[a-zA-Z]+_\w+|\w+\.\w+", name) and not name.isupper():
                found = all(part in CODE for part in name.split("."))
            else:
                continue
            missing += [] if found else [name]
        for file, function in re.findall(r"`([\w/]+\.(?:py|c))`, `([\w.]+)`", line):
            path = next(room / file for room in rooms if (room / file).exists())
            text = path.read_text(encoding="utf-8")
            missing += [p for p in function.split(".") if p not in text]
    assert missing == []
