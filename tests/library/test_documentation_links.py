"""Links in the documentation of the library lead somewhere, and what could be a link is one."""

from __future__ import annotations

import re
from functools import cache

from pam_cosim.resources import modelica_root
from tests.library.shelf import check_each, tree
from tests.library.test_references import BIBLIOGRAPHY, cited, plain

LINK = re.compile(r'<a\s+href="([^"]*)">(.*?)</a>', re.DOTALL)
CODE = re.compile(r"<code>([A-Z]\w*(?:\.\w+)*)</code>")
SCHEME = "modelica://"
LONGEST_LINE = 120
CHANGELOG = modelica_root().parent / "CHANGELOG.md"


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


def test_every_name_of_another_class_is_a_link() -> None:
    check_each(_names_are_links, documented())


def _names_are_links(name: str) -> None:
    for text in CODE.findall(tree().classes[name].documentation):
        found = _class_in_scope(name, text)
        assert found in (None, name), f"{text} is {found}"


def _class_in_scope(name: str, text: str) -> str | None:
    """The class that a name means in the packages around a class; None where the class itself has one of that name."""
    first = text.partition(".")[0]
    scope = name
    if tree().classes[name].kind != "package":
        if any(f"{owner}.{first}" in tree().classes for owner in (name, *tree().bases(name))):
            return None
        scope = name.rpartition(".")[0]
    while scope and f"{scope}.{first}" not in tree().classes:
        scope = scope.rpartition(".")[0]
    found = f"{scope}.{text}".removeprefix(".")
    return found if found in tree().classes else None


def test_the_first_mention_of_a_work_is_a_link() -> None:
    check_each(_links_what_it_cites, (name for name in documented() if name != BIBLIOGRAPHY))


def _links_what_it_cites(name: str) -> None:
    mentioned = set(cited(plain(tree().classes[name].documentation)))
    linked = {text for target, text in links(name) if target == SCHEME + BIBLIOGRAPHY}
    assert mentioned <= linked, mentioned - linked


def test_lines_are_no_longer_than_python_s() -> None:
    for file in sorted(modelica_root().rglob("*.mo")):
        for number, line in enumerate(file.read_text().splitlines(), 1):
            assert len(line) <= LONGEST_LINE, f"{file}:{number}"


def test_release_notes_have_every_version() -> None:
    versions = re.findall(r"^## \[?([^\]\n]+)\]?$", CHANGELOG.read_text(), re.MULTILINE)
    notes = tree().classes["PneumaticMuscle.UsersGuide.ReleaseNotes"].documentation
    assert re.findall(r"<p><b>([^<]+)</b></p>", notes) == versions
    assert tree().classes["PneumaticMuscle"].annotations["version"].strip('version="') in versions
