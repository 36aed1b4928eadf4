"""Every relative link of every page leads somewhere, as a code host reads it; every page and package has its place."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from scripts.links import anchors, relative_links

ROOT = Path(__file__).parents[2]
PAGES = sorted(
    page
    for where in ("*.md", "docs/**/*.md", "examples/**/*.md", "benchmarks/**/*.md")
    for page in ROOT.glob(where)
)
NAVIGATION = (ROOT / "mkdocs.yml").read_text().partition("\nnav:")[2]


def broken_links(page: Path) -> list[str]:
    """What is wrong with the links of a page, with its line."""
    faults = []
    for link in relative_links(page.read_text()):
        target = (page.parent / link.path).resolve() if link.path else page
        if link.path.startswith("/") or ROOT not in target.parents:
            faults.append(f"{page.name}:{link.line}: {link.path} leaves the repository")
        elif not target.exists():
            faults.append(f"{page.name}:{link.line}: there is no {link.path}")
        elif link.anchor and link.anchor not in anchors(target.read_text()):
            faults.append(
                f"{page.name}:{link.line}: {link.path or 'the page'} has no heading #{link.anchor}"
            )
    return faults


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_links(page: Path) -> None:
    assert not broken_links(page)


def test_every_page_is_in_the_navigation() -> None:
    entries = set(re.findall(r"(\S+\.md)$", NAVIGATION, re.MULTILINE))
    pages = {page.name for page in (ROOT / "docs").rglob("*.md")}
    assert 10 <= len(pages) <= 25 and pages <= entries


def test_every_package_is_in_the_reference() -> None:
    """What a package of ``pam_cosim`` offers, its ``__all__``, is documented."""
    packages = {
        p.parent.name for p in ROOT.glob("pam_cosim/*/__init__.py") if "__all__" in p.read_text()
    }
    assert len(packages) >= 9
    listed = re.findall(
        r"^::: pam_cosim\.(\w+)$", (ROOT / "docs" / "api.md").read_text(), re.MULTILINE
    )
    assert sorted(listed) == sorted(packages)
