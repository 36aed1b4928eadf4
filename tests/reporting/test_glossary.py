"""Words that a report explains are those of the glossary."""

from pathlib import Path

from pam_cosim.reporting.glossary import WORDS, glossary_entries

PAGE = Path(__file__).parents[2] / "docs" / "glossary.md"


def test_the_page_says_the_same() -> None:
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    for word, meaning in WORDS.items():
        assert f"| {word} | {meaning} |" in lines


def test_each_has_an_anchor_of_its_own() -> None:
    anchors = [entry["anchor"] for entry in glossary_entries()]
    assert len(set(anchors)) == len(WORDS) and all(a.replace("-", "").isalnum() for a in anchors)
