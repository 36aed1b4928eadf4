"""A study of the workbench as a Python script and as commands that repeat it, step by step, to the same numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pam_cosim.model.references import is_modelica
from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.opened_model import without_ratios
from pam_cosim.workbench.state import State
from pam_cosim.workbench.steps import Step


@dataclass
class Place:
    """Where the steps have come to: the base model, its effects, and how the standing model is called.

    Attributes:
        held: values [SI] beside those of the file of a fit, ``fitted``.
    """

    base: str
    catalogue: Catalogue
    model: str = ""
    effects: tuple[str, ...] = ()
    diagnosed: tuple[str, ...] = ()
    roles: dict[str, str] = field(default_factory=dict)
    cuts: dict[str, list[float | None]] = field(default_factory=dict)
    starts: dict[str, str] = field(default_factory=dict)
    held: dict[str, float] = field(default_factory=dict)
    fitted: str = ""
    fits: int = 0
    diagnoses: int = 0

    def __post_init__(self) -> None:
        self.model = self.base

    def with_effects(self, effects: Sequence[str]) -> str | None:
        """Gives the model effects; the file that it is then written to, None where it is the base model."""
        self.effects, on = tuple(effects), without_ratios(effects)
        if not on:
            self.model = self.base
            return None
        self.model = f"{self.catalogue.composed(self.base, on).name}.mo"
        return self.model

    def take_runs(self, arguments: Mapping[str, Any]) -> None:
        """How runs are cut, and begin, from a step on."""
        self.cuts = arguments.get("cuts", self.cuts)
        self.starts = arguments["starts"]

    @property
    def files(self) -> list[str]:
        """The user's further Modelica files."""
        return [str(file) for file in self.catalogue.files]

    @property
    def further(self) -> tuple[str, ...]:
        """Modelica files that the standing model needs beside its own."""
        own = (self.base,) if self.model != self.base and is_modelica(self.base) else ()
        return (*self.files, *own)


# Python


def python_of(state: State, base: str, folder: Path, catalogue: Catalogue) -> str:
    """The study as a script, from the base model that it began with."""
    place = Place(base, catalogue)
    lines = [
        f"# {comment(state.data.title)}: what was done in the workbench, to be done again.",
        "import pam_cosim as pam",
        "",
        f"folder = {str(folder)!r}",
        f"files = {place.files!r}",
        _python_read(place),
        f"model = {place.base!r}",
        "values = {}",
        "comparison = pam.compare(data, model, values, files=files)",
    ]
    for step in state.steps:
        lines += ["", f"# {comment(step)}", *_python_step(step, place)]
    lines += ["", "print(comparison)"]
    return "\n".join(lines) + "\n"


_DIAGNOSED = (
    "time_limit",
    "exclude",
    "expect",
    "free",
    "start",
)  # what a step of a diagnosis may hold
_COMPARED = "comparison = pam.compare(data, model, values, files=files)"


def _python_step(step: Step, place: Place) -> list[str]:
    arguments = step.arguments
    match step.do:
        case "set" | "start":
            return [f"values |= {_numbers(arguments['values'])}", _COMPARED]
        case "switch":
            return [
                *_python_effects(arguments["effects"], place),
                f"values = {_numbers(arguments['values'])}",
                _COMPARED,
            ]
        case "choose":
            place.base = arguments["model"]
            return [*_python_effects((), place), _python_read(place), "values = {}", _COMPARED]
        case "roles":
            place.roles |= arguments["roles"]
            return [_python_read(place), _COMPARED]
        case "cut" | "begin":
            place.take_runs(arguments)
            return [_python_read(place), f"values = {_numbers(arguments['values'])}", _COMPARED]
        case "fit":
            options = f"method={arguments['method']!r}, free={arguments['free']!r}"
            options += f", start={_numbers(arguments['start'])}"
            return [
                f"fit = pam.fit(data, model, {options}, files=files)",
                f"values |= {_numbers(arguments['start'])} | fit.values",
                _COMPARED,
            ]
        case "diagnose":
            place.diagnosed = place.effects
            known = {
                name: arguments[name]
                for name in _DIAGNOSED
                if arguments.get(name) or arguments.get(name) == 0
            }
            options = "".join(f"{name}={_value(v)}, " for name, v in known.items())
            return [
                f"diagnosis = pam.diagnose(data, model, {options}files=files, say=print)",
                "print(diagnosis)",
            ]
        case "take":
            effects = tuple(arguments["effects"])
            return [
                f"candidate = next(c for c in diagnosis.candidates if c.effects == {effects!r})",
                *_python_effects((*place.diagnosed, *effects), place),
                f"values = {_numbers(arguments['kept'])} | candidate.fit.values",
                _COMPARED,
            ]
        case "add":
            return [
                f"pam.add({arguments['effects']!r}, to={place.base!r}, output={arguments['file']!r}, "
                f"values={_numbers(arguments.get('values', {}))}, files=files)"
            ]
    return []


def _python_read(place: Place) -> str:
    known = {"roles": place.roles, "cuts": place.cuts, "starts": place.starts}
    said = "".join(f", {name}={value!r}" for name, value in known.items() if value)
    return f"data = pam.read(folder, model={place.base!r}, files=files{said})"


def _python_effects(effects: Sequence[str], place: Place) -> list[str]:
    file = place.with_effects(effects)
    if file is None:
        return [f"model, files = {place.base!r}, {place.files!r}"]
    on = list(without_ratios(effects))
    return [
        f"files = {place.files!r}",
        f"pam.add({on!r}, to={place.base!r}, output={file!r}, files=files)",
        f"model, files = {file!r}, {list(place.further)!r}",
    ]


# commands


def _numbers(values: Mapping[str, float]) -> str:
    return "{" + ", ".join(f"{name!r}: {value!r}" for name, value in values.items()) + "}"


def _value(value: Any) -> str:
    return _numbers(value) if isinstance(value, Mapping) else repr(value)


def comment(text: object) -> str:
    """A text that stays in its line, whatever is in it."""
    return "".join(c if c.isprintable() else " " for c in str(text))
