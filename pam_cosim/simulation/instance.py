"""FMPy's interface to an instance, for both versions of FMI and both kinds."""

from __future__ import annotations

import os
import shutil
import zipfile
from ctypes import c_char_p, c_int
from functools import cache
from pathlib import Path
from types import UnionType
from typing import Any, TypeAlias, get_args

import fmpy
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.model_description import ModelDescription

from pam_cosim.errors import InputError
from pam_cosim.fmu.platforms import PLATFORMS, native_platform
from pam_cosim.fmu.read import DAMAGED, TABLES, fmi_version
from pam_cosim.simulation.driver import Callbacks
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.wording import shown

Instance: TypeAlias = (
    Any  # FMU2Slave | FMU3Slave | FMU2Model | FMU3Model, of a package without types
)


_Prototypes: TypeAlias = dict[str, tuple[list[str], list[Any], Any]]


class _TypedOnce:
    """FMPy reads the types of FMI functions from its own signatures for each library; once for a class will do."""

    def _loadFunctions(self: Any) -> None:
        for name, (argnames, argtypes, restype) in _prototypes(type(self)).items():
            function = getattr(self.dll, name)
            function.argnames, function.argtypes = argnames, argtypes
            function.restype = restype
            self._functions[name] = function


@cache
def _prototypes(kind: type) -> _Prototypes:
    """As FMPy has them: names and types of arguments, and the type of the result, of the annotations of its methods."""
    found: _Prototypes = {}
    for name in dir(kind):
        if name.startswith(("fmi2", "fmi3")):
            types = dict(getattr(kind, name).__annotations__)
            result = types.pop("return")
            arguments = [get_args(t)[0] if isinstance(t, UnionType) else t for t in types.values()]
            found[name] = [*types], arguments, {bytes: c_char_p, int: c_int}.get(result, result)
    return found


# By major version of FMI, and whether it is for model exchange.
_CLASSES = {
    (version, exchange): type(f"{face.__name__}TypedOnce", (_TypedOnce, face), {})
    for (version, exchange), face in {
        ("2.0", False): FMU2Slave,
        ("2.0", True): FMU2Model,
        ("3.0", False): FMU3Slave,
        ("3.0", True): FMU3Model,
    }.items()
}


def load_instance(
    path: Path, description: ModelDescription, directory: str | None, *, exchange: bool = False
) -> Instance:
    """Unpacks an FMU and loads its binary; no instance yet.

    Args:
        path: of the FMU, or of the folder that holds its files.
        description: of its model.
        directory: where it is unpacked; None: it is.
        exchange: for model exchange, not co-simulation.

    Raises:
        InputError: there is no binary for this machine, or it cannot be loaded.
    """
    if directory is None:
        directory = os.path.abspath(path)
    else:
        try:
            _extract(path, Path(directory))
        except (*DAMAGED, OSError) as problem:  # a file and a folder of one name, among others
            reason = getattr(problem, "strerror", None) or problem
            raise InputError(f"the archive cannot be unpacked: {reason}", path) from None
    identifier = (
        description.modelExchange if exchange else description.coSimulation
    ).modelIdentifier
    version = fmi_version(description)
    library = _library(Path(directory), identifier, version, path)
    arguments = {
        "guid": description.guid,
        "unzipDirectory": directory,
        "modelIdentifier": identifier,
        "instanceName": "instance",
    }
    folder = os.getcwd()
    try:
        if version == "2.0":
            arguments["libraryPath"] = str(library)
        instance = _CLASSES[version, exchange](**arguments)
        if (Path(directory) / TABLES).exists():  # a model as data
            from pam_cosim.simulation.tape import use_tapes

            use_tapes(instance.dll, Path(directory))
        return instance
    except Exception as error:  # fmpy raises bare Exceptions
        raise InputError(f"the FMU cannot be loaded on this machine: {error}", path) from error
    finally:
        os.chdir(folder)  # FMPy goes to the library's folder and stays there when loading fails


def _extract(path: Path, directory: Path) -> None:
    """Unpacks what is for running; names were looked at by ``read_description``, and may have backslashes."""
    with zipfile.ZipFile(path) as archive:
        for entry in archive.infolist():
            name = entry.filename.replace("\\", "/")
            if name.startswith(("sources/", "documentation/")):
                continue
            target = directory / name
            if name.endswith("/"):
                target.mkdir(parents=True, exist_ok=True)
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            with archive.open(entry) as source, target.open("wb") as file:
                shutil.copyfileobj(source, file)


def _library(directory: Path, identifier: str, version: str, path: Path) -> Path:
    """The binary for this machine: in the directory of this platform's own, or in that which FMI names.

    Raises:
        InputError: there is none.
    """
    platform, binaries = PLATFORMS[native_platform()], directory / "binaries"
    folders = (platform.folder, fmpy.platform) if version == "2.0" else (platform.tuple,)
    files = [binaries / folder / f"{identifier}{platform.suffix}" for folder in folders]
    for file in files:
        if file.exists():
            return file
    there = sorted(f"{f.parent.name}/{f.name}" for f in binaries.glob("*/*") if f.is_file())
    held = f"it has {', '.join(map(shown, there))}" if there else "it has none at all"
    raise InputError(
        f"the FMU has no binary for this machine, {files[0].relative_to(directory)}; {held}", path
    )


def instantiate(instance: Instance, callbacks: Callbacks, file: str) -> None:
    """Makes an instance that reports to ``callbacks``; where the FMU refuses, its library is freed.

    Raises:
        SimulationFailure: (``RunFailure``) the FMU refuses; ``file`` names it.
    """
    try:
        if major_version(instance) == 3:
            instance.instantiate(loggingOn=True, logMessage=callbacks.note)
        else:
            instance.instantiate(callbacks=callbacks.functions, loggingOn=True)
    except Exception as error:  # fmpy raises bare Exceptions
        messages = " ".join(callbacks.take_messages()) or str(error)
        instance.freeLibrary()
        raise RunFailure(f"{file} cannot be instantiated: {messages}") from error


def free_instance(instance: Instance) -> None:
    """Frees the instance and keeps the library loaded."""
    free = instance.fmi3FreeInstance if major_version(instance) == 3 else instance.fmi2FreeInstance
    free(instance.component)


def major_version(instance: Instance) -> int:
    """Of FMI: 2 or 3."""
    return 3 if isinstance(instance, (FMU3Slave, FMU3Model)) else 2


def takes_slopes(description: ModelDescription, instance: Instance) -> bool:
    """Whether inputs may be given with their slopes: by FMI 2.0, or by our own FMUs in addition to FMI 3.0."""
    if isinstance(instance, FMU3Slave):
        return hasattr(instance.dll, "pam_set_input_slopes")
    return bool(description.coSimulation.canInterpolateInputs)
