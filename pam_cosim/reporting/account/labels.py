"""Short names that distinguish models."""

from __future__ import annotations

from pam_cosim.model.references import is_file


def short_model(name: str) -> str:
    """The last part of a qualified class name."""
    last = name.rsplit("/", 1)[-1]
    return last if is_file(name) else last.rsplit(".", 1)[-1]
