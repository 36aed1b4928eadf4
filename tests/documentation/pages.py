"""What pages of the documentation say, for comparison with what programs say."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from matplotlib.image import imread

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
    """Names of pictures in a folder that do not look like those of ``docs/pictures``, pixel by pixel."""
    made = sorted(folder.glob("*.png"))
    return [p.name for p in made if not _alike(p, DOCS / "pictures" / p.name)]


def _alike(one: Path, other: Path) -> bool:
    """Whether no pixel differs by more than what the last digits of a line's points change at its edge."""
    if not other.exists():
        return False
    a, b = imread(one), imread(other)
    return a.shape == b.shape and float(np.abs(a - b).max()) < 0.05


def quoted(page: str) -> list[str]:
    """Lines that a page of ``docs`` quotes from a program's output: of its text blocks, and verdicts within sentences.

    A line of three dots stands for what is left out.
    """
    text = (DOCS / page).read_text(encoding="utf-8")
    blocks = re.findall(r"```text\n(.*?)```", text, re.DOTALL)
    lines = [line.strip() for block in blocks for line in block.splitlines()]
    verdicts = re.findall(r"`((?:identified|ambiguous|unknown): [^`]*)`", text)
    return [line for line in (*lines, *verdicts) if line and line != "..."]


def unsaid(page: str, output: str) -> list[str]:
    """What a page of ``docs`` quotes that does not stand in the output of its commands."""
    return [line for line in quoted(page) if one_line(line) not in one_line(output)]


def other_numbers(page: str, table: Mapping[str, Sequence[float]]) -> list[str]:
    """Rows of tables of a page of ``docs`` whose numbers are not those of a program, to the digits that are printed.

    Args:
        page: its name.
        table: the numbers of each row, by a word in backticks of its first cell.
    """
    wrong, found = [], set()
    for line in (DOCS / page).read_text(encoding="utf-8").splitlines():
        first, *cells = (
            [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("|") else [""]
        )
        name = next((n for n in table if f"`{n}`" in first), None)
        if name is None:
            continue
        found.add(name)
        numbers = [cell for cell in cells if cell]
        if [f"{v:.{_decimals(n)}f}" for v, n in zip(table[name], numbers, strict=True)] != numbers:
            wrong.append(f"{line} is not {table[name]}")
    return wrong + [f"no row for {name}" for name in table if name not in found]


def _decimals(number: str) -> int:
    return len(number.partition(".")[2])
