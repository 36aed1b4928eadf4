"""What a person did, step by step: data that can be saved, repeated and printed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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
        arguments = self.arguments
        match self.do:
            case "set":
                return "set " + ", ".join(
                    f"{name} = {value:.4g}" for name, value in arguments["values"].items()
                )
            case "switch":
                return (
                    "with " + " + ".join(arguments["effects"])
                    if arguments["effects"]
                    else "without effects"
                )
            case "choose":
                return f"model {arguments['model']}"
            case "fit":
                return f"fit ({arguments['method']}): {', '.join(arguments['free'])}"
            case "take":
                return f"took {' + '.join(arguments['effects'])} from the ranking"
            case "add":
                return f"added {' + '.join(arguments['effects'])}: {arguments['file']}"
            case "roles":
                return "roles: " + ", ".join(
                    f"{run} {role}" for run, role in arguments["roles"].items()
                )
            case "cut":
                return f"cut {arguments['run']}: {_ends(*arguments['cuts'][arguments['run']])}"
            case "begin":
                mode = arguments["starts"].get(arguments["run"])
                return f"begin {arguments['run']}: {mode or 'as the data set says'}"
            case "start":
                return "start " + ", ".join(
                    f"{name} = {arguments['values'][name]:.4g}" for name in arguments["moved"]
                )
        return self.do


def _ends(begin: float | None, end: float | None) -> str:
    if begin is None and end is None:
        return "all of it"
    first = "its beginning" if begin is None else f"{begin:g} s"
    last = "its end" if end is None else f"{end:g} s"
    return f"{first} to {last}"


def step_of(content: Any) -> Step:
    """A step from plain data.

    Raises:
        ValueError: it is none; names what is wrong.
    """
    checked = checked_step(content)
    return Step(checked.pop("do"), checked)


def with_step(steps: Sequence[Step], step: Step) -> tuple[Step, ...]:
    """The steps and one more; values set one after another are one step."""
    last = steps[-1] if steps else None
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
