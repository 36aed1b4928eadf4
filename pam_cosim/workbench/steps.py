"""What a person did, step by step: data that can be saved, repeated and printed."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from pam_cosim.workbench.saved import checked_step

SET, SWITCH, CHOOSE, FIT, DIAGNOSE, TAKE, ADD, ROLES_STEP = (
    "set",
    "switch",
    "choose",
    "fit",
    "diagnose",
    "take",
    "add",
    "roles",
)
CUT, BEGIN, START = "cut", "begin", "start"


@dataclass(frozen=True)
class Step:
    """One thing that was done, with all that it takes to do it again.

    Attributes:
        do: what.
        arguments: plain data: names, and values [SI] by name.
    """

    do: str
    arguments: Mapping[str, Any] = field(default_factory=dict)

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON."""
        return {"do": self.do, **self.arguments}

    def __str__(self) -> str:
        text = _TEXTS.get(self.do)
        return text(self.arguments) if text is not None else self.do


_Arguments = Mapping[str, Any]


def _with_effects(arguments: _Arguments) -> str:
    return f"with {_sum(arguments)}" if arguments["effects"] else "without effects"


def _new_roles(arguments: _Arguments) -> str:
    return "roles: " + ", ".join(f"{run} {role}" for run, role in arguments["roles"].items())


def _new_cut(arguments: _Arguments) -> str:
    run = arguments["run"]
    return f"cut {run}: {_ends(*arguments['cuts'][run])}"


def _new_beginning(arguments: _Arguments) -> str:
    mode = arguments["starts"].get(arguments["run"])
    return f"begin {arguments['run']}: {mode or 'as the data set says'}"


def _sum(arguments: _Arguments) -> str:
    return " + ".join(arguments["effects"])


def _numbers(values: Mapping[str, float]) -> str:
    return ", ".join(f"{name} = {value:.4g}" for name, value in values.items())


# How a step reads; one that is not here reads as its name.
_TEXTS: Mapping[str, Callable[[_Arguments], str]] = {
    SET: lambda a: f"set {_numbers(a['values'])}",
    SWITCH: _with_effects,
    CHOOSE: lambda a: f"model {a['model']}",
    FIT: lambda a: f"fit ({a['method']}): {', '.join(a['free'])}",
    TAKE: lambda a: f"took {_sum(a)} from the ranking",
    ADD: lambda a: f"added {_sum(a)}: {a['file']}",
    ROLES_STEP: _new_roles,
    CUT: _new_cut,
    BEGIN: _new_beginning,
    START: lambda a: f"start {_numbers({name: a['values'][name] for name in a['moved']})}",
}


def _ends(begin: float | None, end: float | None) -> str:
    if begin is None and end is None:
        return "all of it"
    first = "its beginning" if begin is None else f"{begin:.13g} s"
    last = "its end" if end is None else f"{end:.13g} s"
    return f"{first} to {last}"


def step_of(content: Any) -> Step:
    """A step from plain data.

    Raises:
        ValueError: it is none; names what is wrong.
    """
    checked = checked_step(content)
    return Step(checked.pop("do"), checked)


def with_step(steps: Sequence[Step], step: Step, closed: int = 0) -> tuple[Step, ...]:
    """The steps and one more; values set one after another are one step, but for the first ``closed`` steps."""
    last = steps[-1] if len(steps) > closed else None
    if last is not None and step.do == last.do == SET:
        merged = {**last.arguments["values"], **step.arguments["values"]}
        return (*steps[:-1], Step(SET, {"values": merged}))
    if last is not None and step.do == last.do == START:
        values = {**last.arguments["values"], **step.arguments["values"]}
        moved = [*dict.fromkeys([*last.arguments["moved"], *step.arguments["moved"]])]
        return (*steps[:-1], Step(START, {"values": values, "moved": moved}))
    if last is not None and step.do == last.do == SWITCH:
        return (*steps[:-1], step)
    return (*steps, step)
