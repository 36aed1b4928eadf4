"""Every citation in the library's documentation points to UsersGuide.References, and every entry there is cited."""

from __future__ import annotations

import re
from functools import cache

from tests.library.catalogue import check_each, tree

BIBLIOGRAPHY = "PneumaticMuscle.UsersGuide.References"
NAME = r"[A-Z][A-Za-z]+(?:-[A-Z][a-z]+)?"
CITATION = re.compile(
    rf"\b((?:{NAME}, )*{NAME}(?: and (?:others|{NAME}))? (?:18|19|20)\d\d|(?:ISO|IEC) \d+|EN \d+-\d+|DP|DY|AM)\b"
)
LOOSE = {
    "a year apart from its authors": re.compile(r"[(,] ?(?:18|19|20)\d\d\b"),
    "initials, which belong to the bibliography": re.compile(
        r"(?:[:(;,]|\b(?:and|by|of|after)) ?(?:[A-Z]\. ?)+[A-Z][a-z]+"
    ),
    "a title, which belongs to the bibliography": re.compile(r"<i>"),
}


@cache
def keys() -> tuple[str, ...]:
    return tuple(re.findall(r"<li><b>([^<]+)</b>", tree().classes[BIBLIOGRAPHY].documentation))


@cache
def texts() -> dict[str, str]:
    """Description and documentation of every class but the bibliography, each on one line."""
    return {
        name: plain(f"{info.description} {info.documentation}")
        for name, info in tree().classes.items()
        if name.startswith("PneumaticMuscle") and name != BIBLIOGRAPHY
    }


def plain(text: str) -> str:
    """On one line, without links."""
    return " ".join(re.sub(r"</?a\b[^>]*>", "", text).split())


def cited(text: str) -> list[str]:
    return CITATION.findall(text)


def test_every_citation_is_in_the_bibliography() -> None:
    assert len(texts()) > 400
    check_each(_cites_the_bibliography, sorted(texts()))


def _cites_the_bibliography(name: str) -> None:
    assert set(cited(texts()[name])) <= set(keys()), cited(texts()[name])
    for what, pattern in LOOSE.items():
        match = pattern.search(texts()[name])
        assert match is None, f"{what}: {match.group()}"


def test_every_entry_is_cited() -> None:
    everything = {key for text in texts().values() for key in cited(text)}
    assert set(keys()) == everything and len(set(keys())) == len(keys()) > 30


def test_entries_are_whole() -> None:
    """A title for each; authors and year for what is cited by them."""
    for entry in re.findall(r"<li>(.*?)</li>", plain(tree().classes[BIBLIOGRAPHY].documentation)):
        key, rest = re.match(r"<b>(.*?)</b>: (.*)", entry, re.DOTALL).groups()  # type: ignore[union-attr]
        assert re.search(r"<i>.{10,}</i>, .{5,}\.$", rest, re.DOTALL), key
        if (year := re.search(r"\d{4}$", key)) and not key.startswith(("ISO", "IEC")):
            authors, _, place = rest.partition("<i>")
            assert year.group() in place
            first = re.split(r",| and ", key.removesuffix(year.group()).strip())[0]
            assert first in authors
