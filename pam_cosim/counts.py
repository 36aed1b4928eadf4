"""Counts and time limits that a user states: the maximum of each, and the message beyond it."""

from __future__ import annotations

import math

from pam_cosim.errors import InputError

MOST_WORKERS = 1000
MOST_STARTS = 10_000
MOST_SIMULATIONS = 10**12
MOST_SAMPLES = 10_000  # each is simulated, and its signals are kept
LARGEST_SEED = 2**63 - 1
LONGEST = 1e9  # s, some thirty years; beyond that it is no limit


def checked(value: int | None, what: str, least: int, most: int) -> int | None:
    """A count within bounds; None: the default.

    Raises:
        InputError: it is no whole number, or beyond the bounds.
    """
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        raise InputError(
            f"{what} must be a whole number from {least} to {most}, not {str(value)[:30]}"
        )
    return value


def checked_workers(value: int | None, least: int = 0) -> int | None:
    """A number of processes.

    Raises:
        InputError: as ``checked``.
    """
    return checked(value, "the number of workers", least, MOST_WORKERS)


def checked_starts(value: int) -> int:
    """A number of points at which a fit begins.

    Raises:
        InputError: as ``checked``.
    """
    return checked(value, "the number of starts", 0, MOST_STARTS) or 0


def checked_simulations(value: int | None) -> int | None:
    """A number of simulated runs after which a search ends.

    Raises:
        InputError: as ``checked``.
    """
    return checked(value, "the limit of simulations", 1, MOST_SIMULATIONS)


def checked_samples(value: int) -> int:
    """A number of samples of parameters.

    Raises:
        InputError: as ``checked``.
    """
    return checked(value, "the number of samples", 2, MOST_SAMPLES) or 0


def checked_seed(value: int) -> int:
    """The seed of random numbers.

    Raises:
        InputError: as ``checked``.
    """
    return checked(value, "the seed", 0, LARGEST_SEED) or 0


def checked_time(value: float) -> float:
    """A time limit [s]; a limit of more than a lifetime is none.

    Raises:
        InputError: it is not longer than nothing.
    """
    if not value > 0:
        raise InputError(f"a time limit must be larger than zero, not {value:g} s")
    return value if value <= LONGEST else math.inf
