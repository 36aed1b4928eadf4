"""Libraries of FMUs and their instances: FMPy's, and one without FMPy for co-simulation of our own FMUs."""

from __future__ import annotations

import ctypes
import os
import shutil
import sys
import zipfile
from pathlib import Path
from typing import Any, TypeAlias

from pam_cosim.errors import InputError
from pam_cosim.fmu.description_file import ModelDescription
from pam_cosim.fmu.platforms import PLATFORMS, native_platform
from pam_cosim.fmu.read import DAMAGED, TABLES, fmi_version, is_own
from pam_cosim.simulation.driver import Callbacks
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.wording import shown

Instance: TypeAlias = Any  # OwnInstance, or one of FMPy's, whose package has no types

_CO_SIMULATION = 1  # fmi2Type
_WORST = 1  # status of FMI: a warning
_VP, _TEXT, _INT = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int
_Log = ctypes.CFUNCTYPE(None, _VP, _INT, _TEXT, _TEXT)  # fmi3LogMessageCallback


class OwnInstance:
    """An FMU of our own for co-simulation, whose runs are made in C: Python loads it, makes the instance and frees it.

    Args:
        library: its binary.
        folder: where it was unpacked.
        identifier: of the model.
        guid: of the FMU.
        version: major, of FMI.

    Attributes:
        dll: the library, loaded.
        component: its fmi2Component or fmi3Instance.

    Raises:
        OSError: the library cannot be loaded.
    """

    def __init__(
        self, library: Path, folder: str, identifier: str, guid: str | None, version: int
    ) -> None:
        self.version, self.component = version, None
        self._library, self._folder = library, folder
        self._with_steps: Instance = None
        self._identifier, self._guid = identifier, guid
        self.dll = ctypes.CDLL(str(library))

    def begin(self, callbacks: Callbacks) -> None:
        """Makes the instance in the library.

        Raises:
            RuntimeError: the library refuses.
        """
        name, guid = b"instance", str(self._guid).encode()
        resources = Path(self._folder, "resources")
        if self.version == 2:
            make = self.dll.fmi2Instantiate
            make.argtypes, make.restype = [_TEXT, _INT, _TEXT, _TEXT, _VP, _INT, _INT], _VP
            functions = ctypes.addressof(callbacks.functions)
            self.component = make(
                name, _CO_SIMULATION, guid, resources.as_uri().encode(), functions, False, True
            )
        else:
            make, flags = self.dll.fmi3InstantiateCoSimulation, [ctypes.c_bool] * 4
            make.argtypes = [*[_TEXT] * 3, *flags, _VP, ctypes.c_size_t, _VP, _Log, _VP]
            make.restype = _VP
            self._log = _Log(callbacks.note)  # must outlive the instance
            folder = f"{resources}{os.sep}".encode()
            self.component = make(
                name, guid, folder, False, True, False, False, None, 0, None, self._log, None
            )
        if not self.component:
            raise RuntimeError("Failed to instantiate model")

    def with_steps(self) -> Instance:
        """FMPy's interface to this instance, for a run step by step."""
        if self._with_steps is None:
            from pam_cosim.simulation.fmpy_instance import fmpy_instance

            arguments = self._library, self._folder, self._identifier, self._guid, self.version
            self._with_steps = fmpy_instance(*arguments, exchange=False)
            self._with_steps.freeLibrary()  # loaded twice; this instance frees it at its end
        self._with_steps.component = self.component
        return self._with_steps

    def freeInstance(self) -> None:
        """Frees the instance and its library."""
        free_instance(self)
        self.freeLibrary()

    def freeLibrary(self) -> None:
        """Unloads the library."""
        if sys.platform == "win32":
            from _ctypes import FreeLibrary as unload
        else:
            from _ctypes import dlclose as unload

        unload(self.dll._handle)


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
    kind = description.modelExchange if exchange else description.coSimulation
    assert kind is not None
    identifier = str(kind.modelIdentifier)
    version = 2 if fmi_version(description) == "2.0" else 3
    library = _library(Path(directory), identifier, version, path)
    arguments = library, directory, identifier, description.guid, version
    folder = os.getcwd()
    try:
        if is_own(description) and not exchange:
            instance: Instance = OwnInstance(*arguments)
        else:
            from pam_cosim.simulation.fmpy_instance import fmpy_instance

            instance = fmpy_instance(*arguments, exchange=exchange)
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


def _library(directory: Path, identifier: str, version: int, path: Path) -> Path:
    """The binary for this machine: in the directory of this platform's own, or in that which FMI names.

    Raises:
        InputError: there is none.
    """
    platform, binaries = PLATFORMS[native_platform()], directory / "binaries"
    folders = [platform.folder if version == 2 else platform.tuple]
    if version == 2 and not (binaries / folders[0]).exists():
        import fmpy

        folders.append(fmpy.platform)
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
        instance.begin(callbacks)
    except Exception as error:  # fmpy raises bare Exceptions
        messages = " ".join(callbacks.take_messages()) or str(error)
        instance.freeLibrary()
        raise RunFailure(f"{file} cannot be instantiated: {messages}") from error


def free_instance(instance: Instance) -> None:
    """Frees the instance and keeps the library loaded."""
    free = getattr(instance.dll, f"fmi{instance.version}FreeInstance")
    free.restype = None
    free(_VP(instance.component))


def reset_instance(instance: Instance) -> bool:
    """Whether the instance could be reset."""
    reset = getattr(instance.dll, f"fmi{instance.version}Reset")
    return bool(reset(_VP(instance.component)) <= _WORST)


def major_version(instance: Instance) -> int:
    """Of FMI: 2 or 3."""
    return int(instance.version)


def takes_slopes(description: ModelDescription, instance: Instance) -> bool:
    """Whether inputs may be given with their slopes: by FMI 2.0, or by our own FMUs in addition to FMI 3.0."""
    if instance.version == 3:
        return hasattr(instance.dll, "pam_set_input_slopes")
    return description.coSimulation is not None and description.coSimulation.canInterpolateInputs
