"""The steps of a study: data that can be saved, repeated and printed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Step:
    """One thing that was done, with all that it takes to do it again.

    Attributes:
        do: the kind, as in ``saved.AnyStep``.
        arguments: plain data: names, and values [SI] by name.
    """

    do: str
    arguments: Mapping[str, Any] = field(default_factory=dict)

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON."""
        return {"do": self.do, **self.arguments}

    def __str__(self) -> str:
        a = self.arguments
        match self.do:
            case "set":
                return f"set {_numbers(a['values'])}"
            case "start":
                return f"start {_numbers({name: a['values'][name] for name in a['moved']})}"
            case "switch":
                return f"with {_sum(a)}" if a["effects"] else "without effects"
            case "choose":
                return f"model {a['model']}"
            case "fit":
                return f"fit ({a['method']}): {', '.join(a['free'])}"
            case "take":
                return f"took {_sum(a)} from the ranking"
            case "add":
                return f"added {_sum(a)}: {a['file']}"
            case "roles":
                return "roles: " + ", ".join(f"{run} {role}" for run, role in a["roles"].items())
            case "cut":
                return f"cut {a['run']}: {_ends(*a['cuts'][a['run']])}"
            case "begin":
                return f"begin {a['run']}: {a['starts'].get(a['run']) or 'as the data set says'}"
        return self.do


def _sum(arguments: Mapping[str, Any]) -> str:
    return " + ".join(arguments["effects"])


def _numbers(values: Mapping[str, float]) -> str:
    return ", ".join(f"{name} = {value:.4g}" for name, value in values.items())


def _ends(begin: float | None, end: float | None) -> str:
    if begin is None and end is None:
        return "all of it"
    first = "its beginning" if begin is None else f"{begin:.13g} s"
    last = "its end" if end is None else f"{end:.13g} s"
    return f"{first} to {last}"


def with_step(steps: Sequence[Step], step: Step, closed: int = 0) -> tuple[Step, ...]:
    """The steps and one more; values set one after another are one step, but for the first ``closed`` steps."""
    last = steps[-1] if len(steps) > closed else None
    if last is None or step.do != last.do or step.do not in ("set", "start", "switch"):
        return (*steps, step)
    arguments = dict(step.arguments)
    if step.do != "switch":
        arguments["values"] = {**last.arguments["values"], **arguments["values"]}
    if step.do == "start":
        arguments["moved"] = [*dict.fromkeys([*last.arguments["moved"], *arguments["moved"]])]
    return (*steps[:-1], Step(step.do, arguments))
