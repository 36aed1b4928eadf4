"""A study of the workbench as commands of a shell that repeat it, step by step, to the same numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from shlex import quote
from typing import Any

from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.standing import COMPOSING, WITHOUT_SCORES, Standing, comment
from pam_cosim.workbench.state import State
from pam_cosim.workbench.steps import ADD, DIAGNOSE, FIT, Step


def commands_of(state: State, base: str, folder: Path, catalogue: Catalogue) -> str:
    """The study as commands for a shell, from the base model that it began with."""
    standing = Standing(base, catalogue)
    data = quote(str(folder))
    lines = [
        "#!/bin/sh",
        f"# {comment(state.data.title)}: what was done in the workbench, to be done again.",
        "set -eu",
        _compare(data, standing),
    ]
    for step in state.steps:
        standing.advance(step)
        lines += ["", f"# {comment(step)}", *_commands(step, standing, data)]
    return "\n".join([*lines, ""])


def _commands(step: Step, standing: Standing, data: str) -> list[str]:
    arguments, commands = step.arguments, []
    if step.do == FIT:
        commands.append(_fit(arguments, standing, data))
    if step.do == DIAGNOSE:
        commands.append(_diagnose(arguments, standing, data))
    if step.do == ADD:
        stated = arguments.get("values", {})
        commands.append(_add(arguments["effects"], arguments["file"], standing, stated))
    if step.do in COMPOSING and standing.composed_effects:
        commands.append(_add(standing.composed_effects, standing.model, standing, {}))
    return commands if step.do in WITHOUT_SCORES else [*commands, _compare(data, standing)]


def _fit(arguments: Mapping[str, Any], standing: Standing, data: str) -> str:
    method = f"--method {quote(arguments['method'])}"
    output = f"-o {_file_of_fit(standing)}"
    return _command("fit", data, standing, method, *_free(arguments), output)


def _diagnose(arguments: Mapping[str, Any], standing: Standing, data: str) -> str:
    limit = arguments.get("time_limit")
    limits = [] if limit is None else [f"--time-limit {quote(str(limit))}"]
    families = [
        *_repeated("exclude", arguments.get("exclude", ())),
        *_repeated("expect", arguments.get("expect", ())),
    ]
    report = f"--report diagnosis-{standing.diagnoses}.html"
    return _command("diagnose", data, standing, *limits, *families, *_free(arguments), report)


def _free(arguments: Mapping[str, Any]) -> list[str]:
    start = _assignments("start", arguments.get("start", {}))
    return [*_repeated("free", arguments.get("free", ())), *start]


def _compare(data: str, standing: Standing) -> str:
    fitted = [f"--params {_file_of_fit(standing)}"] if standing.fitted else []
    return _command("compare", data, standing, *fitted, *_assignments("set", standing.values))


def _file_of_fit(standing: Standing) -> str:
    return f"fit-{standing.fits}.json"


def _command(name: str, data: str, standing: Standing, *options: str) -> str:
    cuts = {
        run: f"{_moment(first)}:{_moment(last)}" for run, (first, last) in standing.cuts.items()
    }
    about_data = [
        *_repeated("role", (f"{run}={role}" for run, role in standing.roles.items())),
        *_repeated("cut", (f"{run}={cut}" for run, cut in cuts.items())),
        *_repeated("begin", (f"{run}={mode}" for run, mode in standing.starts.items())),
    ]
    about_model = [f"--model {quote(standing.model)}", *_repeated("file", standing.further)]
    return " ".join(["pam-cosim", name, data, *about_model, *about_data, *options])


def _add(effects: Sequence[str], file: str, standing: Standing, values: Mapping[str, float]) -> str:
    words = [*map(quote, effects), f"--to {quote(standing.base)}", f"-o {quote(file)}"]
    further = _repeated("file", standing.files)
    return " ".join(["pam-cosim add", *words, *_assignments("set", values), *further])


def _assignments(option: str, values: Mapping[str, float]) -> list[str]:
    return _repeated(option, (f"{name}={value!r}" for name, value in values.items()))


def _repeated(option: str, words: Iterable[str]) -> list[str]:
    return [f"--{option} {quote(word)}" for word in words]


def _moment(time: float | None) -> str:
    return "" if time is None else repr(time)
