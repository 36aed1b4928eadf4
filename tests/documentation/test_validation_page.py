"""docs/validation.md says what scripts/pictures.py prints, and shows what it draws."""

from __future__ import annotations

from pathlib import Path

import pytest

from scripts.pictures import DRAWERS, drawn
from tests.documentation.pages import absent, other_pictures


@pytest.mark.full
def test_sentences_and_pictures_of_the_page_are_those_of_the_program(tmp_path: Path) -> None:
    sentences = drawn(tmp_path)
    assert len(sentences) > len(DRAWERS)
    assert absent(sentences, "validation.md") == []
    band = [s for s in sentences if "once the muscle moves" in s or "degrees Celsius" in s]
    assert len(band) == 2 and absent(band, "stories.md") == []
    assert (
        len(list(tmp_path.glob("*.png"))) == len(DRAWERS) - 1
    )  # one tells of a mass and draws nothing
    assert other_pictures(tmp_path) == []
