"""Names that were public once and have another name now: the old one answers with the new one until it goes.

What is promised about them is in ``docs/versions.md``.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Renaming:
    """A public name that changed.

    Attributes:
        new: the name now.
        since: version in which the old one began to warn.
        until: version in which it is gone.
    """

    new: str
    since: str
    until: str

    def message(self, old: str) -> str:
        """What the old name answers."""
        return (
            f"{old} is called {self.new} since {self.since}; the old name is gone in {self.until}"
        )


PYTHON: dict[str, Renaming] = {}
"""Names of ``pam_cosim`` itself, by the old name."""

COMMANDS: dict[str, Renaming] = {}
"""Commands, by the old name."""

OPTIONS: dict[str, Renaming] = {
    "simulate --output VARIABLE": Renaming("--keep VARIABLE", "0.2.0", "0.4.0"),
    "sweep --output VARIABLE": Renaming("--keep VARIABLE", "0.2.0", "0.4.0"),
    "couple --observe VARIABLE": Renaming("--keep VARIABLE", "0.2.0", "0.4.0"),
}
"""Options, by the command and the old name."""
