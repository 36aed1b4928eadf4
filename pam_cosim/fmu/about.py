"""Who made the model of an FMU, under which licence, and when the FMU was made."""

from __future__ import annotations

import os
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, metadata

from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu.read import TOOL
from pam_cosim.resources import modelica_root


def identity(ode: Ode) -> dict[str, str]:
    """Author, licence and version, as far as they are known: those of the library for its classes."""
    package = ode.interface.model.split(".")[0]
    version = dict(ode.libraries).get(package)
    attributes = {"version": version} if version else {}
    if package not in {folder.name for folder in modelica_root().iterdir()}:
        return attributes
    try:
        of = metadata(TOOL)
    except PackageNotFoundError:
        return attributes
    author, licence = str(of["Author"]), str(of["License-Expression"])
    return {"author": author, "license": licence, "copyright": f"(c) {author}", **attributes}


def date() -> str:
    """The present time, or that of ``SOURCE_DATE_EPOCH``, as FMI writes it."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    time = datetime.fromtimestamp(int(epoch), UTC) if epoch.isdigit() else datetime.now(UTC)
    return time.strftime("%Y-%m-%dT%H:%M:%SZ")
