"""What pages of the documentation say, for comparison with what programs say."""

from __future__ import annotations

import re
import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from matplotlib.colors import rgb_to_hsv
from matplotlib.image import imread
from numpy.typing import NDArray

_DIGITS = 0.02  # relative, by which numbers of a fit differ on other processors
_PIXELS = 0.004  # of full brightness, in the mean: less than all curves that have moved
_DRAWN = 0.2  # of the pixels of one colour, that may be more or fewer: a curve that is missing takes them all
_FEW = 150  # pixels of one colour, which may be a single mark
_HUES = 24  # in the middle of one each: red, green and blue
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")
ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"


def source(page: str) -> str:
    """Markdown of a page of ``docs``; of ``PAGE.md#HEADING`` the text below that heading of level two."""
    name, _, heading = page.partition("#")
    text = (DOCS / name).read_text(encoding="utf-8")
    if not heading:
        return text
    parts = re.split(r"^## (.+)$", text, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))[heading]


def blocks(page: str, language: str) -> list[str]:
    """Its code blocks in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```", source(page), re.DOTALL | re.MULTILINE)


def commands(page: str) -> list[list[str]]:
    """The words of each command of its shell blocks."""
    text = "\n".join(blocks(page, "sh")).replace("\\\n", " ")
    lines = [shlex.split(line, comments=True) for line in text.splitlines()]
    return [words for words in lines if words]


def text_of(page: str) -> str:
    """A page of ``docs``, each run of white space one blank."""
    return one_line(source(page))


def one_line(text: str) -> str:
    """Each run of white space one blank."""
    return " ".join(text.split())


def absent(sentences: list[str], page: str) -> list[str]:
    """Those sentences that do not stand on a page of ``docs``, word for word."""
    text = text_of(page)
    return [s for s in sentences if one_line(s) not in text]


def other_pictures(folder: Path, by_processor: bool = False) -> list[str]:
    """Names of pictures in a folder that do not look like those of ``docs/pictures``, pixel by pixel.

    Args:
        folder: with the pictures.
        by_processor: the rig's exp and sin have other last digits on other processors, so that an outlier or a
            simulation more or less is drawn: a few pixels may be others.
    """
    made = sorted(folder.glob("*.png"))
    return [p.name for p in made if not _alike(p, DOCS / "pictures" / p.name, by_processor)]


def _alike(one: Path, other: Path, by_processor: bool) -> bool:
    """Whether no pixel differs by more than what the last digits of a line's points change at its edge."""
    if not other.exists():
        return False
    a, b = imread(one), imread(other)
    if a.shape != b.shape:
        return False
    off = np.abs(a - b)
    if not by_processor:
        return float(off.max()) < 0.05
    drawn, expected = colours(a), colours(b)
    same = np.abs(drawn - expected) <= np.maximum(_DRAWN * expected, _FEW)
    return float(off[..., :3].mean()) < _PIXELS and bool(same.all())


def colours(picture: NDArray[np.float32]) -> NDArray[np.int64]:
    """How many pixels have each hue, and how many are dark: light edges of a line have its hue."""
    hue, _, bright = np.moveaxis(rgb_to_hsv(picture[..., :3]), -1, 0)
    coloured = np.ptp(picture[..., :3], axis=-1) > 0.25
    hues = np.floor(hue[coloured] * _HUES + 0.5).astype(int) % _HUES
    dark = np.sum(~coloured & (bright < 0.5))
    return np.append(np.bincount(hues, minlength=_HUES), dark)


def quoted(page: str) -> list[str]:
    """Lines that a page of ``docs`` quotes from a program's output: of its text blocks, and verdicts within sentences.

    A line of three dots stands for what is left out.
    """
    lines = [line.strip() for block in blocks(page, "text") for line in block.splitlines()]
    verdicts = re.findall(r"`((?:identified|ambiguous|unknown): [^`]*)`", source(page))
    return [line for line in (*lines, *verdicts) if line and line != "..."]


def unsaid(page: str, output: str, by_processor: bool = False) -> list[str]:
    """What a page of ``docs`` quotes that does not stand in the output of its commands; ``by_processor``: as below."""
    said = one_line(output)
    lines = [(line, one_line(line)) for line in quoted(page)]
    return [
        q for q, line in lines if line not in said and not (by_processor and stands_in(line, said))
    ]


def stands_in(line: str, said: str, more: float = 0.0) -> bool:
    """Whether a line is said with the same words, and numbers that differ by ``_DIGITS`` at most; counts by ``more``.

    A count is a number that is written without a point.
    """
    words = [re.escape(part) for part in _NUMBER.split(line)]
    written = _NUMBER.findall(line)
    numbers = np.array([float(n) for n in written])
    slack = np.array([more if n.lstrip("-").isdigit() else 0.0 for n in written])
    for match in re.finditer(f"({_NUMBER.pattern})".join(words), said):
        found = np.array([float(n) for n in match.groups()])
        if np.all(np.abs(found - numbers) <= _DIGITS * np.abs(numbers) + slack):
            return True
    return False


def other_numbers(page: str, table: Mapping[str, Sequence[float]]) -> list[str]:
    """Rows of tables of a page of ``docs`` whose numbers are not those of a program, to the digits that are printed.

    Args:
        page: its name.
        table: the numbers of each row, by a word in backticks of its first cell.
    """
    wrong, found = [], set()
    for line in source(page).splitlines():
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
