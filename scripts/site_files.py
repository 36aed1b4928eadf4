"""Hook of mkdocs: the site holds whatever its pages link to, wherever in the repository that stands.

A page under ``docs`` links to ``../examples/report.md`` as a code host wants it. Such a file becomes one of the site,
below ``repository/``; a page is rendered and its own links are followed in turn. No page is rewritten.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

from links import relative_links
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files, InclusionLevel

ROOT = Path(__file__).resolve().parent.parent


class RepositoryFiles(Files):
    """Files by their path from ``docs``, of which there may be two; a folder stands for its README.md."""

    def get_file_from_path(self, path: str) -> File | None:
        """The file at ``path``, which may leave ``docs`` and come back."""
        path = _from_docs(path)
        return super().get_file_from_path(path) or super().get_file_from_path(
            posixpath.join(path, "README.md")
        )


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Adds what the pages link to outside ``docs``, and what those pages link to."""
    whole = RepositoryFiles(files)
    waiting = list(files.documentation_pages())
    for path in _leaves(config.nav):
        waiting += _added(whole, config, path)
    while waiting:
        page = waiting.pop()
        for link in relative_links(page.content_string):
            if link.path:
                waiting += _added(
                    whole, config, posixpath.join(posixpath.dirname(page.src_uri), link.path)
                )
    return whole


def _added(files: RepositoryFiles, config: MkDocsConfig, path: str) -> list[File]:
    """Adds the file at ``path`` if it is of the repository and not yet there; returns it if it is a page."""
    path = _from_docs(path)
    if files.get_file_from_path(path) or not path.startswith("../"):
        return []
    source = ROOT / "docs" / path
    if source.is_dir():
        path, source = posixpath.join(path, "README.md"), source / "README.md"
    if not source.is_file() or ROOT not in source.resolve().parents:
        return []  # mkdocs reports the link
    file = File.generated(
        config, path, abs_src_path=str(source), inclusion=InclusionLevel.NOT_IN_NAV
    )
    file.dest_uri = posixpath.join("repository", file.dest_uri.removeprefix("../"))
    files.append(file)
    return [file] if file.is_documentation_page() else []


def _from_docs(path: str) -> str:
    """The shortest way to ``path`` from ``docs``: without ``../docs``."""
    path = posixpath.normpath(PurePosixPath(path).as_posix())
    return path.removeprefix("../docs/")


def _leaves(entry: object) -> Iterator[str]:
    if isinstance(entry, str):
        yield entry
    elif entry:
        for part in entry.values() if isinstance(entry, dict) else entry:  # type: ignore[attr-defined]
            yield from _leaves(part)
