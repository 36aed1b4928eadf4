"""What pages of the documentation say, for comparison with what programs say."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"


def text_of(page: str) -> str:
    """A page of ``docs``, each run of white space one blank."""
    return one_line((DOCS / page).read_text(encoding="utf-8"))


def one_line(text: str) -> str:
    """Each run of white space one blank."""
    return " ".join(text.split())


def absent(sentences: list[str], page: str) -> list[str]:
    """Those sentences that do not stand on a page of ``docs``, word for word."""
    text = text_of(page)
    return [s for s in sentences if one_line(s) not in text]


def other_pictures(folder: Path) -> list[str]:
    """Names of pictures in a folder that are not those of ``docs/pictures``, byte by byte."""
    made = sorted(folder.glob("*.png"))
    kept = DOCS / "pictures"
    return [p.name for p in made if not (kept / p.name).exists() or p.read_bytes() != (kept / p.name).read_bytes()]
