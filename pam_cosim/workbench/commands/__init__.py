"""The commands of a page: each a function of the study and of what the command holds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pam_cosim.workbench.commands.choices import begin, cut, free, roles, signal
from pam_cosim.workbench.commands.files import add, load, save, script
from pam_cosim.workbench.commands.jobs import check, diagnose, fit
from pam_cosim.workbench.commands.models import choose, switch, take, undo
from pam_cosim.workbench.commands.parameters import reset, set_values
from pam_cosim.workbench.job_queue import StudyWithJobs

_FUNCTIONS: tuple[Callable[..., Any], ...] = (
    add, begin, check, choose, cut, diagnose, fit, free, load, reset, roles, save, script, signal, switch, take, undo,
    StudyWithJobs.stop, StudyWithJobs.resume, StudyWithJobs.discard, StudyWithJobs.samples,
)  # fmt: skip
COMMANDS = dict(
    sorted([("set", set_values), *((function.__name__, function) for function in _FUNCTIONS)])
)
"""By name."""
