"""Values that are written as a span: ``FROM:TO:N``, or ``FROM:TO``."""

from __future__ import annotations

import math

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.model.interface import Variable
from pam_cosim.model.settings import value_of

MOST_RUNS = 1_000_000


def values_in(text: str, name: str, variable: Variable, sampled: bool) -> list[float]:
    """The values [SI] of what is varied over a span.

    Args:
        text: ``FROM:TO:N``; ``FROM:TO`` where runs are ``sampled`` between two values.
        name, variable: what is varied.
        sampled: whether points are drawn between the lowest and the highest value.

    Raises:
        InputError: not of that form; as ``settings.value_of``.
    """
    word = f"{name}={text}"
    return _ends(text, word, variable) if sampled else _evenly(text, word, variable)


def _ends(text: str, word: str, variable: Variable) -> list[float]:
    """``FROM:TO``."""
    if text.count(":") != 1:
        raise InputError(f"'{word}': write FROM:TO, such as 1:10; the number of values is --runs")
    return [value_of(part, variable) for part in alike(text.split(":"), word)]


def _evenly(text: str, word: str, variable: Variable) -> list[float]:
    """``FROM:TO:N``."""
    parts = text.split(":")
    if len(parts) != 3 or not parts[2].strip().isdecimal() or int(parts[2]) < 1:
        raise InputError(f"'{word}': write FROM:TO:N, such as 1:10:5")
    if int(parts[2]) > MOST_RUNS:
        raise InputError(f"'{word}': a sweep has {MOST_RUNS} runs at most")
    low, high = (value_of(part, variable) for part in alike(parts[:2], word))
    if not math.isfinite(high - low):
        raise InputError(f"'{word}': its ends are too far apart")
    return [float(value) for value in np.linspace(low, high, int(parts[2]))]


def alike(texts: list[str], word: str) -> list[str]:
    """The same texts; "138, 207 kPa" would be 138 Pa and 207 kPa.

    Raises:
        InputError: one is empty, or some have a unit and some have none.
    """
    if not all(text.strip() for text in texts):
        raise InputError(f"'{word}': a value is missing")
    if len({_is_number(text) for text in texts}) > 1:
        raise InputError(
            f"'{word}': some of the values have a unit and some have none; write it with each of them"
        )
    return texts


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
