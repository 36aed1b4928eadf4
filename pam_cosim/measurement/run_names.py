"""Values that are stated of runs by their names; a name with ``*`` is a pattern."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase
from typing import TypeVar

from pam_cosim.errors import InputError
from pam_cosim.wording import did_you_mean, shown

Value = TypeVar("Value")


def matches(run: str, name: str) -> bool:
    """Whether a run has this name, or one of this pattern."""
    return run == name or ("*" in name and fnmatchcase(run, name))


def patterns_first(stated: Mapping[str, Value]) -> list[tuple[str, Value]]:
    """What is stated, in the order in which a later value replaces an earlier one."""
    return sorted(stated.items(), key=lambda item: "*" not in str(item[0]))


def stated_of(run: str, stated: Mapping[str, Value]) -> Value | None:
    """The value of the run's own name, otherwise of the last pattern that its name matches."""
    values = [value for name, value in patterns_first(stated) if matches(run, str(name))]
    return values[-1] if values else None


def check_names(title: str, names: Iterable[str], runs: Sequence[str]) -> None:
    """Refuses a name or a pattern of no run.

    Raises:
        InputError: names the nearest run.
    """
    for name in map(str, names):
        if not any(matches(run, name) for run in runs):
            raise InputError(f"{title} has no run {shown(name)}; {did_you_mean(name, runs)}")
