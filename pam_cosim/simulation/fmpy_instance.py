"""FMPy's interface to an instance, for both versions of FMI and both kinds."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from fmpy.fmi2 import FMU2Model, FMU2Slave, fmi2CallbackFunctions
from fmpy.fmi3 import FMU3Model, FMU3Slave

from pam_cosim.simulation.driver import Callbacks


class _FmpyInstance:
    """What all of them have.

    FMPy reads the types of FMI functions from its own signatures for each library; once for a class will do.
    """

    version: int

    def _loadFunctions(self: Any) -> None:
        kind = type(self)
        if kind not in _PROTOTYPES:
            super()._loadFunctions()  # type: ignore[misc]
            _PROTOTYPES[kind] = {
                name: (f.argnames, f.argtypes, f.restype) for name, f in self._functions.items()
            }
            return
        for name, (argnames, argtypes, restype) in _PROTOTYPES[kind].items():
            function = getattr(self.dll, name)
            function.argnames, function.argtypes = argnames, argtypes
            function.restype = restype
            self._functions[name] = function

    def begin(self: Any, callbacks: Callbacks) -> None:
        """Makes the instance in the library."""
        if self.version == 3:
            self.instantiate(loggingOn=True, logMessage=callbacks.note)
        else:
            functions = fmi2CallbackFunctions.from_buffer(callbacks.functions)
            self.instantiate(callbacks=functions, loggingOn=True)


_PROTOTYPES: dict[type, dict[str, tuple[list[str], list[Any], Any]]] = {}
# By major version of FMI, and whether it is for model exchange.
_CLASSES: dict[tuple[int, bool], Any] = {
    (version, exchange): type(
        f"{face.__name__}Instance", (_FmpyInstance, face), {"version": version}
    )
    for (version, exchange), face in {
        (2, False): FMU2Slave,
        (2, True): FMU2Model,
        (3, False): FMU3Slave,
        (3, True): FMU3Model,
    }.items()
}


def fmpy_instance(
    library: Path, folder: str, identifier: str, guid: str | None, version: int, *, exchange: bool
) -> Any:
    """Loads a library; no instance yet.

    Args:
        library: the binary.
        folder: where the FMU was unpacked.
        identifier: of the model. guid: of the FMU. version: major, of FMI.
        exchange: for model exchange, not co-simulation.
    """
    return _CLASSES[version, exchange](
        guid=guid,
        unzipDirectory=folder,
        modelIdentifier=identifier,
        instanceName="instance",
        libraryPath=str(library),
    )
