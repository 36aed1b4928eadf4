"""What stands around the code says the same everywhere."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import yaml

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


def test_every_package_has_a_line_in_how_it_works() -> None:
    page = (ROOT / "docs" / "how-it-works.md").read_text(encoding="utf-8")
    packages = [p.parent.name for p in (ROOT / "pam_cosim").glob("*/__init__.py")]
    assert [name for name in packages if f"pam_cosim/{name}`" not in page] == []


def test_how_it_works_names_files_and_functions_that_exist() -> None:
    """Every named file exists, and defines the functions that the page names with it."""
    page = (ROOT / "docs" / "how-it-works.md").read_text(encoding="utf-8")
    files = [p for folder in ("pam_cosim", "fmu") for p in (ROOT / folder).rglob("*.*")]
    places = {name: [p for p in files if p.match(name)] for name in re.findall(_FILE, page)}
    assert len(places) > 50
    assert [name for name, matches in places.items() if not matches] == []
    pairs = re.findall(rf"{_FILE}, {_NAME}(?:, {_NAME})?", page)
    pairs += [
        (file, *names) for *names, file in re.findall(rf"{_NAME}(?:, {_NAME})? in {_FILE}", page)
    ]
    functions = [(file, name) for file, *names in pairs for name in filter(None, names)]
    assert len(functions) > 15
    assert [f for f in functions if not any(_defines(p, f[1]) for p in places[f[0]])] == []


_FILE, _NAME = r"`([\w/]+\.(?:py|c|js))`", r"`([\w.]+)`"


def _defines(file: Path, name: str) -> bool:
    definition = rf"^(?:\s*(?:async def|def|class) |\w[\w *]*\b){name.split('.')[-1]}\b"
    return re.search(definition, file.read_text(encoding="utf-8"), re.MULTILINE) is not None
