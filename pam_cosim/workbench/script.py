"""A study of the workbench as a Python script that repeats it, step by step, to the same numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pam_cosim.model.references import is_modelica
from pam_cosim.wording import printable
from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.opened_model import without_ratios
from pam_cosim.workbench.source import OF_RUNS
from pam_cosim.workbench.state import State
from pam_cosim.workbench.steps import Step

_COMPARED = "comparison = pam.compare(data, model, values, files=files)"


def python_of(state: State, base: str, folder: Path, catalogue: Catalogue) -> str:
    """The study as a script, from the base model that it began with."""
    script = _Script(base, catalogue)
    lines = [
        f"# {printable(state.data.title)}: what was done in the workbench, to be done again.",
        "import pam_cosim as pam",
        "",
        f"folder = {str(folder)!r}",
        f"files = {script.files!r}",
        script.reading(),
        f"model = {base!r}",
        "values = {}",
        _COMPARED,
    ]
    for step in state.steps:
        lines += ["", f"# {printable(str(step))}", *script.lines(step)]
    return "\n".join([*lines, "", "print(comparison)", ""])


@dataclass
class _Script:
    """The lines of each step, and the state of the study that the next lines depend on."""

    base: str
    catalogue: Catalogue
    effects: tuple[str, ...] = ()
    diagnosed: tuple[str, ...] = ()
    chosen: Mapping[str, Any] = field(default_factory=dict)

    @property
    def files(self) -> list[str]:
        """The user's further Modelica files."""
        return [str(file) for file in self.catalogue.files]

    def lines(self, step: Step) -> list[str]:
        """The lines of a step."""
        a = step.arguments
        lines: list[str] = []
        match step.do:
            case "set" | "start":
                lines = [f"values |= {_numbers(a['values'])}"]
            case "switch":
                lines = [*self._composing(a["effects"]), f"values = {_numbers(a['values'])}"]
            case "choose":
                self.base = a["model"]
                self.chosen = {key: self.chosen[key] for key in OF_RUNS if key in self.chosen}
                lines = [*self._composing(()), self.reading(), "values = {}"]
            case "fit":
                options = f"method={a['method']!r}, free={a['free']!r}, {_stated(a, 'start')}"
                assignment = f"= {_numbers(a['kept'])} |" if "kept" in a else "|="
                lines = [
                    f"fit = pam.fit(data, model, {options}files=files)",
                    f"values {assignment} {_numbers(a['start'])} | fit.values",
                ]
            case "diagnose":
                self.diagnosed = self.effects
                options = _stated(a, *(name for name in _DIAGNOSED if a.get(name)))
                return [
                    f"diagnosis = pam.diagnose(data, model, {options}files=files, say=print)",
                    "print(diagnosis)",
                ]
            case "take":
                effects = tuple(a["effects"])
                lines = [
                    f"candidate = next(c for c in diagnosis.candidates if c.effects == {effects!r})",
                    *self._composing((*self.diagnosed, *effects)),
                    f"values = {_numbers(a['kept'])} | candidate.fit.values",
                ]
            case "add":
                values = _numbers(a.get("values", {}))
                return [
                    f"pam.add({a['effects']!r}, to={self.base!r}, output={a['file']!r}, "
                    f"values={values}, files=files)"
                ]
        if "chosen" in a:
            self.chosen = a["chosen"]
            lines = [self.reading(), f"values = {_numbers(a['values'])}"]
        return [*lines, _COMPARED]

    def reading(self) -> str:
        """The lines that read the data set."""
        statements = {n: value for n, value in self.chosen.items() if value or n == "free"}
        options = "".join(
            f", {name}={statements[name]!r}" for name in OF_RUNS if name in statements
        )
        lines = [f"data = pam.read(folder, model={self.base!r}, files=files{options})"]
        if "signals" in statements:
            lines.append(f"data = data.with_signals({statements['signals']!r})")
        stated: dict[str, Any] = {
            name: statements[name] for name in ("values", "free") if name in statements
        }
        if stated:
            lines.append(
                f"data = pam.problem(data, {self.base!r}, {_stated(stated, *stated)}files=files).data"
            )
        return "\n".join(lines)

    def _composing(self, effects: Sequence[str]) -> list[str]:
        self.effects = tuple(effects)
        on, base = list(without_ratios(effects)), self.base
        if not on:
            return [f"model, files = {base!r}, {self.files!r}"]
        model = f"{self.catalogue.composed(base, on).name}.mo"
        file_names = [*self.files, *([base] if is_modelica(base) else [])]
        return [
            f"files = {self.files!r}",
            f"pam.add({on!r}, to={base!r}, output={model!r}, files=files)",
            f"model, files = {model!r}, {file_names!r}",
        ]


_DIAGNOSED = ("time_limit", "exclude", "expect", "free", "start")  # if they were stated


def _stated(arguments: Mapping[str, Any], *names: str) -> str:
    options = ((name, arguments[name]) for name in names)
    return "".join(
        f"{name}={_numbers(value) if isinstance(value, Mapping) else repr(value)}, "
        for name, value in options
    )


def _numbers(values: Mapping[str, float]) -> str:
    return "{" + ", ".join(f"{name!r}: {value!r}" for name, value in values.items()) + "}"
