"""The version: ``pyproject.toml`` says it, every other place must say the same."""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from datetime import date
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FORM = re.compile(r"\d+\.\d+\.\d+")


@dataclass(frozen=True)
class Place:
    """A line of a file that states the version: what stands before it and behind it, as patterns."""

    file: str
    before: str
    behind: str

    @property
    def pattern(self) -> re.Pattern[str]:
        """Finds the version as group 2."""
        return re.compile(f"({self.before})({FORM.pattern})({self.behind})", re.MULTILINE)


SOURCE = Place("pyproject.toml", r'^version = "', '"')
PLACES = (
    SOURCE,
    Place("CITATION.cff", r"^version: ", "$"),
    Place("modelica/PneumaticMuscle/package.mo", r'annotation \(version="', '"'),
    Place("docs/index.md", r"pam_cosim-", "-py3"),
    Place("README.md", r"pam_cosim-", "-py3"),
)


def version(root: Path = ROOT) -> str:
    """What ``pyproject.toml`` says."""
    return str(
        tomllib.loads((root / SOURCE.file).read_text(encoding="utf-8"))["project"]["version"]
    )


def faults(root: Path = ROOT) -> list[str]:
    """Places that say otherwise, a change log without the version."""
    wanted, found = version(root), []
    for place in PLACES:
        stated = {
            match[2]
            for match in place.pattern.finditer((root / place.file).read_text(encoding="utf-8"))
        }
        if stated != {wanted}:
            found.append(
                f"{place.file} says {', '.join(sorted(stated)) or 'no version'}, not {wanted}"
            )
    if not notes(wanted, root):
        found.append(f"CHANGELOG.md has nothing under '## {wanted}'")
    return found


def notes(wanted: str, root: Path = ROOT) -> str:
    """The section of a version in the change log; empty: there is none, or nothing in it."""
    return (section(wanted, root) or "").strip()


def section(wanted: str, root: Path = ROOT) -> str | None:
    """What stands under the heading of a version in the change log; None: it has no such heading."""
    text = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    found = re.search(
        rf"^## {re.escape(wanted)}(?: [^\n]*)?\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL
    )
    return found[1] if found else None


def set_version(new: str, root: Path = ROOT) -> None:
    """Writes a version to all places; what is not released in the change log becomes its section.

    Raises:
        ValueError: it is no version.
    """
    if not FORM.fullmatch(new):
        raise ValueError(f"'{new}' is no version of the form 1.2.3")
    for place in PLACES:
        file = root / place.file
        file.write_text(
            place.pattern.sub(rf"\g<1>{new}\g<3>", file.read_text(encoding="utf-8")),
            encoding="utf-8",
        )
    log = root / "CHANGELOG.md"
    text = log.read_text(encoding="utf-8")
    if section(new, root) is None:
        headings = f"## [Unreleased]\n\n## {new} ({date.today().isoformat()})\n"
        log.write_text(text.replace("## [Unreleased]\n", headings, 1), encoding="utf-8")
