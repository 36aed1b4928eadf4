"""A controller in a user's own Python file, which the user names: no file of data brings code."""

from __future__ import annotations

import runpy
import traceback
from pathlib import Path

from pam_cosim.cosimulation.parts import Controller
from pam_cosim.errors import InputError
from pam_cosim.wording import did_you_mean


def controller_from(file: Path, name: str) -> Controller:
    """The controller of that name; runs the file.

    Raises:
        InputError: no such file, one that raises, or nothing of that name that is a controller.
    """
    if not file.is_file():
        raise InputError("there is no such file", file)
    try:
        content = runpy.run_path(str(file), run_name="pam_cosim_controller")
    except (Exception, SystemExit) as error:  # whatever a user's file raises
        places = [
            frame.lineno
            for frame in traceback.extract_tb(error.__traceback__)
            if frame.filename == str(file)
        ]
        line = error.lineno if isinstance(error, SyntaxError) else places[-1] if places else None
        raise InputError(f"{type(error).__name__}: {error}", file, line) from error
    controller_names = [key for key, value in content.items() if isinstance(value, Controller)]
    controller = content.get(name)
    if isinstance(controller, Controller):
        return controller
    if callable(controller):
        raise InputError(
            f"'{name}' is a function, but no controller; write @pam.controller(inputs=...) above it",
            file,
        )
    raise InputError(f"has no controller '{name}'; {did_you_mean(name, controller_names)}", file)
