"""FMPy's interface to a co-simulation instance, for both versions of FMI."""

from __future__ import annotations

from pathlib import Path
from typing import Any, TypeAlias

from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.model_description import ModelDescription

from pam_cosim.fmu.compile import PLATFORMS, native_platform
from pam_cosim.fmu.read import fmi_version
from pam_cosim.simulation.driver import Callbacks

Instance: TypeAlias = Any  # FMU2Slave | FMU3Slave, of a package without types


def load_instance(description: ModelDescription, directory: str) -> Instance:
    """Loads the binary of an unpacked FMU; no instance yet.

    Raises:
        Exception: FMPy's own, where there is no binary for this machine or it cannot be loaded.
    """
    identifier = description.coSimulation.modelIdentifier
    arguments = {
        "guid": description.guid,
        "unzipDirectory": directory,
        "modelIdentifier": identifier,
        "instanceName": "instance",
    }
    if fmi_version(description) == "3.0":
        return FMU3Slave(**arguments)
    return FMU2Slave(**arguments, libraryPath=own_library(directory, identifier))


def own_library(directory: str, identifier: str) -> str | None:
    """The binary in a directory of this platform's own; None: FMPy's choice, in the directory that FMI names."""
    own = PLATFORMS[native_platform()]
    path = Path(directory, "binaries", own.folder, f"{identifier}{own.suffix}")
    return str(path) if path.exists() else None


def instantiate(instance: Instance, callbacks: Callbacks) -> None:
    """Makes an instance that reports to ``callbacks``.

    Raises:
        Exception: FMPy's own, where the FMU refuses.
    """
    if isinstance(instance, FMU3Slave):
        instance.instantiate(loggingOn=True, logMessage=callbacks.note)
    else:
        instance.instantiate(callbacks=callbacks.functions)


def free_instance(instance: Instance) -> None:
    """Frees the instance and keeps the library loaded."""
    free = instance.fmi3FreeInstance if isinstance(instance, FMU3Slave) else instance.fmi2FreeInstance
    free(instance.component)


def major_version(instance: Instance) -> int:
    """Of FMI: 2 or 3."""
    return 3 if isinstance(instance, FMU3Slave) else 2


def takes_slopes(description: ModelDescription, instance: Instance) -> bool:
    """Whether inputs may be given with their slopes: by FMI 2.0, or by our own FMUs beside FMI 3.0."""
    if isinstance(instance, FMU3Slave):
        return hasattr(instance.dll, "pam_set_input_slopes")
    return bool(description.coSimulation.canInterpolateInputs)
