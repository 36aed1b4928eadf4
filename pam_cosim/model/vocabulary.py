"""How people of a field call what they record. It is data of a Modelica library; here is its form."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Vocabulary:
    """Words are in small letters without accents; one with ``=`` stands alone, others also within a longer word.

    Attributes:
        kinds: rows of a quantity, its SI unit, traits and words.
        roles: rows of what distinguishes a quantity from others of its kind, the kind that its word means alone, and
            words.
        units: rows of a kind and the units of numbers without one, each with the largest number that has it.
        spellings: rows of a unit as the registry of units has it, and other spellings of it.
        counts: spellings of units of a converter, a camera or a bridge, whose size only the laboratory knows.
        sure: rows of a kind and words that leave no doubt of it.
        directions: rows of "down" or "up", and words.
        data_sheets: rows of a parameter, the units of what data sheets state and of the input, what an input of one
            opens, and the input at which it begins to open.
        nominal: rows of a unit that data sheets have instead, the unit that is meant, and the factor.
        calibrated: words in descriptions of parameters that a fit determines.
        uncertain: likewise, of those that may be free in addition.
        chosen: likewise, of those that are neither stated nor fitted.
        walls: likewise, of what the wall of a muscle takes of its pull; ``fibres``: of where the fibres of a wall lie.
        measures: rows of a measure of a sleeve, the length first, and whether it is one "around" the sleeve; three,
            one of them around, determine it.
        neutral: rows of a parameter and its value where the user names no part that has it.
    """

    kinds: tuple[tuple[str, str, str, str], ...] = ()
    roles: tuple[tuple[str, str, str], ...] = ()
    units: tuple[tuple[str, str], ...] = ()
    spellings: tuple[tuple[str, str], ...] = ()
    counts: tuple[str, ...] = ()
    sure: tuple[tuple[str, str], ...] = ()
    directions: tuple[tuple[str, str], ...] = ()
    data_sheets: tuple[tuple[str, str, str, str, str], ...] = ()
    nominal: tuple[tuple[str, str, str], ...] = ()
    calibrated: tuple[str, ...] = ()
    uncertain: tuple[str, ...] = ()
    chosen: tuple[str, ...] = ()
    walls: tuple[str, ...] = ()
    fibres: tuple[str, ...] = ()
    measures: tuple[tuple[str, str], ...] = ()
    neutral: tuple[tuple[str, str], ...] = ()
