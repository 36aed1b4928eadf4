"""Relative links and anchors of a Markdown page, as a code host reads them (CommonMark with tables)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from urllib.parse import unquote, urlsplit

from markdown_it import MarkdownIt
from markdown_it.token import Token

_PARSER = MarkdownIt("commonmark").enable("table")


@dataclass(frozen=True)
class Link:
    """Where a link or picture points to: a path relative to its page, empty for the page itself, and an anchor."""

    line: int
    path: str
    anchor: str


def relative_links(text: str) -> list[Link]:
    """Links and pictures of a page that name no host."""
    links = []
    for line, token in _inline(_PARSER.parse(text), 0):
        target = token.attrGet("href") if token.type == "link_open" else token.attrGet("src")
        parts = urlsplit(str(target or ""))
        if target and not parts.scheme and not parts.netloc:
            links.append(Link(line, unquote(parts.path), parts.fragment))
    return links


def anchors(text: str) -> set[str]:
    """What a link to this page may name: its headings, as a code host spells them, and its ``<a id="...">``."""
    tokens = _PARSER.parse(text)
    named = set()
    for before, token in zip(tokens, tokens[1:], strict=False):
        if before.type == "heading_open":
            slug, count = _slug(token), 0
            while (name := f"{slug}-{count}" if count else slug) in named:
                count += 1
            named.add(name)
    html = [token.content for _, token in _inline(tokens, 0) if token.type.startswith("html")]
    return named | set(re.findall(r'<a\s+(?:id|name)="([^"]+)"', "".join(html)))


def _slug(heading: Token) -> str:
    text = "".join(t.content for t in heading.children or () if t.type in ("text", "code_inline"))
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def _inline(tokens: list[Token], line: int) -> Iterator[tuple[int, Token]]:
    """Every token with the line that it begins on, those within paragraphs too."""
    for token in tokens:
        line = token.map[0] + 1 if token.map else line
        yield line, token
        yield from _inline(token.children or [], line)
