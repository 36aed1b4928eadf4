"""A study of the workbench as a Python script that repeats it, step by step, to the same numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.standing import COMPOSING, READING, WITHOUT_SCORES, Standing, comment
from pam_cosim.workbench.state import State
from pam_cosim.workbench.steps import (
    ADD,
    BEGIN,
    CHOOSE,
    CUT,
    DIAGNOSE,
    FIT,
    SET,
    START,
    SWITCH,
    TAKE,
    Step,
)

_Arguments = Mapping[str, Any]
_COMPARED = "comparison = pam.compare(data, model, values, files=files)"
_DIAGNOSED = (
    "time_limit",
    "exclude",
    "expect",
    "free",
    "start",
)  # what may be stated of a diagnosis


def python_of(state: State, base: str, folder: Path, catalogue: Catalogue) -> str:
    """The study as a script, from the base model that it began with."""
    standing = Standing(base, catalogue)
    lines = [
        f"# {comment(state.data.title)}: what was done in the workbench, to be done again.",
        "import pam_cosim as pam",
        "",
        f"folder = {str(folder)!r}",
        f"files = {standing.files!r}",
        _read(standing),
        f"model = {base!r}",
        "values = {}",
        _COMPARED,
    ]
    for step in state.steps:
        standing.advance(step)
        lines += ["", f"# {comment(step)}", *_lines(step, standing)]
    return "\n".join([*lines, "", "print(comparison)", ""])


def _lines(step: Step, standing: Standing) -> list[str]:
    own = _OWN.get(step.do)
    values = _VALUES.get(step.do)
    lines = [] if own is None else own(step.arguments, standing)
    if step.do in COMPOSING:
        lines += _compose(standing)
    if step.do in READING:
        lines.append(_read(standing))
    if values is not None:
        lines.append(values(step.arguments))
    return lines if step.do in WITHOUT_SCORES else [*lines, _COMPARED]


def _fit(arguments: _Arguments, standing: Standing) -> list[str]:
    options = f"method={arguments['method']!r}, free={arguments['free']!r}"
    start = _numbers(arguments["start"])
    return [f"fit = pam.fit(data, model, {options}, start={start}, files=files)"]


def _diagnose(arguments: _Arguments, standing: Standing) -> list[str]:
    stated = {n: arguments[n] for n in _DIAGNOSED if arguments.get(n) or arguments.get(n) == 0}
    options = "".join(
        f"{name}={_numbers(value) if isinstance(value, Mapping) else repr(value)}, "
        for name, value in stated.items()
    )
    return [
        f"diagnosis = pam.diagnose(data, model, {options}files=files, say=print)",
        "print(diagnosis)",
    ]


def _choose_candidate(arguments: _Arguments, standing: Standing) -> list[str]:
    effects = tuple(arguments["effects"])
    return [f"candidate = next(c for c in diagnosis.candidates if c.effects == {effects!r})"]


def _add(arguments: _Arguments, standing: Standing) -> list[str]:
    return [
        f"pam.add({arguments['effects']!r}, to={standing.base!r}, output={arguments['file']!r}, "
        f"values={_numbers(arguments.get('values', {}))}, files=files)"
    ]


_OWN: Mapping[str, Callable[[_Arguments, Standing], list[str]]] = {
    FIT: _fit,
    DIAGNOSE: _diagnose,
    TAKE: _choose_candidate,
    ADD: _add,
}
"""Lines that only a step of one kind has."""


def _replaced(arguments: _Arguments) -> str:
    return f"values = {_numbers(arguments['values'])}"


def _updated(arguments: _Arguments) -> str:
    return f"values |= {_numbers(arguments['values'])}"


def _fitted(arguments: _Arguments) -> str:
    stated = f"{_numbers(arguments['start'])} | fit.values"
    if "kept" in arguments:
        return f"values = {_numbers(arguments['kept'])} | {stated}"
    return f"values |= {stated}"


_VALUES: Mapping[str, Callable[[_Arguments], str]] = {
    SET: _updated,
    START: _updated,
    SWITCH: _replaced,
    CUT: _replaced,
    BEGIN: _replaced,
    CHOOSE: lambda _: "values = {}",
    FIT: _fitted,
    TAKE: lambda a: f"values = {_numbers(a['kept'])} | candidate.fit.values",
}
"""The values after a step of a kind, where it changes them."""


def _read(standing: Standing) -> str:
    stated = {"roles": standing.roles, "cuts": standing.cuts, "starts": standing.starts}
    options = "".join(f", {name}={value!r}" for name, value in stated.items() if value)
    return f"data = pam.read(folder, model={standing.base!r}, files=files{options})"


def _compose(standing: Standing) -> list[str]:
    base, model, effects = standing.base, standing.model, list(standing.composed_effects)
    if not effects:
        return [f"model, files = {base!r}, {standing.files!r}"]
    return [
        f"files = {standing.files!r}",
        f"pam.add({effects!r}, to={base!r}, output={model!r}, files=files)",
        f"model, files = {model!r}, {list(standing.further)!r}",
    ]


def _numbers(values: Mapping[str, float]) -> str:
    return "{" + ", ".join(f"{name!r}: {value!r}" for name, value in values.items()) + "}"
