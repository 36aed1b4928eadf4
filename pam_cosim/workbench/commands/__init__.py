"""The commands of a page: each a function of the session and of what the command holds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pam_cosim.workbench.commands.files import add, load, save, script
from pam_cosim.workbench.commands.jobs import check, diagnose, discard, fit, resume, stop
from pam_cosim.workbench.commands.models import choose, switch, take, undo, where
from pam_cosim.workbench.commands.parameters import reset, set_values
from pam_cosim.workbench.commands.runs import begin, cut, roles

COMMANDS: dict[str, Callable[..., dict[str, Any] | None]] = {
    "add": add,
    "begin": begin,
    "check": check,
    "choose": choose,
    "cut": cut,
    "diagnose": diagnose,
    "discard": discard,
    "fit": fit,
    "load": load,
    "reset": reset,
    "resume": resume,
    "roles": roles,
    "save": save,
    "script": script,
    "set": set_values,
    "stop": stop,
    "switch": switch,
    "take": take,
    "undo": undo,
    "where": where,
}
"""By name."""
