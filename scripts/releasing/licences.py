"""The licences of what an installation brings along, by what the packages say of themselves."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path

_TITLE = """# Licences of what comes along

pam-cosim itself is under the MIT licence. An FMU that it builds holds its C runtime (MIT) and, in
`sources/`, the header files of FMI (Modelica Association, 2-Clause BSD). The wheel holds the schemas of SSP 2.0.1
(Modelica Association, 2-Clause BSD). Installed beside it are, in the versions that were tested:

| package | version | licence, as it says |
|---|---|---|
"""


def locked(lock: Path) -> Iterator[tuple[str, str]]:
    """Names and versions in a lock file; those for other systems too."""
    for match in re.finditer(
        r"^([A-Za-z0-9._-]+)==([^\s;\\]+)", lock.read_text(encoding="utf-8"), re.MULTILINE
    ):
        yield match[1], match[2]


def licence_of(name: str) -> str:
    """What a package says: an expression, classifiers, a field, or how its text begins; empty: not installed."""
    try:
        package = distribution(name)
    except PackageNotFoundError:
        return ""
    about = package.metadata
    classifiers = [
        c.rpartition(" :: ")[2]
        for c in about.get_all("Classifier", [])
        if c.startswith("License ::")
    ]
    classified = "; ".join(c for c in classifiers if c != "OSI Approved")
    stated = (
        about.get("License-Expression") or classified or about.get("License") or _text_of(package)
    )
    return " ".join(stated.split())[:80]


def _text_of(package: Distribution) -> str:
    file = next((f for f in package.files or () if ".dist-info/licenses/" in str(f)), None)
    return "not stated" if file is None else f"its text begins: {file.read_text()[:60]}"


def page(lock: Path) -> str:
    """A table as Markdown."""
    rows = ((name, version, licence_of(name)) for name, version in locked(lock))
    absent = "not installed here: for another system, or a build tool"
    return _TITLE + "".join(
        f"| {name} | {version} | {licence or absent} |\n" for name, version, licence in rows
    )
