"""A Modelica source text that knows where its characters are."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field
from pathlib import Path

from pam_cosim.errors import ModelError


@dataclass(eq=False, repr=False)
class SourceText:
    """One file, or text given directly (then ``file`` is only a label)."""

    file: Path | str
    text: str
    _line_starts: list[int] = field(default_factory=list, repr=False)

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column, both from 1, of a character offset."""
        if not self._line_starts:
            self._line_starts = [0]
            self._line_starts += [
                i + 1 for i, character in enumerate(self.text) if character == "\n"
            ]
        line = bisect_right(self._line_starts, offset)
        return line, offset - self._line_starts[line - 1] + 1

    def error(self, message: str, offset: int) -> ModelError:
        """The error to raise for something wrong at ``offset``."""
        line, column = self.position(offset)
        return ModelError(message, self.file, line, column)

    def line(self, offset: int) -> str:
        """The text of the line that holds ``offset``, without indentation."""
        number, _ = self.position(offset)
        start = self._line_starts[number - 1]
        end = self.text.find("\n", start)
        return self.text[start : end if end >= 0 else len(self.text)].strip()
