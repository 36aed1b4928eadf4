"""Blind cases whose missing term has a known balance and known variables, of benches that simulate in no time."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Truth:
    """What is hidden in a case.

    Attributes:
        which, number: of the case.
        balance: in which it acts; "sensor": an instrument.
        variables: that its law is a function of, among those that a term in its balance has; none: of none of them.
    """

    which: str
    number: int
    balance: str
    variables: frozenset[str] = frozenset()


def _truth(which: str, number: int, balance: str, *variables: str) -> Truth:
    return Truth(which, number, balance, frozenset(variables))


CASES = (
    _truth("tuning3", 54, "energy", "T_excess"),  # convection in a tank
    _truth("tuning4", 54, "energy", "T_excess"),  # a film
    _truth("tuning3", 311, "energy", "T_excess"),
    _truth("tuning4", 53, "energy", "T_excess"),  # swirl in a vessel
    _truth("tuning3", 53, "energy", "T_excess"),
    _truth("tuning4", 69, "mass", "p_gauge"),  # a laminar leak
    _truth("tuning3", 271, "mass", "p_gauge"),  # an orifice
    _truth("tuning3", 121, "mass", "p_gauge"),  # a cold seal
    _truth("tuning3", 44, "mass", "p_gauge"),
    _truth("tuning4", 271, "mass"),  # a back pressure: of the command as well
    _truth("tuning4", 146, "mass"),  # a coiled line
    _truth("tuning4", 70, "mass"),  # a servo-assisted valve
    _truth("tuning3", 112, "mass"),  # a loose contact
    _truth("tuning3", 119, "force", "v"),  # viscous friction
    _truth("tuning4", 324, "force", "x"),  # a tube of rubber
    _truth("tuning3", 78, "force", "x"),  # the same by Ogden
    _truth("tuning4", 84, "force", "x", "p_gauge"),  # ends of another shape
    _truth("tuning3", 20, "sensor"),  # a manometer behind a snubber
    _truth("tuning3", 11, "sensor"),  # an offset
    _truth("tuning3", 236, "sensor"),  # two lags
    _truth("tuning4", 236, "sensor"),  # a gain
    _truth("tuning4", 254, "sensor"),  # a thermocouple that lags
)
"""Cases of ``blind_cases``; in all of them what is hidden is at least four standard deviations of the noise."""

SAME = (frozenset({"x", "eps"}), frozenset({"T", "T_excess"}))
"""Variables that say the same: a ratio or a difference to a constant."""
