"""Links in the documentation of the library lead somewhere, and what could be a link is one."""

from __future__ import annotations

import re
from functools import cache

from tests.library.catalogue import check_each, tree
from tests.library.test_references import BIBLIOGRAPHY

LINK = re.compile(r'<a\s+href="([^"]*)">(.*?)</a>', re.DOTALL)
SCHEME = "modelica://"


@cache
def documented() -> tuple[str, ...]:
    return tuple(
        n for n, c in tree().classes.items() if n.startswith("PneumaticMuscle") and c.documentation
    )


def links(name: str) -> list[tuple[str, str]]:
    """Targets and texts of the links in a class's documentation."""
    return [
        (target, " ".join(text.split()))
        for target, text in LINK.findall(tree().classes[name].documentation)
    ]


def test_every_link_leads_to_a_class_that_it_names() -> None:
    assert sum(len(links(name)) for name in documented()) > 500
    check_each(_links_resolve, documented())


def _links_resolve(name: str) -> None:
    assert tree().classes[name].documentation.count("<a") == len(links(name))
    for target, text in links(name):
        linked = target.removeprefix(SCHEME)
        assert target.startswith(SCHEME) and linked in tree().classes, target
        if linked != BIBLIOGRAPHY or "." in text:
            assert f".{linked}".endswith(f".{text}"), (target, text)
