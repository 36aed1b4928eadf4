"""FMPy's interface to an instance, for both versions of FMI and both kinds."""

from __future__ import annotations

from ctypes import c_char_p, c_int
from functools import cache
from pathlib import Path
from types import UnionType
from typing import Any, TypeAlias, get_args

from fmpy.fmi2 import FMU2Model, FMU2Slave, fmi2CallbackFunctions
from fmpy.fmi3 import FMU3Model, FMU3Slave

from pam_cosim.simulation.driver import Callbacks

_Prototypes: TypeAlias = dict[str, tuple[list[str], list[Any], Any]]


class _FmpyInstance:
    """What all of them have.

    FMPy reads the types of FMI functions from its own signatures for each library; once for a class will do.
    """

    version: int

    def _loadFunctions(self: Any) -> None:
        for name, (argnames, argtypes, restype) in _prototypes(type(self)).items():
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
