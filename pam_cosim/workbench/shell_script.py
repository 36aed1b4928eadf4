"""What was done on the page as commands of a shell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from shlex import quote
from types import MappingProxyType
from typing import Any

from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.opened_model import without_ratios
from pam_cosim.workbench.script import Place, comment
from pam_cosim.workbench.state import State
from pam_cosim.workbench.steps import Step


def commands_of(state: State, base: str, folder: Path, catalogue: Catalogue) -> str:
    """The study as commands for a shell, from the base model that it began with."""
    place = Place(base, catalogue)
    data = quote(str(folder))
    lines = [
        "#!/bin/sh",
        f"# {comment(state.data.title)}: what was done in the workbench, to be done again.",
        "set -eu",
        _command("compare", data, place),
    ]
    for step in state.steps:
        lines += ["", f"# {comment(step)}", *_command_step(step, place, data)]
    return "\n".join(lines) + "\n"


def _command_step(step: Step, place: Place, data: str) -> list[str]:
    arguments = step.arguments
    match step.do:
        case "set" | "start":
            place.held |= arguments["values"]
            return [_compare(data, place)]
        case "switch":
            place.held, place.fitted = dict(arguments["values"]), ""
            return [*_command_effects(arguments["effects"], place), _compare(data, place)]
        case "choose":
            place.base, place.held, place.fitted = arguments["model"], {}, ""
            return [*_command_effects((), place), _compare(data, place)]
        case "roles":
            place.roles |= arguments["roles"]
            return [_compare(data, place)]
        case "cut" | "begin":
            place.take_runs(arguments)
            place.held, place.fitted = dict(arguments["values"]), ""
            return [_compare(data, place)]
        case "fit":
            place.fits += 1
            file = f"fit-{place.fits}.json"
            options = [
                f"--method {quote(arguments['method'])}",
                *_free_words(arguments),
                f"-o {file}",
            ]
            place.fitted = file
            place.held = {
                n: v
                for n, v in {**place.held, **arguments["start"]}.items()
                if n not in arguments["free"]
            }
            return [_command("fit", data, place, *options), _compare(data, place)]
        case "diagnose":
            place.diagnosed = place.effects
            place.diagnoses += 1
            words = [
                f"--{key} {quote(name)}"
                for key in ("exclude", "expect")
                for name in arguments.get(key, ())
            ]
            limit = (
                [f"--time-limit {quote(str(arguments['time_limit']))}"]
                if arguments.get("time_limit") is not None
                else []
            )
            report = f"--report diagnosis-{place.diagnoses}.html"
            return [
                _command("diagnose", data, place, *limit, *words, *_free_words(arguments), report)
            ]
        case "take":
            place.held, place.fitted = {**arguments["kept"], **arguments["values"]}, ""
            return [
                *_command_effects((*place.diagnosed, *arguments["effects"]), place),
                _compare(data, place),
            ]
        case "add":
            return [
                _add(arguments["effects"], arguments["file"], place, arguments.get("values", {}))
            ]
    return []


def _free_words(arguments: Mapping[str, Any]) -> list[str]:
    free = [f"--free {quote(name)}" for name in arguments.get("free", ())]
    return [
        *free,
        *(
            f"--start {quote(f'{name}={value!r}')}"
            for name, value in arguments.get("start", {}).items()
        ),
    ]


def _compare(data: str, place: Place) -> str:
    fitted = [f"--params {quote(place.fitted)}"] if place.fitted else []
    return _command(
        "compare",
        data,
        place,
        *fitted,
        *(f"--set {quote(f'{n}={v!r}')}" for n, v in place.held.items()),
    )


def _command(name: str, data: str, place: Place, *options: str) -> str:
    model = [f"--model {quote(place.model)}"]
    further = [f"--file {quote(file)}" for file in place.further]
    roles = [f"--role {quote(f'{run}={role}')}" for run, role in place.roles.items()]
    cuts = [
        f"--cut {quote(f'{run}={_moment(first)}:{_moment(last)}')}"
        for run, (first, last) in place.cuts.items()
    ]
    begins = [f"--begin {quote(f'{run}={mode}')}" for run, mode in place.starts.items()]
    return " ".join(["pam-cosim", name, data, *model, *further, *roles, *cuts, *begins, *options])


def _moment(time: float | None) -> str:
    return "" if time is None else repr(time)


def _add(
    effects: Sequence[str],
    file: str,
    place: Place,
    values: Mapping[str, float] = MappingProxyType({}),
) -> str:
    stated = [f"--set {quote(f'{name}={value!r}')}" for name, value in values.items()]
    further = [f"--file {quote(f)}" for f in place.files]
    words = [*map(quote, effects), f"--to {quote(place.base)}", f"-o {quote(file)}"]
    return " ".join(["pam-cosim add", *words, *stated, *further])


def _command_effects(effects: Sequence[str], place: Place) -> list[str]:
    file = place.with_effects(effects)
    return [] if file is None else [_add(without_ratios(effects), file, place)]
