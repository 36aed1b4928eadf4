"""Where the steps of a study have come to: the model, the runs and the values with which the next command works."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from pam_cosim.model.references import is_modelica
from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.opened_model import without_ratios
from pam_cosim.workbench.steps import (
    ADD,
    BEGIN,
    CHOOSE,
    CUT,
    DIAGNOSE,
    ROLES_STEP,
    SWITCH,
    TAKE,
    Step,
)

COMPOSING = (SWITCH, CHOOSE, TAKE)  # steps after which the model has other effects
READING = (CHOOSE, ROLES_STEP, CUT, BEGIN)  # after which the data set is read anew
WITHOUT_SCORES = (DIAGNOSE, ADD)  # after which the scores are what they were


@dataclass
class Standing:
    """Changes with each step, in place.

    Attributes:
        base: the base model.
        catalogue: of effects.
        model: the name of the standing model: the base model, or a Modelica file.
        effects: of the standing model.
        diagnosed: effects of the model that the last diagnosis began with.
        roles, cuts, starts: of runs, by name, where they are not as in the data set.
        values: [SI], beside those of the last fit.
        fits, diagnoses: how many there were.
        fitted: whether the values of the last fit are those of the standing model.
    """

    base: str
    catalogue: Catalogue
    model: str = ""
    effects: tuple[str, ...] = ()
    diagnosed: tuple[str, ...] = ()
    roles: dict[str, str] = field(default_factory=dict)
    cuts: dict[str, list[float | None]] = field(default_factory=dict)
    starts: dict[str, str] = field(default_factory=dict)
    values: dict[str, float] = field(default_factory=dict)
    fits: int = 0
    diagnoses: int = 0
    fitted: bool = False

    def __post_init__(self) -> None:
        self.model = self.base

    def advance(self, step: Step) -> None:
        """Takes a step."""
        arguments = step.arguments
        match step.do:
            case "set" | "start":
                self.values |= arguments["values"]
            case "switch":
                self._compose(arguments["effects"])
                self._replace_values(arguments["values"])
            case "choose":
                self.base = arguments["model"]
                self._compose(())
                self._replace_values({})
            case "roles":
                self.roles |= arguments["roles"]
            case "cut" | "begin":
                self.cuts, self.starts = arguments.get("cuts", self.cuts), arguments["starts"]
                self._replace_values(arguments["values"])
            case "fit":
                self._fit(arguments)
            case "diagnose":
                self.diagnosed = self.effects
                self.diagnoses += 1
            case "take":
                self._compose((*self.diagnosed, *arguments["effects"]))
                self._replace_values({**arguments["kept"], **arguments["values"]})

    def _compose(self, effects: Sequence[str]) -> None:
        self.effects = tuple(effects)
        on = self.composed_effects
        self.model = f"{self.catalogue.composed(self.base, on).name}.mo" if on else self.base

    def _replace_values(self, values: Mapping[str, float]) -> None:
        self.values, self.fitted = dict(values), False

    def _fit(self, arguments: Mapping[str, Any]) -> None:
        self.fits += 1
        self.fitted = True
        known = arguments.get("kept", self.values) | arguments["start"]
        self.values = {n: v for n, v in known.items() if n not in arguments["free"]}

    @property
    def composed_effects(self) -> tuple[str, ...]:
        """Effects that are written into a Modelica file; none: the model is the base model."""
        return without_ratios(self.effects)

    @property
    def files(self) -> list[str]:
        """The user's further Modelica files."""
        return [str(file) for file in self.catalogue.files]

    @property
    def further(self) -> tuple[str, ...]:
        """Modelica files that the standing model needs beside its own."""
        own = (self.base,) if self.model != self.base and is_modelica(self.base) else ()
        return (*self.files, *own)


def comment(text: object) -> str:
    """A text that stays in its line, whatever is in it."""
    return "".join(c if c.isprintable() else " " for c in str(text))
