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
        return str(a.get("text", self.do))


def _sum(arguments: Mapping[str, Any]) -> str:
    return " + ".join(arguments["effects"])


def _numbers(values: Mapping[str, float]) -> str:
    return ", ".join(f"{name} = {value:.4g}" for name, value in values.items())


def with_step(steps: Sequence[Step], step: Step, closed: int = 0) -> tuple[Step, ...]:
    """The steps and one more; values of the same names that are dragged are one step, but for the first ``closed``."""
    last = steps[-1] if len(steps) > closed else step
    arguments, names = last.arguments, step.arguments.get("moved", step.arguments.get("values", ()))
    dragged = step.arguments.get("dragged") and arguments.get("dragged") and last is not step
    if dragged and {*arguments.get("moved", arguments["values"])} == {*names}:
        return (*steps[:-1], step)
    return (*steps, step)
