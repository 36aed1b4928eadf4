"""The site builds with every broken link an error, reads like the code host's pages, and needs no network."""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path

import pytest
from markdown_it import MarkdownIt

ROOT = Path(__file__).parents[2]
COUNTED = ("h1", "h2", "h3", "h4", "li", "tr", "img", "pre", "strong")

pytestmark = pytest.mark.full


def build(repository: Path, site: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(site)],
        cwd=repository,
        env={**os.environ, "NO_MKDOCS_2_WARNING": "1"},
        capture_output=True,
        text=True,
    )


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    done = build(ROOT, folder)
    assert done.returncode == 0, done.stderr
    return folder


class Reader(HTMLParser):
    """Counts the tags of the article, and notes what a browser would fetch."""

    def __init__(self) -> None:
        super().__init__()
        self.article = False
        self.counts: Counter[str] = Counter()
        self.fetched: list[str] = []

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.article |= tag == "article"
        if self.article and tag in COUNTED:
            self.counts[tag] += 1
        name = {"script": "src", "img": "src", "iframe": "src", "link": "href"}.get(tag)
        self.fetched += [value for key, value in attributes if key == name and value]

    def handle_endtag(self, tag: str) -> None:
        self.article &= tag != "article"


def read(html: str) -> Reader:
    reader = Reader()
    reader.feed(html)
    return reader


def test_nothing_is_fetched(site: Path) -> None:
    pages = list(site.rglob("*.html"))
    assert len(pages) > 15
    for page in pages:
        fetched = read(page.read_text()).fetched
        assert fetched and not [url for url in fetched if "//" in url], page
        if page.name != "404.html":  # it stands anywhere, so its links begin at the root
            assert all((page.parent / url.partition("#")[0]).exists() for url in fetched), page


def test_pages_read_as_on_a_code_host(site: Path) -> None:
    """The site's Markdown is not the code host's: the same headings, lists, tables, code and pictures come out."""
    markdown = MarkdownIt("commonmark").enable("table")
    pages = [page for page in (ROOT / "docs").rglob("*.md") if "\n::: " not in page.read_text()]
    for page in pages:
        made = read(
            (site / page.relative_to(ROOT / "docs")).with_suffix(".html").read_text()
        ).counts
        assert made == read(f"<article>{markdown.render(page.read_text())}</article>").counts, (
            page.name
        )


def test_files_outside_docs_are_in_the_site(site: Path) -> None:
    page = site / "repository" / "examples" / "jumping-robot" / "report.html"
    assert "repository/examples/jumping-robot/report.html" in (site / "real-rigs.html").read_text()
    assert "result.png" in read(page.read_text()).fetched
    assert 'href="../index.html"' in (site / "repository" / "CONTRIBUTING.html").read_text()


def test_reference_holds_what_the_package_offers(site: Path) -> None:
    import pam_cosim

    page = (site / "api.html").read_text()
    assert not [name for name in pam_cosim.__all__ if f'id="pam_cosim.{name}"' not in page]
